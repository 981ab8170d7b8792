// Lights that shine by IES profiles, in drawn and in traced pictures, against the twin in double precision.

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/quaternion.hpp>

#include "base/angle.hpp"
#include "frame/draw_list.hpp"
#include "frame/path_scenes.hpp"
#include "optics/light_profile.hpp"
#include "support/picture.hpp"

namespace facet::test::profiled_lights {

namespace {

constexpr int size = 48;  // pixels; the camera sees [-2, 2]^2 of a quad in z = 0

struct Lamp {
  int type = 1;  // 1 C, 2 B, 3 A
  glm::dquat rotation = glm::dquat(1, 0, 0, 0);
  glm::dvec3 scale = glm::dvec3(1);
};

std::string profileText(int type) {
  if (type == 1)
    return "IESNA:LM-63-2002\nTILT=NONE\n1 1 1 5 3 1 2 0 0 0 1 1 1\n0 20 50 100 180\n0 70 180\n"
           "9 7 4 2 1  9 8 6 1 2  9 3 2 3 1\n";
  return "IESNA:LM-63-2002\nTILT=NONE\n1 1 1 4 3 " + std::to_string(type) +
         " 2 0 0 0 1 1 1\n-90 -20 30 90\n-90 10 90\n1 5 6 2  3 9 8 4  2 7 5 1\n";
}

// A Lambertian quad of albedo 0.5 under one light at (0.3, -0.2, 0.9), which its node turns to shine on it.
const glm::dvec3 place(0.3, -0.2, 0.9);
GltfBuilder lit() {
  GltfBuilder b = test::emptyScene();
  test::addMeshNode(b, test::addQuad(b, {-3, -3}, {3, 3}), b.append("materials", test::material({0.5, 0.5, 0.5, 1})));
  test::addOrthographicCamera(b, 2, 2);
  return b;
}
int addLightNode(GltfBuilder& b, nlohmann::json node) {
  node["translation"] = {place.x, place.y, place.z};
  const int index = b.append("nodes", std::move(node));
  b.json["scenes"][0]["nodes"].push_back(index);
  return index;
}
GltfBuilder litBy(const std::string& text, nlohmann::json light, const Lamp& lamp = {}) {
  GltfBuilder b = lit();
  b.json["extensionsUsed"].push_back("EXT_lights_ies");
  b.json["extensions"]["EXT_lights_ies"]["lights"] = {
      {{"uri", test::dataUri({reinterpret_cast<const uint8_t*>(text.data()), text.size()})}}};
  light["light"] = 0;
  const glm::dquat& q = lamp.rotation;
  addLightNode(b, {{"rotation", {q.x, q.y, q.z, q.w}},
                   {"scale", {lamp.scale.x, lamp.scale.y, lamp.scale.z}},
                   {"extensions", {{"EXT_lights_ies", std::move(light)}}}});
  return b;
}

io::LoadedModel load(const GltfBuilder& b) {
  io::LoadedModel model = test::loadBuilt(b);
  for (const Note& note : model.notes) INFO(note.text);
  CHECK(model.notes.empty());
  for (scene::Material& m : model.model.materials) test::lambert(m, 0.5f);
  return model;
}

frame::PictureSettings drawn() {
  frame::PictureSettings s = test::bareSettings(size, size);
  s.viewpoint.camera = "0";
  return s;
}

glm::dvec3 pointAt(int x, int y) { return {(x + 0.5) / size * 4 - 2, 2 - (y + 0.5) / size * 4, 0}; }

}  // namespace

TEST_CASE("Light profiles: a drawn picture is the twin's, turned, mirrored, coloured and of each photometry", "[gl]") {
  const glm::dquat odd = glm::normalize(glm::dquat(0.9, 0.2, -0.3, 0.25));
  const Lamp lamps[] = {{1, {1, 0, 0, 0}}, {1, odd}, {1, odd, {-1, 1, 1}}, {1, odd, {2, 2, 2}}, {2, odd}, {3, odd}};
  test::Studio studio;
  studio.display = false;
  for (const Lamp& lamp : lamps) {
    INFO("type " << lamp.type << ", scale " << lamp.scale.x);
    const io::LoadedModel model =
        load(litBy(profileText(lamp.type), {{"multiplier", 3}, {"color", {1, 0.5, 0.25}}}, lamp));
    REQUIRE(model.model.lightProfiles.size() == 1);
    const frame::Picture picture = studio.render(model, drawn());
    const glm::dmat3 lampFromWorld = glm::transpose(glm::mat3_cast(lamp.rotation));
    double worst = 0, least = 1e30, most = 0;
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const glm::dvec3 way = pointAt(x, y) - place;
        glm::dvec3 d = lampFromWorld * way;
        if (lamp.scale.x < 0) d.x = -d.x;
        const double candela = 3 * optics::candela(model.model.lightProfiles[0], d);
        const double cosine = -way.z / glm::length(way);
        const double expected = 0.5 / pi * candela * cosine / glm::dot(way, way);
        const glm::vec4& got = test::pixel(picture.radiance, x, y);
        worst = std::max(worst, std::abs(double{got.r} - expected) / std::max(expected, 1e-3));
        worst = std::max(worst, std::abs(double{got.b} - expected / 4) / std::max(expected / 4, 1e-3));
        least = std::min(least, candela), most = std::max(most, candela);
      }
    CHECK(worst < 2e-5);
    CHECK(most > 1.5 * least);  // it is no constant
  }
}

TEST_CASE("Light profiles: one that is constant is the point light, to the last bit", "[gl]") {
  const std::string constant =
      "IESNA:LM-63-2002\nTILT=NONE\n1 1 1 3 5 1 2 0 0 0 1 1 1\n0 77 180\n0 90 180 270 360\n" + [] {
        std::string numbers;
        for (int i = 0; i < 15; ++i) numbers += "7.3 ";
        return numbers;
      }();
  GltfBuilder points = lit();
  points.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 7.3f}}};
  addLightNode(points, {{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  const io::LoadedModel profiled = load(litBy(constant, nlohmann::json::object())), point = load(points);
  test::Studio studio;
  studio.display = false;
  for (const frame::Transport transport : {frame::Transport::direct, frame::Transport::paths}) {
    frame::PictureSettings settings = drawn();
    settings.quality.transport = transport;
    CHECK(studio.render(profiled, settings).radiance.pixels == studio.render(point, settings).radiance.pixels);
  }
}

TEST_CASE("Light profiles: paths see what is drawn, and shadows of them", "[gl]") {
  const glm::dquat odd = glm::normalize(glm::dquat(0.9, 0.2, -0.3, 0.25));
  GltfBuilder b = litBy(profileText(1), nlohmann::json::object(), {1, odd});
  const io::LoadedModel open = load(b);
  test::Studio studio;
  studio.display = false;
  frame::PictureSettings traced = drawn();
  traced.quality.transport = frame::Transport::paths, traced.quality.samples = 16;
  frame::PictureSettings many = drawn();
  many.quality.samples = 16;
  const frame::Picture a = studio.render(open, many), p = studio.render(open, traced);
  double worst = 0;
  for (size_t i = 0; i < a.radiance.pixels.size(); ++i)
    worst = std::max(worst, static_cast<double>(std::abs(a.radiance.pixels[i].g - p.radiance.pixels[i].g)) /
                                static_cast<double>(a.radiance.pixels[i].g));
  CHECK(worst < 0.03);  // the samples of a pixel lie elsewhere

  // A black plate between: what it hides is black in every way of looking, and bright beside it.
  nlohmann::json plate = test::addQuad(b, {-0.2f, -0.6f}, {0.6f, 0.2f});
  test::addMeshNode(b, plate, b.append("materials", test::unlit({0, 0, 0, 1})), {{"translation", {0, 0, 0.5}}});
  const io::LoadedModel hidden = load(b);
  frame::PictureSettings screen = drawn();
  screen.quality.visibility = frame::Visibility::screen;
  for (const frame::PictureSettings& settings : {traced, screen}) {
    const frame::Picture shadowed = studio.render(hidden, settings);
    INFO((settings.quality.transport == frame::Transport::paths ? "traced" : "drawn"));
    CHECK(test::pixel(shadowed.radiance, 16, 24).g <
          0.1f * test::pixel(a.radiance, 16, 24).g);  // beyond the plate's edge, in its shadow
    CHECK(test::pixel(shadowed.radiance, 44, 24).g > 0.01f);
  }
}

TEST_CASE("Light profiles: nothing is compiled or uploaded where there are none", "[gl]") {
  const io::LoadedModel with = load(litBy(profileText(1), nlohmann::json::object())), without = load(lit());
  const frame::DrawList list = frame::buildDrawList(with.model, 0, {}),
                        none = frame::buildDrawList(without.model, 0, {});
  CHECK(shading::usesFeature(list.opaque[0].key, shading::Feature::lightProfiles));
  CHECK(list.profileNumbers.size() == 3 + 5 + 5 + 25);
  CHECK(!shading::usesFeature(none.opaque[0].key, shading::Feature::lightProfiles));
  CHECK(none.profileNumbers.empty());
}

}  // namespace facet::test::profiled_lights
