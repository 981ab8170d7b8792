#include "frame/shadow_maps.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "frame/draw_list.hpp"

using namespace facet;

namespace {

// Kind as layout.h has it: 0 directional, 1 point, 2 spot, 3 the environment's sun.
layout::LightUniforms lightOf(float kind, const glm::vec3& position, const glm::vec3& direction, double outer = 0.5) {
  layout::LightUniforms light;
  light.position = glm::vec4(position, kind), light.direction = glm::vec4(glm::normalize(direction), 0);
  light.color = glm::vec4(1);
  const auto cosine = static_cast<float>(std::cos(outer)), scale = 1 / std::max(0.001f, 1 - cosine);
  light.cone = glm::vec4(scale, -cosine * scale, 0, 0);
  return light;
}

frame::DrawList listOf(std::vector<layout::LightUniforms> lights) {
  frame::DrawList list;
  list.bounds.add({2, -1, 4}), list.bounds.add({5, 3, 7});
  list.origin = list.bounds.center();
  list.lights = std::move(lights);
  frame::assignShadowMaps(list);
  return list;
}

// Within the map, and in front of it.
bool sees(const scene::View& view, const glm::dvec3& world) {
  const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1);
  return clip.w > 0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w && clip.z >= 0 && clip.z <= clip.w;
}

}  // namespace

TEST_CASE("Shadow maps: parallel light sees all corners of the scene, from any direction") {
  for (const glm::vec3 direction : {glm::vec3(0, -1, 0), glm::vec3(0, 1, 0), glm::vec3(1, -2, 0.3), glm::vec3(0, 0, 1)})
    for (const float kind : {0.0f, 3.0f}) {
      const frame::DrawList list = listOf({lightOf(kind, {}, direction)});
      const std::vector<scene::View> views = frame::shadowViews(list, 30);
      REQUIRE(views.size() == 1);
      for (const double x : {2.0, 5.0})
        for (const double y : {-1.0, 3.0})
          for (const double z : {4.0, 7.0}) CHECK(sees(views[0], {x, y, z}));
      // The environment's sun turns with it.
      glm::dvec3 along = glm::normalize(glm::dvec3(direction));
      if (kind == 3)
        along = glm::dvec3(glm::rotate(glm::dmat4(1), glm::radians(30.0), {0, 1, 0}) * glm::dvec4(along, 0));
      CHECK(glm::length(glm::dvec3(views[0].forward) - along) < 1e-6);
    }
  const std::vector<scene::View> turned = frame::shadowViews(listOf({lightOf(3, {}, {0, 0, 1})}), 90);
  CHECK(turned[0].forward.x == Approx(1));  // about +Y from +Z towards +X
}

TEST_CASE("Shadow maps: a point's six see every direction, each by the face that the shader takes") {
  const frame::DrawList list = listOf({lightOf(1, {0.5f, 0, 0}, {0, 0, -1})});
  CHECK(list.lights[0].cone.z == -1);
  const std::vector<scene::View> views = frame::shadowViews(list, 0);
  REQUIRE(views.size() == 6);
  const glm::dvec3 eye = list.origin + glm::dvec3(0.5, 0, 0);
  for (int i = 0; i < 200; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 200, phi = 2.4 * i, r = std::sqrt(1 - z * z);
    const glm::dvec3 d(r * std::cos(phi), r * std::sin(phi), z), a = glm::abs(d);
    const int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
    CHECK(sees(views[static_cast<size_t>(2 * axis + (d[axis] < 0 ? 1 : 0))], eye + 3.0 * d));
  }
}

TEST_CASE("Shadow maps: a spot's sees its cone, wide ones have six, and what is dark has none") {
  const frame::DrawList list = listOf({lightOf(2, {}, {1, 1, 0}, 0.9), lightOf(2, {}, {0, 0, 1}, 1.5)});
  CHECK(list.lights[0].cone.z == 1);
  CHECK(list.lights[1].cone.z == -2);
  const std::vector<scene::View> views = frame::shadowViews(list, 0);
  REQUIRE(views.size() == 7);
  for (const double turn : {0.0, 1.0, 2.0, 4.0}) {
    const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 1, 0)), side = glm::dvec3(0, 0, 1),
                     other = glm::cross(axis, side);
    const glm::dvec3 rim = std::cos(0.9) * axis + std::sin(0.9) * (std::cos(turn) * side + std::sin(turn) * other);
    CHECK(sees(views[0], list.origin + 2.0 * rim));
  }
  layout::LightUniforms dark = lightOf(0, {}, {0, -1, 0});
  dark.color = glm::vec4(0);
  const frame::DrawList none = listOf({dark});
  CHECK(none.lights[0].cone.z == 0);
  CHECK(frame::shadowViews(none, 0).empty());
  CHECK(frame::lightsWithoutMap(none) == 0);
}

TEST_CASE("Shadow maps: where there is no room for all lights, those of one map come first, and the rest is told") {
  std::vector<layout::LightUniforms> lights(6, lightOf(1, {}, {0, 0, -1}));
  lights.push_back(lightOf(0, {}, {0, -1, 0}));
  const frame::DrawList list = listOf(lights);
  CHECK(list.lights[6].cone.z == 1);
  CHECK(list.lights[0].cone.z == -2);
  CHECK(list.lights[2].cone.z == -14);
  CHECK(list.lights[3].cone.z == 0);
  CHECK(frame::lightsWithoutMap(list) == 3);
  const std::vector<scene::View> views = frame::shadowViews(list, 0);
  REQUIRE(views.size() == 19);
  CHECK(views[0].orthographic);
  CHECK(views[0].forward.y == Approx(-1));
  CHECK_FALSE(views[1].orthographic);
  CHECK(frame::shadowMapSize(list) < frame::shadowMapSize(listOf({lights.back()})));
}

TEST_CASE("Shadow maps: a light outside sees all of the scene in one, whose texels do not grow with its distance") {
  double near = 0;
  for (const double distance : {5.0, 50.0, 5e4})
    for (const float kind : {1.0f, 2.0f}) {
      const glm::vec3 position = static_cast<float>(distance) * glm::normalize(glm::vec3(1, 2, -1));
      const frame::DrawList list = listOf({lightOf(kind, position, {0, -1, 0}, 1.5)});
      INFO(distance << " m, of kind " << kind);
      CHECK(list.lights[0].cone.z == 1);
      const std::vector<scene::View> views = frame::shadowViews(list, 0);
      REQUIRE(views.size() == 1);
      for (const double x : {2.0, 5.0})
        for (const double y : {-1.0, 3.0})
          for (const double z : {4.0, 7.0}) CHECK(sees(views[0], {x, y, z}));
      const double texel = double(list.lights[0].cone.w) * distance;
      if (near == 0) near = texel;
      CHECK(texel <= near * 1.001);
    }
}
