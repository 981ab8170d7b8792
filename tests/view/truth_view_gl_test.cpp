#include <catch2/catch.hpp>
#include <cmath>

#include "view/truth_view.hpp"
#include "view/viewer.hpp"

using namespace facet;
using test::Viewer;
using view::Beside;

namespace {

std::vector<glm::dvec3> truthPixels(const gl::Texture& picture) {
  std::vector<glm::dvec3> pixels;
  for (const glm::dvec4& texel : test::texelsOf(picture)) pixels.push_back(255.0 * glm::dvec3(texel));
  return pixels;
}

glm::dvec3 pixelOf(const io::Pixels& picture, size_t i) {
  return {picture.data[3 * i], picture.data[3 * i + 1], picture.data[3 * i + 2]};
}

}  // namespace

TEST_CASE("against truth: the fast picture beside the traced one, and what they differ by", "[gl]") {
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.quality.samples = 64;
  settings.sources.environment = "builtin:studio";
  viewer.load("builtin:spheres");
  view::drawViewport(viewer.viewport, viewer.state);
  const io::Pixels fast = viewer.display();
  viewer.converge();
  const io::Pixels traced = viewer.display();
  CHECK_FALSE(viewer.viewport.truthView.fast);  // nothing of it is there

  viewer.state.truth = {Beside::split, 0.25f, 4};
  viewer.converge();
  const view::TruthView& truth = viewer.viewport.truthView;
  REQUIRE(truth.pair.shown);
  CHECK(viewer.state.shown.fastMethod == "drawn, screen space");
  CHECK(viewer.state.shown.truthMethod == "path traced");
  CHECK((viewer.display().data == traced.data));  // the picture stays as it is
  const std::vector<glm::dvec3> split = truthPixels(truth.pair.picture);
  double wrong = 0, squares = 0, differing = 0, largest = 0;
  for (size_t i = 0; i < split.size(); ++i) {
    const bool left = i % static_cast<size_t>(fast.width) < static_cast<size_t>(fast.width) / 4;
    wrong = std::max(wrong, glm::distance(split[i], pixelOf(left ? fast : traced, i)));
    const glm::dvec3 apart = glm::abs(pixelOf(fast, i) - pixelOf(traced, i));
    squares += glm::dot(apart, apart);
    differing += apart != glm::dvec3(0);
    largest = std::max({largest, apart.x, apart.y, apart.z});
  }
  CHECK(wrong < 1e-3);
  REQUIRE(viewer.state.shown.comparison);
  const frame::ComparisonFigures figures = *viewer.state.shown.comparison;
  CHECK(figures.rms == Approx(std::sqrt(squares / (3 * differing))).epsilon(1e-3));
  CHECK(figures.rms > 2);  // spheres stand in each other's light
  CHECK(figures.share == Approx(differing / double(split.size())));
  CHECK(figures.largest == Approx(largest).margin(0.01));

  // How it is looked at asks for no new picture.
  viewer.state.truth = {Beside::difference, 0.5f, 3};
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK_FALSE(view::atWork(viewer.viewport, viewer.state));
  const std::vector<glm::dvec3> difference = truthPixels(truth.pair.picture);
  wrong = 0;
  for (size_t i = 0; i < difference.size(); ++i) {
    const glm::dvec3 apart = glm::min(3.0 * glm::abs(pixelOf(fast, i) - pixelOf(traced, i)), 255.0);
    wrong = std::max(wrong, glm::distance(difference[i], apart));
  }
  CHECK(wrong < 0.1);

  // What changes takes it away until it rests again.
  viewer.state.camera.theta += 0.3;
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK_FALSE(truth.pair.shown);
  CHECK(viewer.state.shown.fastMethod.empty());
  CHECK_FALSE(viewer.state.shown.comparison);
  viewer.converge();
  CHECK(truth.pair.shown);

  viewer.state.truth.how = Beside::off;
  viewer.converge();
  CHECK_FALSE(truth.pair.shown);
  CHECK_FALSE(truth.fast);
  CHECK_FALSE(viewer.state.shown.comparison);
}

TEST_CASE("against truth: whatever the settings ask for, the other picture is traced and has samples enough", "[gl]") {
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.quality.samples = 4;
  settings.quality.visibility = frame::Visibility::none;
  settings.sources.environment = "builtin:studio";
  viewer.load("builtin:marbles");
  viewer.converge();
  const io::Pixels alone = viewer.display();
  CHECK_FALSE(viewer.viewport.shown.paths);

  viewer.state.truth.how = Beside::split;
  viewer.state.truth.split = 1;
  viewer.converge();
  REQUIRE(viewer.viewport.truthView.pair.shown);
  CHECK(viewer.state.shown.fastMethod == "drawn, nothing in the way");
  CHECK(viewer.state.refinement.shown == view::fewestTruthSamples);
  const double blocked = viewer.state.shown.comparison.value().rms;
  CHECK(blocked > 3);
  const std::vector<glm::dvec3> fast = truthPixels(viewer.viewport.truthView.pair.picture);
  double wrong = 0;
  for (size_t i = 0; i < fast.size(); ++i) wrong = std::max(wrong, glm::distance(fast[i], pixelOf(alone, i)));
  CHECK(wrong < 1e-3);
  // The command that is copied makes the picture that a screenshot would hold.
  CHECK(view::commandSettings(viewer.state).quality.samples == view::fewestTruthSamples);
  CHECK(view::commandSettings(viewer.state).quality.visibility == frame::Visibility::automatic);

  // Shadow maps and horizons are nearer to it.
  settings.quality.visibility = frame::Visibility::screen;
  viewer.settle();
  viewer.converge();
  REQUIRE(viewer.viewport.truthView.pair.shown);
  CHECK(viewer.state.shown.comparison.value().rms < blocked);

  // Of a channel there is nothing to be compared with.
  settings.look.channel = "normal";
  viewer.settle();
  viewer.converge();
  CHECK_FALSE(viewer.viewport.truthView.pair.shown);
  settings.look.channel.clear();
  viewer.state.truth.how = Beside::off;
  settings.quality.visibility = frame::Visibility::none;
  viewer.settle();
  viewer.converge();
  CHECK((viewer.display().data == alone.data));
}
