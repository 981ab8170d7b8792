#include <catch2/catch.hpp>

#include "frame/settings.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

// A quad of 1 m x 0.5 m in the plane z = 0, around the origin.
io::LoadedModel quadModel(bool shines) {
  test::GltfBuilder builder = test::emptyScene();
  builder.append("materials", shines ? test::unlit({1, 1, 1, 1}) : test::material({1, 1, 1, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-0.5f, -0.25f}, {0.5f, 0.25f}), 0);
  test::addOrthographicCamera(builder, 1, 1);
  return test::loadBuilt(builder);
}

struct Covered {
  glm::ivec2 low = glm::ivec2(9999), high = glm::ivec2(-1);
  glm::ivec2 size() const { return high - low + 1; }
};
Covered coveredBy(const io::RadianceImage& image) {
  Covered covered;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      if (test::pixel(image, x, y).w > 0.5f)
        covered.low = glm::min(covered.low, {x, y}), covered.high = glm::max(covered.high, {x, y});
  return covered;
}

frame::PictureSettings orthographic(int width, int height, double metresHigh) {
  frame::PictureSettings settings = test::bareSettings(width, height);
  settings.viewpoint.orbit = frame::Orbit{0, 90, {}}, settings.viewpoint.target = glm::dvec3(0);
  settings.viewpoint.projection = frame::Projection::orthographic, settings.viewpoint.viewHeight = metresHigh;
  return settings;
}

}  // namespace

TEST_CASE("Orthographic: a quad is as large in the picture as it is in metres, however it is drawn") {
  const io::LoadedModel model = quadModel(true);
  test::Studio studio;
  const auto sizeOf = [&](frame::PictureSettings settings, frame::Transport transport) {
    settings.quality.transport = transport;
    if (transport == frame::Transport::paths) settings.quality.samples = 9;
    return coveredBy(studio.render(model, settings).radiance).size();
  };
  for (const frame::Transport transport : {frame::Transport::direct, frame::Transport::paths}) {
    INFO("transport " << static_cast<int>(transport));
    // 2 m are 64 pixels high: 32 pixels a metre.
    frame::PictureSettings settings = orthographic(96, 64, 2);
    CHECK(sizeOf(settings, transport) == glm::ivec2(32, 16));
    settings.viewpoint.fovYDeg = 120;  // says nothing here
    CHECK(sizeOf(settings, transport) == glm::ivec2(32, 16));
    settings.viewpoint.rollDeg = 90;
    CHECK(sizeOf(settings, transport) == glm::ivec2(16, 32));
    settings.viewpoint.rollDeg = 0;
    settings.viewpoint.target = glm::dvec3(0, 0, -70);  // the eye is behind the quad, which is seen all the same
    CHECK(sizeOf(settings, transport) == glm::ivec2(32, 16));
    settings.viewpoint.target = glm::dvec3(0.25, 0, 3);
    CHECK(sizeOf(settings, transport) == glm::ivec2(32, 16));
    settings = orthographic(64, 64, 2);
    settings.viewpoint.orbit = frame::Orbit{60, 90, {}};  // half as wide
    CHECK(sizeOf(settings, transport) == glm::ivec2(16, 16));
    settings = orthographic(64, 64, 2);
    settings.viewpoint.up = {0, 0, 1}, settings.viewpoint.orbit = frame::Orbit{0, 0, {}};  // from above: +Z
    CHECK(sizeOf(settings, transport) == glm::ivec2(32, 16));
  }
  // An orbit's radius says as much: 2 radius tan(fov / 2).
  frame::PictureSettings settings = orthographic(64, 64, 2);
  settings.viewpoint.viewHeight.reset();
  settings.viewpoint.orbit = frame::Orbit{0, 90, 5},
  settings.viewpoint.fovYDeg = 2 * 180 / 3.14159265358979323846 * std::atan(0.2);
  CHECK(sizeOf(settings, frame::Transport::direct) == glm::ivec2(32, 16));
}

TEST_CASE("Orthographic: an orbit sees what a camera of the file sees from there, with all that is drawn") {
  const io::LoadedModel model = quadModel(false);
  test::Studio studio;
  struct Case {
    const char* name;
    void (*set)(frame::PictureSettings&);
  };
  const Case c = GENERATE(values<Case>({
      {"drawn", [](frame::PictureSettings&) {}},
      {"shadow maps", [](frame::PictureSettings& s) { s.quality.visibility = frame::Visibility::screen; }},
      {"rays", [](frame::PictureSettings& s) { s.quality.visibility = frame::Visibility::rays; }},
      {"paths",
       [](frame::PictureSettings& s) { s.quality.samples = 9, s.quality.transport = frame::Transport::paths; }},
      {"environment behind", [](frame::PictureSettings& s) { s.frame.background = frame::Background::environment; }},
      {"a channel", [](frame::PictureSettings& s) { s.look.channel = "normal"; }},
  }));
  INFO(c.name);
  frame::PictureSettings settings = test::bareSettings(48, 48);
  settings.sources.environment = "builtin:sky", settings.look.lights = frame::Lights::demo;
  c.set(settings);
  frame::PictureSettings file = settings;
  file.viewpoint.camera = "0";  // from z = 10, 2 m high
  settings.viewpoint = orthographic(48, 48, 2).viewpoint;
  const frame::Picture orbit = studio.render(model, settings), own = studio.render(model, file);
  float largest = 0;
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 48; ++x)
      for (int i = 0; i < 4; ++i)
        largest =
            std::max(largest, std::abs(test::pixel(orbit.radiance, x, y)[i] - test::pixel(own.radiance, x, y)[i]));
  CHECK(largest < 0.004f);
  CHECK(test::pixel(orbit.radiance, 24, 24).w == 1);
}
