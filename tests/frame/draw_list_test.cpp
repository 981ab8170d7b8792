#include "frame/draw_list.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "frame/picture.hpp"
#include "frame/settings.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/geometry.hpp"
#include "scene/usage.hpp"
#include "support/gltf_load.hpp"

using namespace facet;
using nlohmann::json;

namespace {

scene::Model load(const test::GltfBuilder& builder) {
  io::LoadedModel loaded = test::loaded(builder);
  scene::completeGeometry(loaded.model, loaded.notes);
  return std::move(loaded.model);
}

// The triangle of test::triangle() at each of the nodes.
test::GltfBuilder placed(const std::vector<json>& nodes) {
  test::GltfBuilder builder = test::triangle();
  builder.json["nodes"] = json::array();
  builder.json["scenes"][0]["nodes"] = json::array();
  for (json node : nodes) {
    node["mesh"] = 0;
    builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", node));
  }
  return builder;
}

}  // namespace

TEST_CASE("Draw list: nodes that share a mesh are one instanced draw, mirrored ones another") {
  const scene::Model model = load(placed({{{"translation", {1, 0, 0}}},
                                          {{"translation", {2, 0, 0}}},
                                          {{"scale", {-1, 1, 1}}},
                                          {{"translation", {3, 0, 0}}}}));
  const frame::DrawList list = frame::buildDrawList(model, 0, {});
  REQUIRE(list.opaque.size() == 2);
  CHECK(list.blended.empty());
  CHECK(list.instances.size() == 4);
  const frame::Draw &upright = list.opaque[0], &mirrored = list.opaque[1];
  CHECK(upright.instanceCount == 3);
  CHECK_FALSE(upright.mirrored);
  CHECK(mirrored.instanceCount == 1);
  CHECK(mirrored.mirrored);
  CHECK(mirrored.firstInstance == 3);
  // Relative to the origin: the centre of x in [-1, 4], y in [0, 1].
  CHECK(list.origin.x == Approx(1.5));
  CHECK(list.origin.y == Approx(0.5));
  CHECK(list.instances[0].worldFromLocal[3].x == Approx(-0.5));
  CHECK(list.instances[3].normalFromLocal[0].w == -1);
  CHECK(list.instances[0].normalFromLocal[0].w == 1);
}

TEST_CASE("Draw list: a primitive with fewer morph targets does not take those of the others away") {
  test::GltfBuilder builder = test::triangle();
  json& mesh = builder.json["meshes"][0];
  const json target = {{"POSITION", 0}};
  mesh["primitives"][0]["targets"] = {target, target};
  mesh["primitives"].push_back({{"attributes", {{"POSITION", 0}}}, {"targets", {target}}});
  mesh["weights"] = {0.25, 2};
  const frame::DrawList list = frame::buildDrawList(load(builder), 0, {});
  REQUIRE(list.morphWeights.size() == 2);
  CHECK(list.morphWeights[1].target == 1);
  CHECK(list.morphWeights[1].weight == 2);
  REQUIRE(list.instances.size() == 1);
  CHECK(list.instances[0].deformation.z == 2);
}

TEST_CASE("Draw list: blended draws come one by one with their own bounds, opaque ones sorted by program, material") {
  test::GltfBuilder builder = test::triangle();
  builder.json["materials"] = {{{"alphaMode", "BLEND"}}, json::object(), {{"doubleSided", true}}, json::object()};
  builder.json["meshes"] = json::array();
  for (const int material : {0, 3, 2, 1})
    builder.append("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"material", material}}}}});
  builder.json["nodes"] = {{{"mesh", 0}, {"translation", {0, 0, 4}}},
                           {{"mesh", 0}, {"translation", {0, 0, -4}}},
                           {{"mesh", 1}},
                           {{"mesh", 2}},
                           {{"mesh", 3}}};
  builder.json["scenes"][0]["nodes"] = {0, 1, 2, 3, 4};
  const frame::DrawList list = frame::buildDrawList(load(builder), 0, {});
  REQUIRE(list.blended.size() == 2);
  CHECK(list.blended[0].instanceCount == 1);
  CHECK(list.blended[0].firstInstance != list.blended[1].firstInstance);
  CHECK(list.instanceBounds[list.blended[0].firstBounds].center().z == Approx(4));
  CHECK(list.instanceBounds[list.blended[1].firstBounds].center().z == Approx(-4));
  REQUIRE(list.opaque.size() == 3);
  CHECK(list.opaque[0].material == 1);  // the plain variant first, by material
  CHECK(list.opaque[1].material == 3);
  CHECK(list.opaque[2].material == 2);
  CHECK(list.opaque[2].doubleSided);
}

TEST_CASE("Draw list: each layer can be left out of all materials, and is as if no file had it") {
  scene::Model model = load(placed({json::object()}));
  scene::Material& m = model.materials.empty() ? model.materials.emplace_back() : model.materials[0];
  m = {}, m.metallicFactor = 0.5f;
  m.ior = 1.8f, m.clearcoatFactor = 1, m.sheenColorFactor = glm::vec3(0.5f), m.anisotropyStrength = 0.5f;
  m.iridescenceFactor = 1, m.transmissionFactor = 0.5f, m.thicknessFactor = 1, m.dispersion = 0.1f;
  m.diffuseTransmissionFactor = 0.2f, m.diffuseRoughnessFactor = 0.5f;
  for (const scene::Effect effect : scene::effects) {
    INFO(scene::name(effect));
    REQUIRE(scene::has(m, effect));
    const frame::DrawList list = frame::buildDrawList(model, 0, {.without = scene::bitOf(effect)});
    CHECK_FALSE(scene::has(list.materials[0], effect));
    for (const scene::Effect other : scene::effects)  // what passes through a body depends on what passes at all
      if (other != effect && other < scene::Effect::transmission) CHECK(scene::has(list.materials[0], other));
  }
  const frame::DrawList none = frame::buildDrawList(model, 0, {.without = (1u << std::size(scene::effects)) - 1});
  scene::Model plain = model;
  plain.materials[0] = {};
  const frame::DrawList bare = frame::buildDrawList(plain, 0, {});
  REQUIRE(none.opaque.size() == bare.opaque.size());
  CHECK(none.opaque[0].key == bare.opaque[0].key);
  CHECK(none.transmitting.empty());
}

TEST_CASE("Draw list: what the draws need of the tables") {
  const scene::Model lit = load(placed({json::object()}));
  CHECK_FALSE(frame::buildDrawList(lit, 0, {}).needs(false).dfg);
  const auto needs = [&](const frame::DrawOptions& options) {
    return frame::buildDrawList(lit, 0, options).needs(true);
  };
  CHECK(needs({}).background);
  const ibl::Needs demo = needs({.demoLights = true});
  CHECK(demo.dfg);
  CHECK_FALSE(demo.irradiance);
  const ibl::Needs environment = needs({.features = {.environment = true}});
  CHECK(environment.dfg);
  CHECK(environment.irradiance);
  CHECK(environment.layers);
  CHECK_FALSE(environment.samples);
  // Converging pictures sample the environment itself in place of the split sum's layers.
  const ibl::Needs converging = needs({.features = {.environment = true, .imageLightSamples = 4}});
  CHECK(converging.irradiance);
  CHECK_FALSE(converging.layers);
  CHECK(converging.samples);
  CHECK(environment.taps);
  CHECK_FALSE(demo.taps);
  CHECK_FALSE(converging.taps);
  frame::DrawOptions mean{.features = {.environment = true}};
  mean.features.models.imageLight = optics::ImageLight::mean;
  CHECK_FALSE(needs(mean).taps);
  // A debug view needs nothing.
  const ibl::Needs view = needs({.features = {.environment = true, .channel = 1}, .demoLights = true});
  CHECK_FALSE(view.dfg);
  CHECK_FALSE(view.irradiance);
}

TEST_CASE("Draw list: the range of roughness in which lobes look the environment's layers up") {
  frame::DrawOptions lit{.features = {.environment = true}};
  lit.features.models.imageLight = optics::ImageLight::mean;
  const json texture = {{"index", 0}};
  const auto range = [&](const std::vector<json>& materials, const frame::DrawOptions& options) {
    test::GltfBuilder builder = test::triangle();
    const int texCoords = builder.add(std::vector<float>{0, 0, 1, 0, 0, 1}, test::floatType, "VEC2");
    builder.json["images"] = {{{"uri", "data:image/png;base64,"}}};
    builder.json["textures"] = {{{"source", 0}}};
    builder.json["meshes"] = json::array();
    builder.json["scenes"][0]["nodes"] = json::array();
    builder.json["nodes"] = json::array();
    builder.json["materials"] = materials;
    json used = json::array();
    for (const char* name : {"clearcoat", "sheen", "anisotropy", "pbrSpecularGlossiness"})
      used.push_back("KHR_materials_" + std::string(name));
    builder.json["extensionsUsed"] = used;
    for (size_t i = 0; i < materials.size(); ++i) {
      builder.append("meshes", {{"primitives",
                                 {{{"attributes", {{"POSITION", 0}, {"TEXCOORD_0", texCoords}}}, {"material", i}}}}});
      builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", {{"mesh", i}}));
    }
    const ibl::Needs needs = frame::buildDrawList(load(builder), 0, options).needs(false);
    return glm::vec2(needs.lowestRoughness, needs.highestRoughness);
  };
  const auto rough = [](double r) { return json{{"pbrMetallicRoughness", {{"roughnessFactor", r}}}}; };
  const auto with = [](json material, const char* extension, json value) {
    material["extensions"]["KHR_materials_" + std::string(extension)] = std::move(value);
    return material;
  };
  CHECK(range({rough(0.5)}, lit) == glm::vec2(0.5f));
  CHECK(range({rough(0.7), rough(0.6), rough(0.9)}, lit) == glm::vec2(0.6f, 0.9f));
  CHECK(range({json::object()}, lit) == glm::vec2(1));
  CHECK(range({with(rough(0.8), "clearcoat", {{"clearcoatFactor", 1}, {"clearcoatRoughnessFactor", 0.1}})}, lit) ==
        glm::vec2(0.1f, 0.8f));
  CHECK(range({with(rough(0.8), "clearcoat", {{"clearcoatFactor", 0}})}, lit) == glm::vec2(0.8f));
  CHECK(range({with(rough(0.8), "sheen", {{"sheenColorFactor", {1, 1, 1}}})}, lit) == glm::vec2(0.4f, 0.8f));
  CHECK(range({with(rough(0.3), "anisotropy", {{"anisotropyStrength", 0.5}})}, lit) == glm::vec2(0.3f, 1));
  CHECK(range({with({}, "pbrSpecularGlossiness", {{"glossinessFactor", 0.75}})}, lit) == glm::vec2(0.25f));
  // Fitted look-ups, the default among them, go to smoother layers too.
  CHECK(range({rough(0.5)}, {.features = {.environment = true}}).x < 0.45f);
  frame::DrawOptions fitted = lit;
  fitted.features.models.imageLight = optics::ImageLight::taps2;
  const glm::vec2 spread = range({rough(0.5)}, fitted);
  CHECK(spread.x < 0.45f);
  CHECK(spread.x > 0.1f);
  CHECK(spread.y > 0.5f);
  CHECK(spread.y < 0.9f);
  // Where a pixel is shaded once its lobes may be wider, but not narrower.
  frame::DrawOptions once = lit;
  once.features.shadedOnce = true;
  CHECK(range({rough(0)}, once).x == 0);
  CHECK(range({rough(0)}, once).y == Approx(std::pow(0.02, 0.25)));
  CHECK(range({rough(0.5), rough(0), rough(0.9)}, once).y == Approx(std::pow(std::pow(0.9, 4) + 0.02, 0.25)));
  CHECK(range({rough(1)}, once) == glm::vec2(1));
  // What converges samples the environment itself, and what is unlit needs nothing: the range says nothing there.
  CHECK(range({rough(0.5)}, {.features = {.environment = true, .imageLightSamples = 4}}) == glm::vec2(0, 1));
  CHECK(range({rough(0.5)}, {}) == glm::vec2(0, 1));
  // A texture takes its factor down to 0, a glossiness texture the roughness up to 1.
  json textured = rough(0.6);
  textured["pbrMetallicRoughness"]["metallicRoughnessTexture"] = texture;
  CHECK(range({textured}, lit) == glm::vec2(0, 0.6f));
  CHECK(range({with({}, "pbrSpecularGlossiness", {{"glossinessFactor", 0.75}, {"specularGlossinessTexture", texture}})},
              lit) == glm::vec2(0.25f, 1));
  CHECK(
      range({with(rough(0.8), "clearcoat",
                  {{"clearcoatFactor", 1}, {"clearcoatRoughnessFactor", 0.5}, {"clearcoatRoughnessTexture", texture}})},
            lit) == glm::vec2(0, 0.8f));
}

TEST_CASE("Draw list: lights relative to the origin, cones and ranges as the shader takes them") {
  test::GltfBuilder builder = placed({{{"translation", {1e7, 0, 0}}}});
  builder.json["extensionsUsed"] = {"KHR_lights_punctual"};
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"},
       {"intensity", 5},
       {"color", {1, 0.5, 0}},
       {"range", 4},
       {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.6}}}},
      {{"type", "directional"}}};
  const auto add = [&](int light, json node) {
    node["extensions"]["KHR_lights_punctual"]["light"] = light;
    builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", node));
  };
  add(0, {{"translation", {1e7 + 2, 3, 0}}});
  add(1, {{"rotation", {1, 0, 0, 0}}});  // half a turn about X: shines along +Z
  const scene::Model model = load(builder);
  const frame::DrawList list = frame::buildDrawList(model, 0, {});
  CHECK(list.features.punctualLights);
  REQUIRE(list.lights.size() == 2);
  const layout::LightUniforms &spot = list.lights[0], &sun = list.lights[1];
  CHECK(spot.position.x == Approx(1.5));  // from the triangle's centre
  CHECK(spot.position.y == Approx(2.5));
  CHECK(spot.position.w == 2);
  CHECK(spot.direction.w == Approx(1.0 / 16));
  CHECK(spot.color.y == Approx(2.5));
  CHECK(std::cos(0.2) * spot.cone.x + spot.cone.y == Approx(1));
  CHECK(std::cos(0.6) * spot.cone.x + spot.cone.y == Approx(0).margin(1e-6));
  CHECK(sun.position.w == 0);
  CHECK(sun.direction.z == Approx(1));
  CHECK(sun.direction.w == 0);
  CHECK(frame::buildDrawList(model, 0, {.sceneLights = false}).lights.empty());
}

TEST_CASE("Draw list: one material in place of all, and none of the model's") {
  test::GltfBuilder builder = test::triangle();
  builder.json["materials"] = {{{"alphaMode", "BLEND"}}};
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  frame::DrawOptions options;
  options.material = {true, {0.1f, 0.2f, 0.3f}, 1, 0.25f, 1.5f, {}, {}};
  const frame::DrawList list = frame::buildDrawList(load(builder), 0, options);
  REQUIRE(list.opaque.size() == 1);
  CHECK(list.blended.empty());
  CHECK(list.materials[size_t(list.opaque[0].material)].perceptualRoughnessFactor == 0.25f);
}

TEST_CASE("Draw list: a variant's materials take the place of the primitives' own") {
  test::GltfBuilder builder = test::triangle();
  builder.json["materials"] = {{{"name", "own"}}, {{"name", "red"}, {"alphaMode", "BLEND"}}};
  builder.json["extensions"]["KHR_materials_variants"]["variants"] = {
      {{"name", "day"}}, {{"name", "night"}}, {{"name", "1"}}};
  json& from = builder.json["meshes"][0]["primitives"][0];
  from["material"] = 0;
  from["extensions"]["KHR_materials_variants"]["mappings"] = {{{"material", 1}, {"variants", {1}}}};
  const scene::Model model = load(builder);
  const auto shown = [&](const std::string& variant) {
    frame::PictureSettings settings;
    settings.look.variant = variant;
    const Result<int> index = frame::chooseVariant(settings.look, model);
    if (!index) return describe(index.error());
    const frame::DrawList list = frame::buildDrawList(model, 0, {.variant = *index});
    const std::vector<frame::Draw>& draws = list.opaque.empty() ? list.blended : list.opaque;
    return list.materials[static_cast<size_t>(draws.at(0).material)].name + (list.opaque.empty() ? " blended" : "");
  };
  CHECK(shown("") == "own");
  CHECK(shown("day") == "own");  // the primitive has no material for it
  CHECK(shown("0") == "own");
  CHECK(shown("night") == "red blended");
  CHECK(shown("1") == "own");  // a name comes before an index
  CHECK(shown("dusk") == "m: the file has no material variant 'dusk'; it has 0 (day), 1 (night), 2 (1).");
  CHECK(shown("3") == "m: the file has no material variant '3'; it has 0 (day), 1 (night), 2 (1).");
  CHECK(shown("-1") == "m: the file has no material variant '-1'; it has 0 (day), 1 (night), 2 (1).");
  frame::PictureSettings settings;
  settings.look.variant = "night";
  CHECK(describe(frame::chooseVariant(settings.look, {}).error()) ==
        "the file has no material variant 'night'; it has none at all: choose none.");
}

TEST_CASE("Draw list: 100,000 nodes of one mesh are one draw, 1,000 materials as many, sorted by material") {
  const auto built = [](const char* name) {
    const auto bytes = scene::builtinScene(name);
    Result<io::LoadedModel> loaded = io::loadGltfBytes(*bytes, name, {});
    REQUIRE(loaded);
    scene::completeGeometry(loaded->model, loaded->notes);
    return std::move(loaded->model);
  };
  const scene::Model crowd = built("crowd");
  const frame::DrawList one = frame::buildDrawList(crowd, 0, {});
  REQUIRE(one.opaque.size() == 1);
  CHECK(one.opaque[0].instanceCount == 100'000);
  const scene::Model palette = built("palette");
  const frame::DrawList many = frame::buildDrawList(palette, 0, {});
  REQUIRE(many.opaque.size() == 1000);
  CHECK(std::ranges::is_sorted(many.opaque, {}, &frame::Draw::material));
}

TEST_CASE("Framing takes in what moves far for a moment only") {
  scene::Model model = load(test::triangle());
  scene::AnimationSampler sampler;
  sampler.times = {0, 500, 501, 502, 1000};
  sampler.values = {0, 0, 0, 0, 0, 0, 20, 0, 0, 0, 0, 0, 0, 0, 0};
  sampler.width = 3;
  model.animations = {{"jump", {sampler}, {{0, scene::AnimatedProperty::translation, 0, {}}}}};
  CHECK(frame::framingBounds({.scene = -1, .animation = "jump", .timeSeconds = 0, .arrangement = {}}, model, 0, {})
            .max.x == Approx(21));
}
