#include "view/panel_layout.hpp"

#include <catch2/catch.hpp>

using namespace facet;
using view::Side;

TEST_CASE("panel layout: sides become narrower, then one of them folds, and what is wished stays") {
  constexpr float em = 14;
  view::PanelLayout wished;
  const auto at = [&](float width) { return view::sideWidths(wished, true, true, width, em); };
  CHECK(at(1280).left == 18 * em);
  CHECK(at(1280).right == 21 * em);
  CHECK_FALSE(at(1280).folded);

  const view::SideWidths narrower = at(760);
  CHECK_FALSE(narrower.folded);
  CHECK(narrower.left < 18 * em);
  CHECK(760 - narrower.left - narrower.right == Approx(20 * em));

  const view::SideWidths one = at(640);
  CHECK(one.folded == Side::left);
  CHECK(one.left == Approx(view::foldedEms * em));
  CHECK(one.right == 21 * em);
  CHECK(640 - one.left - one.right > 20 * em);
  wished.last = Side::left;
  CHECK(at(640).folded == Side::right);
  CHECK(at(640).left == 18 * em);

  // Over the picture rather than too narrow to be read; never wider than the window.
  wished.last = Side::right;
  CHECK(at(300).right == view::leastRightEms * em);
  for (const float width : {1.0f, 20.0f, 100.0f, 240.0f, 500.0f, 630.0f, 5000.0f}) {
    INFO(width);
    CHECK(at(width).left + at(width).right <= width);
    if (width > 300) CHECK(at(width).right >= view::leastRightEms * em);
    CHECK(view::sideWidths(wished, false, true, width, em).left == 0);
    CHECK(view::sideWidths(wished, true, false, width, em).right == 0);
  }

  // What was dragged wide stays below what the picture needs, and comes back.
  wished.leftEms = 60;
  CHECK(1280 - at(1280).left - at(1280).right == Approx(20 * em));
  CHECK(at(2560).left == 60 * em);
}
