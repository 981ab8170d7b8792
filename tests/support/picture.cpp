#include "support/picture.hpp"

#include <catch2/catch.hpp>

#include "io/sources.hpp"
#include "scene/geometry.hpp"
#include "scene/shapes.hpp"
#include "support/gltf_load.hpp"
#include "support/gpu.hpp"

namespace facet::test {

using Json = nlohmann::json;

io::LoadedModel loadBuilt(const GltfBuilder& builder) {
  io::LoadedModel model = loaded(builder);
  scene::completeGeometry(model.model, model.notes);
  return model;
}

io::LoadedModel loadBuiltin(const std::string& name) {
  Result<io::LoadedModel> loaded = io::loadModel(name);
  REQUIRE(loaded);
  return std::move(*loaded);
}

Studio::Studio() : programs_(makeProgramStore()) {}
Studio::Studio(shading::ShaderReader reader) : programs_(std::move(reader), {}, "") {}

frame::LoadedScene sceneOf(const io::LoadedModel& model) {
  return {.source = model.model.name, .loaded = {std::shared_ptr<void>(), &model}};
}

frame::Picture Studio::render(const io::LoadedModel& model, const frame::PictureSettings& settings) {
  frame::LoadedScene scene = sceneOf(model);
  return render(scene, settings);
}

frame::Picture Studio::render(frame::LoadedScene& scene, const frame::PictureSettings& settings) {
  notes.clear();
  Stages stages;
  frame::PictureStatistics statistics;
  const frame::Supply supply = frame::supplyAtOnce(shelf_, programs_, notes);
  const frame::PictureRequest request{.radiance = true, .display = display, .estimate = estimate};
  Result<frame::Drawable> drawable =
      frame::preparePicture(settings, request, scene, supply, programs_, statistics, notes, stages);
  INFO((drawable ? std::string() : describe(drawable.error())));
  REQUIRE(drawable);
  Result<frame::Picture> picture =
      frame::drawPicture(settings, request, *drawable, std::move(statistics), programs_, contextInfo(), stages);
  INFO((picture ? std::string() : describe(picture.error())));
  REQUIRE(picture);
  return std::move(*picture);
}

frame::PictureSettings bareSettings(int width, int height) {
  frame::PictureSettings settings;
  settings.frame.width = width;
  settings.frame.height = height;
  settings.quality.samples = 1;
  settings.quality.visibility = frame::Visibility::none;
  settings.sources.environment = "none";
  settings.frame.background = frame::Background::transparent;
  return settings;
}

const glm::vec4& pixel(const io::RadianceImage& image, int x, int y) {
  return image.pixels.at(static_cast<size_t>(y) * static_cast<size_t>(image.width) + static_cast<size_t>(x));
}

namespace {

std::vector<float> flattened(const std::vector<glm::vec3>& vectors) {
  std::vector<float> out;
  for (const glm::vec3& v : vectors) out.insert(out.end(), {v.x, v.y, v.z});
  return out;
}

Json primitive(GltfBuilder& builder, const std::vector<glm::vec3>& positions, const std::vector<glm::vec3>& normals,
               const std::vector<uint32_t>& indices) {
  const int position = builder.add(flattened(positions), floatType, "VEC3");
  const int normal = builder.add(flattened(normals), floatType, "VEC3");
  const int index = builder.add(indices, uintType, "SCALAR");
  return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}}, {"indices", index}};
}

}  // namespace

Json addSphere(GltfBuilder& builder, double radius, int stacks, int slices) {
  scene::Shape shape = scene::sphereShape(stacks, slices);
  for (glm::vec3& p : shape.positions) p *= static_cast<float>(radius);
  return primitive(builder, shape.positions, shape.normals, shape.indices);
}

Json addQuad(GltfBuilder& builder, glm::vec2 low, glm::vec2 high) {
  const std::vector<glm::vec3> positions = {{low, 0}, {high.x, low.y, 0}, {high, 0}, {low.x, high.y, 0}};
  return primitive(builder, positions, std::vector<glm::vec3>(4, {0, 0, 1}), {0, 1, 2, 0, 2, 3});
}

int addMeshNode(GltfBuilder& builder, Json primitive, int material, const Json& extra) {
  if (material >= 0) primitive["material"] = material;
  Json node = extra.is_null() ? Json::object() : extra;
  node["mesh"] = builder.append("meshes", {{"primitives", {primitive}}});
  const int index = builder.append("nodes", node);
  builder.json["scenes"][0]["nodes"].push_back(index);
  return index;
}

void addOrthographicCamera(GltfBuilder& builder, double x, double y) {
  const int camera = builder.append(
      "cameras",
      {{"type", "orthographic"}, {"orthographic", {{"xmag", x}, {"ymag", y}, {"znear", 0.1}, {"zfar", 100}}}});
  const int node = builder.append("nodes", {{"camera", camera}, {"translation", {0, 0, 10}}});
  builder.json["scenes"][0]["nodes"].push_back(node);
}

Json material(const glm::vec4& color, double metallic, double roughness) {
  return {{"pbrMetallicRoughness",
           {{"baseColorFactor", {color.x, color.y, color.z, color.w}},
            {"metallicFactor", metallic},
            {"roughnessFactor", roughness}}}};
}

Json unlit(const glm::vec4& color, const Json& extra) {
  Json m = material(color);
  m["extensions"]["KHR_materials_unlit"] = Json::object();
  m.update(extra);
  return m;
}

GltfBuilder emptyScene() {
  GltfBuilder builder;
  builder.json["scenes"] = {{{"nodes", Json::array()}}};
  builder.json["extensionsUsed"] = {"KHR_materials_unlit", "KHR_materials_pbrSpecularGlossiness",
                                    "KHR_texture_transform", "KHR_lights_punctual"};
  return builder;
}

Json at(double x, double y, double z) { return {{"translation", {x, y, z}}}; }

void checkPixel(const glm::vec4& got, const glm::vec4& expected, float margin) {
  INFO("got " << got.x << " " << got.y << " " << got.z << " " << got.w << ", expected " << expected.x << " "
              << expected.y << " " << expected.z << " " << expected.w);
  for (int i = 0; i < 4; ++i) CHECK(std::abs(got[i] - expected[i]) <= margin);
}

}  // namespace facet::test
