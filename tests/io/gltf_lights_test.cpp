#include <catch2/catch.hpp>
#include <cmath>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

}  // namespace

TEST_CASE("Lights", "[io][gltf]") {
  GltfBuilder b;
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "directional"}, {"intensity", 3}, {"color", {0.5, 1, 0}}, {"name", "sun"}},
      {{"type", "point"}, {"range", 12}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
      {{"type", "spot"}, {"spot", {{"innerConeAngle", 3}, {"outerConeAngle", 2}}}},
      {{"type", "point"}, {"intensity", -1}, {"range", -2}},
  };
  b.append("nodes", {{"extensions", {{"KHR_lights_punctual", {{"light", 1}}}}}});
  const auto model = loaded(b);
  const auto& l = model.model.lights;
  CHECK(l[0].type == scene::LightType::directional);
  CHECK(l[0].name == "sun");
  CHECK(l[0].intensity == 3);
  CHECK(l[0].color == glm::vec3(0.5f, 1, 0));
  CHECK(std::isinf(l[0].range));
  CHECK(l[1].type == scene::LightType::point);
  CHECK(l[1].range == 12);
  CHECK(l[1].intensity == 1);
  CHECK(l[1].color == glm::vec3(1));
  CHECK(l[2].type == scene::LightType::spot);
  CHECK(l[2].innerConeAngle == 0.2f);
  CHECK(l[2].outerConeAngle == 0.4f);
  CHECK(l[3].outerConeAngle == Approx(1.5707963));
  CHECK(l[3].innerConeAngle < l[3].outerConeAngle);
  CHECK(l[4].intensity == 1);
  CHECK(std::isinf(l[4].range));
  CHECK(model.model.nodes[0].light == 1);
  CHECK(notes(model) ==
        "! /extensions/KHR_lights_punctual/lights/3/spot: the cone angles are out of range: brought to 0 <= inner < "
        "outer <= "
        "pi/2\n"
        "! /extensions/KHR_lights_punctual/lights/4/intensity: is out of range: the default is used\n"
        "! /extensions/KHR_lights_punctual/lights/4/range: is out of range: the default is used\n");
}

TEST_CASE("Cameras", "[io][gltf]") {
  GltfBuilder b;
  b.append("cameras", {{"type", "perspective"},
                       {"name", "p"},
                       {"perspective", {{"yfov", 0.5}, {"znear", 0.1}, {"zfar", 50}, {"aspectRatio", 2}}}});
  b.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 2}}}});
  b.append("cameras",
           {{"type", "orthographic"}, {"orthographic", {{"xmag", 3}, {"ymag", 4}, {"znear", 0}, {"zfar", 9}}}});
  b.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 4}, {"znear", 2}, {"zfar", 1}}}});
  b.append("nodes", {{"camera", 2}});
  const auto model = loaded(b);
  const auto& c = model.model.cameras;
  CHECK(c[0].name == "p");
  CHECK(c[0].perspective);
  CHECK(c[0].fovY == 0.5);
  CHECK(c[0].zNear == 0.1);
  CHECK(c[0].zFar == 50);
  CHECK(c[0].aspectRatio == 2);
  CHECK(std::isinf(c[1].zFar));
  CHECK(c[1].aspectRatio == 0);
  CHECK_FALSE(c[2].perspective);
  CHECK(c[2].xMag == 3);
  CHECK(c[2].yMag == 4);
  CHECK(c[2].zNear == 0);
  CHECK(c[2].zFar == 9);
  CHECK(c[3].fovY == 0.8);
  CHECK(c[3].zNear == 2);
  CHECK(std::isinf(c[3].zFar));
  CHECK(model.model.nodes[0].camera == 2);
  CHECK(notes(model) ==
        "! /cameras/3/perspective/yfov: is out of range: the default is used\n"
        "! /cameras/3/perspective/zfar: is out of range: the default is used\n");
}
