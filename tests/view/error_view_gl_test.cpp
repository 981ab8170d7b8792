#include <catch2/catch.hpp>
#include <cmath>

#include "support/picture.hpp"
#include "view/error_view.hpp"
#include "view/viewer.hpp"

using namespace facet;
using test::Viewer;

namespace {

// What a colour of the view stands for, in 1/255: the nearest place on the scale.
double errorOf(const glm::dvec3& color) {
  double best = 0, least = 1e9;
  constexpr int steps = 400;
  for (int i = 0; i <= steps; ++i) {
    const double place = double(i) / steps * (layout::errorStopCount - 1);
    const int first = std::min(static_cast<int>(place), layout::errorStopCount - 2);
    const glm::dvec3 there =
        glm::mix(glm::dvec3(view::errorStops[first]), glm::dvec3(view::errorStops[first + 1]), place - first);
    if (const double off = glm::distance(there, color); off < least) least = off, best = double(i) / steps;
  }
  CHECK(least < 0.01);
  return view::leastError * std::pow(view::largestError / view::leastError, best);
}

std::vector<double> errorsShown(const Viewer& viewer) {
  std::vector<double> errors;
  for (const glm::dvec4& texel : test::texelsOf(viewer.viewport.errorView.picture))
    errors.push_back(errorOf(glm::dvec3(texel)));
  return errors;
}

}  // namespace

TEST_CASE("error view: what it shows is what pictures of other seeds differ by", "[gl]") {
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.quality.samples = 32;
  settings.sources.environment = "builtin:studio";
  viewer.load("builtin:spheres");
  viewer.converge();
  CHECK_FALSE(viewer.viewport.errorView.shown);
  CHECK_FALSE(viewer.viewport.refinement.targets.contrasts);
  const io::Pixels without = viewer.display();

  viewer.state.errorsShown = true;
  viewer.converge();
  REQUIRE(viewer.viewport.errorView.shown);
  CHECK(viewer.viewport.errorView.contrasts == 2);
  CHECK((viewer.display().data == without.data));  // the picture stays as it is
  const std::vector<double> shown = errorsShown(viewer);

  // Each pixel's deviation over seeds, in the channel that deviates most, as the view has it.
  constexpr int seeds = 12;
  std::vector<glm::dvec3> sum(shown.size()), squares(shown.size());
  viewer.state.errorsShown = false;
  for (int seed = 1; seed <= seeds; ++seed) {
    settings.quality.seed = seed;
    viewer.converge();
    const io::Pixels pixels = viewer.display();
    for (size_t i = 0; i < shown.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        const double value = pixels.data[3 * i + static_cast<size_t>(c)];
        sum[i][c] += value, squares[i][c] += value * value;
      }
  }
  double shownSquares = 0, trueSquares = 0;
  size_t noisy = 0, both = 0;
  for (size_t i = 0; i < shown.size(); ++i) {
    double largest = 0;
    for (int c = 0; c < 3; ++c)
      largest = std::max(largest, (squares[i][c] - sum[i][c] * sum[i][c] / seeds) / (seeds - 1));
    shownSquares += shown[i] * shown[i], trueSquares += largest;
    if (largest > 9) ++noisy, both += shown[i] > 1 ? 1 : 0;
  }
  INFO("shown " << std::sqrt(shownSquares / double(shown.size())) << " true "
                << std::sqrt(trueSquares / double(shown.size())) << ", noisy " << noisy << ", of these told " << both);
  CHECK(std::sqrt(shownSquares / trueSquares) == Approx(1).margin(0.35));
  CHECK(noisy > 20);
  CHECK(double(both) > 0.85 * double(noisy));
}

TEST_CASE("error view: nothing of it where the picture does not converge or two are compared, and where it is put away",
          "[gl]") {
  Viewer viewer;
  viewer.state.settings.quality.samples = 4;
  viewer.state.errorsShown = true;
  viewer.load("builtin:spheres");
  viewer.converge();
  CHECK_FALSE(viewer.viewport.errorView.shown);
  viewer.state.settings.quality.samples = 32;
  viewer.converge();
  CHECK(viewer.viewport.errorView.shown);
  viewer.state.camera.theta += 0.1;  // the next picture's errors are not known yet
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK_FALSE(viewer.viewport.errorView.shown);
  viewer.state.settings.sources.brdf = "builtin:plastic-0.5";
  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::split;
  viewer.settle();
  viewer.converge();
  CHECK_FALSE(viewer.viewport.errorView.shown);
  CHECK_FALSE(viewer.viewport.refinement.targets.contrasts);
  viewer.state.settings.comparison.brdfCompare = frame::BrdfCompare::none;
  viewer.settle();
  viewer.converge();
  CHECK(viewer.viewport.errorView.shown);
  // Put away, it leaves the picture that has converged.
  viewer.state.errorsShown = false;
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.viewport.refinement.ended);
  CHECK_FALSE(viewer.viewport.errorView.picture);
  viewer.converge();
  CHECK_FALSE(viewer.viewport.errorView.shown);
  CHECK_FALSE(viewer.viewport.refinement.targets.contrasts);
}
