#include "commands/inspect_parts.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <sstream>

#include "support/gltf_builder.hpp"
#include "support/ktx2_samples.hpp"

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

TEST_CASE("inspect tells what the images are") {
  scene::Model model;
  const auto add = [&](const char* name, std::vector<uint8_t> encoded) {
    model.images.push_back({.name = name, .file = {}, .encoded = std::move(encoded), .problem = {}});
  };
  const std::vector<uint8_t> texels(12);
  add("wood", test::pngBytes(2, 2, 3, 8, texels));
  add("lamp", test::fromHex(test::uastcAlpha));
  add("wall", test::fromHex(test::etc1sOpaque));
  add("lost", {1});
  const ordered_json images = commands::describeImages(model, {true, true, false, true});
  std::ostringstream out;
  commands::printImages(images, out);
  CHECK(out.str() ==
        "\nImages\n"
        "  wood: PNG, 2 x 2, RGB of 8 bits\n"
        "  lamp: KTX2 (UASTC, Zstandard), 16 x 8, RGBA of 8 bits, 5 mip levels\n"
        "  wall: KTX2 (ETC1S, BasisLZ), 16 x 16, RGB of 8 bits, 5 mip levels, not decoded\n"
        "  lost: is no PNG, JPEG, WebP, AVIF or KTX2 image\n");
  CHECK(images[1]["levels"] == 5);
  std::ostringstream nothing;
  commands::printImages(commands::describeImages({}, {}), nothing);
  CHECK(nothing.str() == "");
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
