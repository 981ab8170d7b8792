#include "support/broken_gltf.hpp"

#include <algorithm>

#include "io/validate/validate.hpp"

namespace facet::test {

namespace {

using Json = nlohmann::json;

constexpr int vertices = 34962, indices = 34963;

template <class T>
int add(GltfBuilder& b, const std::vector<T>& values, Component component, const std::string& type, int target = 0,
        bool bounds = false) {
  const size_t width = type == "SCALAR" ? 1 : type == "MAT4" ? 16 : static_cast<size_t>(type.back() - '0');
  const int view = b.addView(values);
  if (target != 0) b.json["bufferViews"][static_cast<size_t>(view)]["target"] = target;
  Json accessor = {
      {"bufferView", view}, {"componentType", component}, {"count", values.size() / width}, {"type", type}};
  for (size_t i = 0; bounds && i < width; ++i) {
    T low = values[i], high = values[i];
    for (size_t k = i; k < values.size(); k += width) low = std::min(low, values[k]), high = std::max(high, values[k]);
    accessor["min"].push_back(low);
    accessor["max"].push_back(high);
  }
  return b.addAccessor(accessor);
}

template <class T>
std::vector<T> times(int n, const std::vector<T>& values) {
  std::vector<T> out;
  for (int i = 0; i < n; ++i)
    for (const T& v : values) out.push_back(v);
  return out;
}

std::vector<uint8_t> picture(uint32_t size) {
  return pngBytes(size, size, 3, 8, std::vector<uint8_t>(size_t{3} * size * size, 128));
}

// Accessors 0 to 16.
void addAccessors(GltfBuilder& b) {
  const std::vector<float> corners = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  const std::vector<float> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  add(b, corners, floatType, "VEC3", vertices, true);
  add(b, times<float>(3, {0, 0, 1}), floatType, "VEC3", vertices);
  add(b, times<float>(3, {1, 0, 0, 1}), floatType, "VEC4", vertices);
  add(b, std::vector<float>{0, 0, 1, 0, 0, 1}, floatType, "VEC2", vertices);
  add(b, times<float>(3, {1, 0.5f, 0}), floatType, "VEC3", vertices);
  add(b, times<uint8_t>(3, {0, 1, 0, 0}), ubyteType, "VEC4", vertices);
  add(b, times<float>(3, {0.5f, 0.5f, 0, 0}), floatType, "VEC4", vertices);
  add(b, std::vector<uint16_t>{0, 1, 2}, ushortType, "SCALAR", indices);
  add(b, std::vector<float>{0, 0, 0, 0, 0, 1, 0, 0, 0}, floatType, "VEC3", vertices, true);
  add(b, times(2, identity), floatType, "MAT4");
  add(b, std::vector<float>{0, 1, 2}, floatType, "SCALAR", 0, true);
  add(b, times<float>(3, {0, 0, 0, 1}), floatType, "VEC4");
  add(b, std::vector<float>(9), floatType, "VEC3");
  add(b, std::vector<float>{0, 1, 0}, floatType, "SCALAR");
  add(b, std::vector<float>(27), floatType, "VEC3");
  add(b, corners, floatType, "VEC3", vertices, true);
  b.json["bufferViews"][15]["byteStride"] = 12;
  const int places = b.addView(std::vector<uint16_t>{1, 2}), values = b.addView(std::vector<float>{2, 0, 0, 0, 2, 0});
  Json sparse = b.json["accessors"][15];
  sparse["max"] = {2, 2, 0};
  sparse["sparse"] = {{"count", 2},
                      {"indices", {{"bufferView", places}, {"componentType", 5123}}},
                      {"values", {{"bufferView", values}}}};
  b.addAccessor(sparse);
}

}  // namespace

GltfBuilder everything() {
  GltfBuilder b;
  addAccessors(b);
  const int image = b.addView(picture(2));
  const Json rest = Json::parse(R"({
    "scene": 0, "scenes": [{"nodes": [0, 1, 3, 4, 5, 6, 7]}],
    "nodes": [{"mesh": 0, "skin": 0}, {"name": "root", "children": [2]}, {"name": "j"}, {"camera": 0},
      {"camera": 1, "translation": [0, 0, 1]}, {"mesh": 1, "rotation": [0, 0, 0, 1]}, {"mesh": 2, "weights": [0.5]},
      {"extensions": {"KHR_lights_punctual": {"light": 0}}, "matrix": [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 2, 0, 0, 1]}],
    "meshes": [
      {"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1, "TANGENT": 2, "TEXCOORD_0": 3, "COLOR_0": 4,
        "JOINTS_0": 5, "WEIGHTS_0": 6}, "indices": 7, "material": 0}]},
      {"primitives": [{"attributes": {"POSITION": 16}, "material": 1}]},
      {"primitives": [{"attributes": {"POSITION": 15}, "targets": [{"POSITION": 8}], "material": 1}]}],
    "materials": [
      {"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0.5},
       "normalTexture": {"index": 1, "scale": 1}},
      {"name": "plain", "alphaMode": "MASK", "alphaCutoff": 0.5, "emissiveFactor": [1, 1, 1], "extensions": {
        "KHR_materials_emissive_strength": {"emissiveStrength": 2}, "KHR_materials_ior": {"ior": 1.4},
        "KHR_materials_clearcoat": {"clearcoatFactor": 1}}}],
    "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
    "samplers": [{"magFilter": 9729, "minFilter": 9987, "wrapS": 10497}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 0.1, "zfar": 10}},
      {"type": "orthographic", "orthographic": {"xmag": 1, "ymag": 1, "znear": 0, "zfar": 10}}],
    "skins": [{"joints": [1, 2], "inverseBindMatrices": 9, "skeleton": 1}],
    "animations": [{
      "channels": [{"sampler": 0, "target": {"node": 1, "path": "rotation"}},
        {"sampler": 1, "target": {"node": 1, "path": "translation"}},
        {"sampler": 2, "target": {"node": 6, "path": "weights"}},
        {"sampler": 3, "target": {"node": 2, "path": "translation"}}],
      "samplers": [{"input": 10, "output": 11}, {"input": 10, "output": 12},
        {"input": 10, "output": 13, "interpolation": "STEP"}, {"input": 10, "output": 14, "interpolation": "CUBICSPLINE"}]}],
    "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior",
      "KHR_materials_clearcoat"],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "spot", "intensity": 1, "spot": {"innerConeAngle": 0.1, "outerConeAngle": 0.5}}]}}})");
  b.json.update(rest);
  b.json["images"] = {{{"bufferView", image}, {"mimeType", "image/png"}}, {{"uri", dataUri(picture(4), "image/png")}}};
  return b;
}

std::vector<std::string> findings(const std::string& text) {
  const auto* bytes = reinterpret_cast<const uint8_t*>(text.data());
  std::vector<std::string> out;
  for (const auto& f : io::validateBytes({bytes, text.size()}, "m.gltf").findings)
    out.push_back(io::validate::name(f.code) + (f.place.empty() ? "" : " " + f.place));
  std::ranges::sort(out);
  return out;
}

std::vector<std::string> findingsAfter(const std::string& edits) {
  Json json = Json::parse(everything().text());
  const Json changes = Json::parse(edits);
  for (const auto& [place, value] : changes.items()) {
    const Json::json_pointer pointer(place);
    if (value != "[removed]") {
      json[pointer] = value;
      continue;
    }
    Json& parent = json[pointer.parent_pointer()];
    parent.is_array() ? parent.erase(std::stoul(pointer.back())) : void(parent.erase(pointer.back()));
  }
  return findings(json.dump());
}

void check(const std::vector<Break>& breaks) {
  for (const Break& row : breaks) {
    INFO(row.edits);
    CHECK(findingsAfter(row.edits) == row.found);
  }
}

}  // namespace facet::test
