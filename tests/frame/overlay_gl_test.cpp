#include <catch2/catch.hpp>
#include <cmath>

#include "frame/overlay.hpp"
#include "frame/settings.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::Overlay, frame::PictureSettings;

namespace {

PictureSettings with(PictureSettings settings, std::initializer_list<Overlay> overlays) {
  for (const Overlay overlay : overlays) settings.overlays.shown |= frame::Overlays::bitOf(overlay);
  return settings;
}

glm::ivec3 colorAt(const frame::Picture& picture, int x, int y) {
  const size_t at = (static_cast<size_t>(y) * static_cast<size_t>(picture.display.width) + static_cast<size_t>(x)) *
                    static_cast<size_t>(picture.display.channels);
  return {picture.display.data[at], picture.display.data[at + 1], picture.display.data[at + 2]};
}

bool differs(const frame::Picture& a, const frame::Picture& b, int x, int y) {
  return glm::length(glm::dvec3(colorAt(a, x, y) - colorAt(b, x, y))) > 60;
}

// A white square of 2 m that fills the middle half of the picture.
test::GltfBuilder square() {
  test::GltfBuilder builder = test::emptyScene();
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                    builder.append("materials", test::unlit({1, 1, 1, 1})));
  test::addOrthographicCamera(builder, 2, 2);
  return builder;
}

}  // namespace

TEST_CASE("Overlays: a line is as wide as it says, and the picture below it stays", "[gl]") {
  const io::LoadedModel model = test::loadBuilt(square());
  test::Studio studio;
  PictureSettings settings = test::bareSettings(64, 64);
  settings.viewpoint.camera = "0";
  settings.frame.background = frame::Background::color;
  const frame::Picture without = studio.render(model, settings);
  const frame::Picture box = studio.render(model, with(settings, {Overlay::bounds}));
  CHECK(box.radiance.pixels == without.radiance.pixels);
  // The box's left edge is at x = 16: its parts and itself, 1.5 pixels wide.
  double covered = 0;
  for (int x = 10; x < 22; ++x)
    if (x < 16) covered += colorAt(box, x, 32).r / 255.0;  // over black
  CHECK(covered == Approx(0.75).margin(0.3));
  CHECK_FALSE(differs(box, without, 12, 32));
  CHECK_FALSE(differs(box, without, 24, 32));
  // Wireframe: the square's diagonal, and nothing beside it.
  const frame::Picture wire = studio.render(model, with(settings, {Overlay::wireframe}));
  const bool falling = differs(wire, without, 24, 24), rising = differs(wire, without, 24, 39);
  CHECK(falling != rising);
  CHECK_FALSE(differs(wire, without, 32, 22));
  // Quads at the picture's other end are not hidden by a depth of their own.
  CHECK(differs(wire, without, 32, 16));
}

TEST_CASE("Overlays: lines behind surfaces are hidden, drawn and path traced alike, in any size", "[gl]") {
  for (const double size : {1e-6, 1.0, 1e6}) {
    test::GltfBuilder builder = test::emptyScene();
    const int white = builder.append("materials", test::material({1, 1, 1, 1}));
    const nlohmann::json scale = {size, size, size};
    test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), white, {{"scale", scale}});
    test::addMeshNode(builder, test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5}), white,
                      {{"scale", scale}, {"translation", {0, 0, -0.5 * size}}});
    const io::LoadedModel model = test::loadBuilt(builder);
    test::Studio studio;
    PictureSettings settings = test::bareSettings(96, 96);
    settings.sources.environment = "builtin:white";
    settings.viewpoint.orbit = frame::Orbit{0, 90, 4 * size};
    settings.viewpoint.target = glm::dvec3(0);
    const auto dark = [&](const PictureSettings& s) {
      const frame::Picture picture = studio.render(model, s),
                           wire = studio.render(model, with(s, {Overlay::wireframe}));
      int inner = 0, outer = 0;
      for (int x = 0; x < 96; ++x) {
        const bool edge = differs(wire, picture, x, 42);
        (std::abs(x - 47.5) < 18 ? inner : outer) += edge;
      }
      return glm::ivec2(inner, outer);
    };
    INFO("scene of " << size << " m");
    // From the front: the diagonal of the large square, not those of the small one; both sides of the large one.
    const glm::ivec2 front = dark(settings);
    CHECK(front.x >= 1);
    CHECK(front.x <= 4);
    CHECK(front.y >= 2);
    settings.quality.transport = frame::Transport::paths;
    CHECK(dark(settings) == front);
  }
}

TEST_CASE("Overlays: over a transparent picture they cover, and off they cost nothing", "[gl]") {
  const io::LoadedModel model = test::loadBuilt(square());
  test::Studio studio;
  PictureSettings settings = test::bareSettings(64, 64);
  settings.viewpoint.camera = "0";
  const frame::Picture without = studio.render(model, settings);
  const frame::Picture axes = studio.render(model, with(settings, {Overlay::axes, Overlay::grid}));
  CHECK(axes.statistics.programsCompiled >= 1);
  CHECK(studio.render(model, settings).statistics.programsCompiled == 0);
  CHECK(studio.render(model, settings).display.data == without.display.data);
  REQUIRE(axes.display.channels == 4);
  const auto alphaAt = [](const frame::Picture& p, int x, int y) {
    return p.display.data[(static_cast<size_t>(y) * 64 + static_cast<size_t>(x)) * 4 + 3];
  };
  CHECK(alphaAt(without, 58, 32) == 0);
  CHECK(alphaAt(axes, 58, 32) > 200);  // along X, beyond the square
  CHECK(colorAt(axes, 58, 32).r > 200);
  CHECK(axes.statistics.gridSpacing.has_value());
  CHECK_FALSE(without.statistics.gridSpacing.has_value());
}
