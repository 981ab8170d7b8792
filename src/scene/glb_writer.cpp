#include "scene/glb_writer.hpp"

#include <bit>
#include <cstring>

#include "scene/glb_container.hpp"

namespace facet::scene {

namespace {

static_assert(std::endian::native == std::endian::little, "glTF is little-endian");

constexpr int floatType = 5126, ushortType = 5123, uintType = 5125;
constexpr const char* lightsExtension = "KHR_lights_punctual";
constexpr int arrayBuffer = 34962, elementArrayBuffer = 34963;

template <class T>
int append(nlohmann::json& array, T&& value) {
  array.push_back(std::forward<T>(value));
  return int(array.size()) - 1;
}

template <class T>
int addView(GlbWriter& w, const std::vector<T>& values) {
  const size_t offset = w.binary.size(), bytes = values.size() * sizeof(T);
  w.binary.resize(offset + (bytes + 3) / 4 * 4);
  std::memcpy(w.binary.data() + offset, values.data(), bytes);
  return append(w.gltf["bufferViews"], nlohmann::json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes}});
}

template <class T>
int addAccessor(GlbWriter& w, const std::vector<T>& values, int target, int componentType, const char* type) {
  const int view = addView(w, values);
  w.gltf["bufferViews"][size_t(view)]["target"] = target;
  return append(
      w.gltf["accessors"],
      nlohmann::json{{"bufferView", view}, {"componentType", componentType}, {"count", values.size()}, {"type", type}});
}

}  // namespace

GlbWriter startGlb() {
  GlbWriter w;
  w.gltf = {{"asset", {{"version", "2.0"}, {"generator", "facet"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", nlohmann::json::array()}}}}};
  return w;
}

nlohmann::json addShape(GlbWriter& w, const Shape& shape) {
  nlohmann::json primitive;
  nlohmann::json& attributes = primitive["attributes"];
  const int positions = addAccessor(w, shape.positions, arrayBuffer, floatType, "VEC3");
  glm::vec3 low = shape.positions.front(), high = low;
  for (const glm::vec3& p : shape.positions) low = glm::min(low, p), high = glm::max(high, p);
  w.gltf["accessors"][size_t(positions)]["min"] = {low.x, low.y, low.z};
  w.gltf["accessors"][size_t(positions)]["max"] = {high.x, high.y, high.z};
  attributes["POSITION"] = positions;
  attributes["NORMAL"] = addAccessor(w, shape.normals, arrayBuffer, floatType, "VEC3");
  attributes["TEXCOORD_0"] = addAccessor(w, shape.texCoords, arrayBuffer, floatType, "VEC2");
  if (!shape.colors.empty()) attributes["COLOR_0"] = addAccessor(w, shape.colors, arrayBuffer, floatType, "VEC4");
  if (shape.positions.size() < 65536) {
    const std::vector<uint16_t> narrow(shape.indices.begin(), shape.indices.end());
    primitive["indices"] = addAccessor(w, narrow, elementArrayBuffer, ushortType, "SCALAR");
  } else {
    primitive["indices"] = addAccessor(w, shape.indices, elementArrayBuffer, uintType, "SCALAR");
  }
  return primitive;
}

int addMaterial(GlbWriter& w, const std::string& name, const glm::dvec3& baseColor, double metallic,
                double perceptualRoughness) {
  return append(w.gltf["materials"], nlohmann::json{{"name", name},
                                                    {"pbrMetallicRoughness",
                                                     {{"baseColorFactor", {baseColor.r, baseColor.g, baseColor.b, 1.0}},
                                                      {"metallicFactor", metallic},
                                                      {"roughnessFactor", perceptualRoughness}}}});
}

int addMesh(GlbWriter& w, const std::string& name, nlohmann::json primitive, int material) {
  primitive["material"] = material;
  return append(w.gltf["meshes"],
                nlohmann::json{{"name", name}, {"primitives", nlohmann::json::array({std::move(primitive)})}});
}

int addMesh(GlbWriter& w, const std::string& name, const std::vector<std::pair<nlohmann::json, int>>& parts) {
  nlohmann::json primitives = nlohmann::json::array();
  for (const auto& [primitive, material] : parts) {
    primitives.push_back(primitive);
    primitives.back()["material"] = material;
  }
  return append(w.gltf["meshes"], nlohmann::json{{"name", name}, {"primitives", primitives}});
}

int addMesh(GlbWriter& w, const std::string& name, const std::vector<std::pair<Shape, int>>& parts) {
  std::vector<std::pair<nlohmann::json, int>> primitives;
  for (const auto& [shape, material] : parts) primitives.emplace_back(addShape(w, shape), material);
  return addMesh(w, name, primitives);
}

void setGlow(GlbWriter& w, int material, const glm::dvec3& color, double strength) {
  constexpr const char* extension = "KHR_materials_emissive_strength";
  useExtension(w, extension);
  nlohmann::json& m = w.gltf["materials"][size_t(material)];
  m["emissiveFactor"] = {color.r, color.g, color.b};
  m["extensions"][extension] = {{"emissiveStrength", strength}};
}

int addPngTexture(GlbWriter& w, const std::vector<uint8_t>& png) {
  const int image =
      append(w.gltf["images"], nlohmann::json{{"bufferView", addView(w, png)}, {"mimeType", "image/png"}});
  return append(w.gltf["textures"], nlohmann::json{{"source", image}});
}

nlohmann::json nodeAt(const std::string& name, const glm::dvec3& translation, int mesh) {
  nlohmann::json node = {{"name", name}, {"translation", {translation.x, translation.y, translation.z}}};
  if (mesh >= 0) node["mesh"] = mesh;
  return node;
}

int addNode(GlbWriter& w, nlohmann::json node) {
  const int index = append(w.gltf["nodes"], std::move(node));
  w.gltf["scenes"][0]["nodes"].push_back(index);
  return index;
}

int addChild(GlbWriter& w, int parent, nlohmann::json node) {
  const int index = append(w.gltf["nodes"], std::move(node));
  w.gltf["nodes"][size_t(parent)]["children"].push_back(index);
  return index;
}

void addAnimation(GlbWriter& w, const std::string& name, const std::vector<float>& times,
                  const std::vector<Track>& tracks) {
  constexpr const char* types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
  constexpr const char* extension = "KHR_animation_pointer";
  const auto floats = [&](const std::vector<float>& values, int width) {
    return append(w.gltf["accessors"], nlohmann::json{{"bufferView", addView(w, values)},
                                                      {"componentType", floatType},
                                                      {"count", values.size() / size_t(width)},
                                                      {"type", types[width]}});
  };
  const int input = floats(times, 1);
  w.gltf["accessors"][size_t(input)]["min"] = {times.front()};
  w.gltf["accessors"][size_t(input)]["max"] = {times.back()};
  nlohmann::json samplers = nlohmann::json::array(), channels = nlohmann::json::array();
  for (const Track& track : tracks) {
    const int sampler =
        append(samplers, nlohmann::json{{"input", input}, {"output", floats(track.values, track.width)}});
    nlohmann::json target = {{"node", track.node}, {"path", track.path}};
    if (track.path.starts_with('/')) {
      useExtension(w, extension);
      target = {{"path", "pointer"}, {"extensions", {{extension, {{"pointer", track.path}}}}}};
    }
    channels.push_back({{"sampler", sampler}, {"target", target}});
  }
  w.gltf["animations"].push_back({{"name", name}, {"samplers", samplers}, {"channels", channels}});
}

void useExtension(GlbWriter& w, const std::string& name) {
  nlohmann::json& used = w.gltf["extensionsUsed"];
  for (const nlohmann::json& known : used)
    if (known == name) return;
  used.push_back(name);
}

int addLight(GlbWriter& w, const std::string& name, double candela) {
  useExtension(w, lightsExtension);
  return append(w.gltf["extensions"][lightsExtension]["lights"],
                nlohmann::json{{"name", name}, {"type", "point"}, {"intensity", candela}});
}

int addPointLight(GlbWriter& w, const std::string& name, const glm::dvec3& position, double candela) {
  const int light = addLight(w, name, candela);
  addNode(w, {{"name", name},
              {"translation", {position.x, position.y, position.z}},
              {"extensions", {{lightsExtension, {{"light", light}}}}}});
  return light;
}

std::vector<uint8_t> glb(const GlbWriter& w) {
  nlohmann::json gltf = w.gltf;
  gltf["buffers"] = {{{"byteLength", w.binary.size()}}};
  return glbContainer(gltf.dump(), w.binary);
}

}  // namespace facet::scene
