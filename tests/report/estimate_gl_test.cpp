#include <catch2/catch.hpp>

#include "report/estimate.hpp"
#include "support/picture.hpp"

using namespace facet;
using report::ConvergencePoint, report::EstimateMeasure, report::EstimateRow;

TEST_CASE("estimate: what --max-error states, the truth and the oracle's samples", "[gl]") {
  test::GltfBuilder builder = test::emptyScene();
  test::addMeshNode(builder, test::addSphere(builder, 0.5, 48, 96),
                    builder.append("materials", test::material({0.9, 0.6, 0.4, 1}, 1, 0.4)), test::at(0, 0, 0));
  test::addOrthographicCamera(builder, 0.6, 0.6);
  const io::LoadedModel model = test::loadBuilt(builder);
  test::Studio studio;
  studio.estimate = true, studio.display = false;
  frame::LoadedScene scene = test::sceneOf(model);
  frame::PictureSettings settings = test::bareSettings(32, 32);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:studio";
  settings.quality.transport = GENERATE(frame::Transport::direct, frame::Transport::paths);
  const auto measured = report::measureEstimate(
      settings, {.errors = {0.05, 0.02, 0.0005}, .most = 128, .reference = 256},
      [&](const frame::PictureSettings& wanted) { return Result<frame::Picture>(studio.render(scene, wanted)); });
  REQUIRE(measured);
  const EstimateMeasure& m = *measured;
  REQUIRE(m.points.size() == 5);  // 8 ... 128
  for (const ConvergencePoint& p : m.points) {
    INFO(p.samples << " samples: stated " << p.stated.most / 255 << ", true " << p.truth);
    CHECK(p.stated.most / 255 > 0.8 * p.truth);
    CHECK(p.stated.most / 255 < 1.8 * p.truth);
  }
  CHECK(m.points.back().truth < 0.4 * m.points.front().truth);
  REQUIRE(m.rows.size() == 3);
  for (const EstimateRow& row : m.rows) {
    INFO(row.wanted << ": " << row.samples << " samples, stated " << row.stated << ", true " << row.truth);
    CHECK(row.drawn >= row.samples);
    CHECK(row.reached == (row.stated <= row.wanted));
    if (row.reached) CHECK(row.truth <= 1.1 * row.wanted);
    if (row.oracle) CHECK(*row.oracle <= row.samples);
  }
  CHECK(m.rows[0].reached);
  CHECK_FALSE(m.rows[2].reached);
  CHECK_FALSE(m.rows[2].oracle);
  CHECK(m.rows[2].samples == 128);
}
