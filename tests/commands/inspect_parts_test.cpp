#include "commands/inspect_parts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

using namespace facet;
using nlohmann::ordered_json;

namespace {

std::string printed(const scene::Model& model) {
  ordered_json described;
  commands::describeParts(model, described);
  std::ostringstream out;
  commands::printParts(described, out);
  return out.str();
}

}  // namespace

TEST_CASE("inspect tells of motion, variants, instances and metadata, and of nothing that is not there") {
  CHECK(printed({}) == "");
  scene::Model model;
  model.animations.resize(2);
  model.animations[0].name = "walk";
  // The second sampler is longer, but nothing reads it.
  model.animations[0].samplers = {{scene::Interpolation::linear, {0, 1.5f}, {0, 0}, 1},
                                  {scene::Interpolation::linear, {0, 9}, {0, 0}, 1}};
  model.animations[0].channels.resize(3);
  model.skins = {{"", {1, 2, 3}, {}}};
  model.meshes.resize(2);
  model.meshes[1].name = "face";
  model.meshes[1].primitives.resize(2);
  model.meshes[1].primitives[1].targets.resize(2);
  model.meshes[1].targetNames = {"smile", "frown"};
  model.nodes.resize(2);
  model.nodes[1].instances.resize(5);
  model.variants = {"day", "night"};
  model.xmp = {{R"({"dc:title":"a"})", "{}"}, {{"/asset", 0}, {"/nodes/1", 0}}};
  CHECK(printed(model) ==
        "\nAnimations\n  walk: 1.5 s, 3 channels\n  animation 1: 0 s, 0 channels\n"
        "\nSkins\n  skin 0: 3 joints\n"
        "\nMorph targets\n  face: 2 (smile, frown)\n"
        "\nInstancing\n  node 1: 5 instances\n"
        "\nMaterial variants\n  day\n  night\n"
        "\nXMP metadata\n  /asset, /nodes/1: {\"dc:title\":\"a\"}\n  nothing: {}\n");
  ordered_json described;
  commands::describeParts(model, described);
  CHECK(described["animations"][0] == ordered_json{{"name", "walk"}, {"seconds", 1.5}, {"channels", 3}});
  CHECK(described["xmp"][0]["packet"]["dc:title"] == "a");
  CHECK(described["xmp"][0]["about"] == ordered_json{"/asset", "/nodes/1"});
}

TEST_CASE("inspect lists the effects of a material that can be seen") {
  scene::Material m;
  CHECK(commands::describeEffects(m).is_null());
  m.clearcoatRoughnessFactor = 0.3f;  // of no clearcoat
  m.thicknessFactor = 2;              // that nothing shines through
  m.ior = 1.1f;
  m.specularColor.texture = 4;
  m.sheenColorFactor = {0.1f, 0, 1};
  CHECK(commands::describeEffects(m) == ordered_json{{"ior", {{"ior", 1.1}}},
                                                     {"specular", {{"specularColorTexture", 4}}},
                                                     {"sheen", {{"sheenColorFactor", {0.1, 0.0, 1.0}}}}});
  m.clearcoatFactor = 1;
  CHECK(commands::describeEffects(m)["clearcoat"] ==
        ordered_json{{"clearcoatFactor", 1.0}, {"clearcoatRoughnessFactor", 0.3}});
  m.unlit = true;
  CHECK(commands::describeEffects(m).is_null());
}
