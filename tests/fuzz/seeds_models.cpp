#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <string>

#include "fuzz/seeds.hpp"
#include "support/gltf_builder.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"

namespace facet::fuzz {

namespace {

using test::GltfBuilder;
using Json = nlohmann::json;

Bytes smallPng() { return test::pngBytes(2, 2, 3, 8, ramp(12)); }

// Every attribute, a sparse accessor, two materials.
GltfBuilder dressed() {
  GltfBuilder b = test::triangle();
  Json& primitive = b.json["meshes"][0]["primitives"][0];
  Json& attributes = primitive["attributes"];
  attributes["NORMAL"] = b.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, test::floatType, "VEC3");
  attributes["TANGENT"] = b.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, test::floatType, "VEC4");
  attributes["TEXCOORD_0"] = b.add(std::vector<uint16_t>{0, 0, 65535, 0, 0, 65535}, test::ushortType, "VEC2", true);
  attributes["COLOR_0"] = b.add(ramp(12), test::ubyteType, "VEC4", true);
  primitive["indices"] = b.add(std::vector<uint8_t>{0, 1, 2}, test::ubyteType, "SCALAR");
  primitive["material"] = 0;
  const int view = b.addView(smallPng());
  b.append("images", {{"bufferView", view}, {"mimeType", "image/png"}});
  b.append("images", {{"uri", test::dataUri(smallPng(), "image/png")}});
  b.append("samplers", {{"magFilter", 9728}, {"minFilter", 9987}, {"wrapS", 33071}});
  b.append("textures", {{"source", 0}, {"sampler", 0}});
  b.append("textures", {{"source", 1}});
  const Json transform = {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"rotation", 1}, {"scale", {2, 2}}}}};
  b.append("materials", {{"name", "painted"},
                         {"alphaMode", "MASK"},
                         {"alphaCutoff", 0.3},
                         {"doubleSided", true},
                         {"normalTexture", {{"index", 1}, {"scale", 0.5}}},
                         {"occlusionTexture", {{"index", 0}, {"strength", 0.5}}},
                         {"emissiveFactor", {1, 0.5, 0}},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", {1, 0.5, 0.25, 1}},
                           {"metallicFactor", 0.5},
                           {"baseColorTexture", {{"index", 0}, {"extensions", transform}}},
                           {"metallicRoughnessTexture", {{"index", 1}}}}}});
  b.append("materials",
           {{"extensions",
             {{"KHR_materials_clearcoat", {{"clearcoatFactor", 1}, {"clearcoatNormalTexture", {{"index", 0}}}}},
              {"KHR_materials_sheen", {{"sheenColorFactor", {1, 1, 1}}, {"sheenRoughnessFactor", 0.5}}},
              {"KHR_materials_transmission", {{"transmissionFactor", 1}}},
              {"KHR_materials_volume",
               {{"thicknessFactor", 1}, {"attenuationDistance", 2}, {"attenuationColor", {1, 0, 0}}}},
              {"KHR_materials_ior", {{"ior", 1.4}}},
              {"KHR_materials_dispersion", {{"dispersion", 0.2}}},
              {"KHR_materials_specular", {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0}}}},
              {"KHR_materials_iridescence", {{"iridescenceFactor", 1}, {"iridescenceThicknessMaximum", 300}}},
              {"KHR_materials_anisotropy", {{"anisotropyStrength", 0.5}, {"anisotropyRotation", 1}}},
              {"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}},
              {"KHR_materials_diffuse_transmission", {{"diffuseTransmissionFactor", 0.5}}}}}});
  b.append("materials",
           {{"extensions",
             {{"KHR_materials_unlit", Json::object()},
              {"KHR_materials_pbrSpecularGlossiness",
               {{"diffuseFactor", {1, 1, 1, 1}}, {"specularFactor", {1, 1, 1}}, {"glossinessFactor", 0.5}}}}}});
  return b;
}

// Skin, morph targets, instances, lights, cameras, animations of all of them.
GltfBuilder moving() {
  GltfBuilder b = test::triangle();
  Json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["JOINTS_0"] = b.add(Bytes{0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, test::ubyteType, "VEC4");
  primitive["attributes"]["WEIGHTS_0"] = b.add(Bytes(12, 64), test::ubyteType, "VEC4", true);
  primitive["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
  b.json["meshes"][0]["weights"] = {0.25, 0.5};
  const int matrices = b.addView(std::vector<float>(32, 0.5f));
  const int inverse =
      b.addAccessor({{"bufferView", matrices}, {"componentType", 5126}, {"type", "MAT4"}, {"count", 2}});
  b.append("skins", {{"joints", {0, 1}}, {"inverseBindMatrices", inverse}, {"skeleton", 0}});
  b.append("nodes", {{"mesh", 0}, {"skin", 0}, {"weights", {0, 1}}, {"children", {2, 3}}});
  b.append("nodes", {{"camera", 0}, {"rotation", {0, 0.6, 0, 0.8}}, {"scale", {1, 2, -3}}});
  b.append("nodes",
           {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 2, 3, 1}},
            {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}, {"KHR_node_visibility", {{"visible", true}}}}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["nodes"][1]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", 0}, {"SCALE", 0}};
  b.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}, {"zfar", 10}}}});
  b.append("cameras",
           {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}}}});
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {
      {{"type", "spot"}, {"range", 4}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", 0.5}}}},
      {{"type", "directional"}, {"intensity", 3}, {"color", {1, 0.5, 0}}}};
  const int times = b.add(std::vector<float>{0, 1}, test::floatType, "SCALAR");
  const int twelve = b.add(std::vector<float>(12, 0.25f), test::floatType, "SCALAR");
  const int turns = b.add(std::vector<float>{0, 0, 0, 1, 0, 1, 0, 0}, test::floatType, "VEC4");
  const int places = b.add(std::vector<float>{0, 0, 0, 1, 2, 3}, test::floatType, "VEC3");
  const Json aim = {{"KHR_animation_pointer", {{"pointer", "/nodes/1/weights/1"}}}};
  const Json light = {{"KHR_animation_pointer", {{"pointer", "/extensions/KHR_lights_punctual/lights/0/intensity"}}}};
  b.append("animations", {{"name", "all"},
                          {"samplers",
                           {{{"input", times}, {"output", twelve}, {"interpolation", "CUBICSPLINE"}},
                            {{"input", times}, {"output", times}},
                            {{"input", times}, {"output", turns}},
                            {{"input", times}, {"output", places}, {"interpolation", "STEP"}}}},
                          {"channels",
                           {{{"sampler", 0}, {"target", {{"node", 1}, {"path", "weights"}}}},
                            {{"sampler", 1}, {"target", {{"path", "pointer"}, {"extensions", aim}}}},
                            {{"sampler", 1}, {"target", {{"path", "pointer"}, {"extensions", light}}}},
                            {{"sampler", 2}, {"target", {{"node", 2}, {"path", "rotation"}}}},
                            {{"sampler", 3}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  return b;
}

GltfBuilder odd() {
  GltfBuilder b = test::triangle();
  const int indices = b.addView(std::vector<uint16_t>{1, 2});
  const int values = b.addView(std::vector<float>{1, 2, 3, 4, 5, 6});
  b.append("accessors", {{"componentType", 5126},
                         {"count", 3},
                         {"type", "VEC3"},
                         {"sparse",
                          {{"count", 2},
                           {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                           {"values", {{"bufferView", values}}}}}});
  b.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = 1;
  for (const int mode : {0, 1, 2, 3, 5, 6}) {
    Json primitive = b.json["meshes"][0]["primitives"][0];
    primitive["mode"] = mode;
    b.json["meshes"][0]["primitives"].push_back(primitive);
  }
  b.append("materials", {{"name", "a"}});
  b.append("materials", {{"name", "b"}});
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "one"}}, {{"name", "two"}}};
  b.json["meshes"][0]["primitives"][0]["extensions"]["KHR_materials_variants"]["mappings"] = {
      {{"material", 1}, {"variants", {0, 1}}}};
  b.json["extensions"]["KHR_xmp_json_ld"]["packets"] = {{{"@context", Json::object()}, {"dc:title", "t"}}};
  b.json["asset"]["extensions"]["KHR_xmp_json_ld"]["packet"] = 0;
  b.append("textures",
           {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}, {"EXT_texture_webp", {{"source", 1}}}}}});
  b.append("images", {{"uri", test::dataUri(test::fromHex(test::uastcAlpha), "image/ktx2")}});
  b.append("images", {{"uri", "data:image/webp;base64,UklGRg=="}});
  b.append("images", {{"uri", "missing.png"}});
  return b;
}

Bytes head(std::initializer_list<size_t> numbers, const Bytes& rest) {
  Bytes out;
  for (const size_t n : numbers) out.push_back(static_cast<uint8_t>(n >> 8)), out.push_back(static_cast<uint8_t>(n));
  out.insert(out.end(), rest.begin(), rest.end());
  return out;
}

template <class V>
void addDraco(draco::Mesh& mesh, draco::GeometryAttribute::Type type, draco::DataType data, int components, uint32_t id,
              const std::vector<V>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<int8_t>(components), data, data != draco::DT_FLOAT32, sizeof(V), 0);
  const int index = mesh.AddAttribute(attribute, true, static_cast<uint32_t>(values.size()));
  for (uint32_t i = 0; i < values.size(); ++i)
    mesh.attribute(index)->SetAttributeValue(draco::AttributeValueIndex(i), &values[i]);
  mesh.attribute(index)->set_unique_id(id);
}

// A waved sheet of side x side vertices.
Bytes dracoSheet(uint32_t side, draco::MeshEncoderMethod method, int bits, int speed) {
  std::vector<glm::vec3> positions, normals;
  std::vector<std::array<uint8_t, 4>> colors;
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      positions.emplace_back(x, y, std::sin(static_cast<float>(x + y)));
      normals.push_back(glm::normalize(glm::vec3(0.1f * static_cast<float>(x), 0.2f, 1)));
      colors.push_back({static_cast<uint8_t>(40 * x), static_cast<uint8_t>(40 * y), 255, 100});
    }
  draco::Mesh mesh;
  mesh.set_num_points(side * side);
  addDraco(mesh, draco::GeometryAttribute::POSITION, draco::DT_FLOAT32, 3, 0, positions);
  addDraco(mesh, draco::GeometryAttribute::NORMAL, draco::DT_FLOAT32, 3, 1, normals);
  addDraco(mesh, draco::GeometryAttribute::COLOR, draco::DT_UINT8, 4, 2, colors);
  for (uint32_t y = 0; y + 1 < side; ++y)
    for (uint32_t x = 0; x + 1 < side; ++x) {
      const uint32_t a = side * y + x;
      for (const auto& corners : {std::array{a, a + 1, a + side}, std::array{a + side, a + 1, a + side + 1}}) {
        draco::Mesh::Face face;
        for (size_t c = 0; c < 3; ++c) face[c] = draco::PointIndex(corners[c]);
        mesh.AddFace(face);
      }
    }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  encoder.SetSpeedOptions(speed, speed);
  if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, bits);
  if (bits > 0) encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, bits);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok()) return {};
  return {buffer.data(), buffer.data() + buffer.size()};
}

}  // namespace

std::vector<Bytes> gltfSeeds() {
  std::vector<Bytes> out;
  for (const GltfBuilder& b : {test::triangle(), dressed(), moving(), odd()}) {
    out.push_back(b.glb());
    out.push_back(bytesOf(b.text()));
  }
  return out;
}

std::vector<Bytes> iesSeeds() {
  return texts({"IESNA:LM-63-2002\nTILT=NONE\n1 1000 2 3 1 1 2 0 0 0\n1 1 10\n0 45 90\n0\n9 8 7\n",
                "IESNA:LM-63-1995\n[TEST] x\nTILT=INCLUDE\n1 2 0 90 1 .5\n1 -1 1 3 3 1 1 0 0 0 1 1 10\n0 90 180\n"
                "0 45 90\n1 2 3 1,4,5 1 6 7\n",
                "IES:LM-63-2019\nTILT=NONE\n1 1 1 2 3 2 1 0 0 0 1 1 1 -90 90 -90 0 90 1 2 3 4 5 6",
                "IESNA91\nTILT=a\n1 1 1 3 2 3 1 0 0 0 1 1 1 -90 0 90 0 90 1 2 3 4 5 6"});
}

std::vector<Bytes> lightsSeeds() {
  GltfBuilder b = test::triangle();
  Json level = Json::array();
  for (size_t face = 0; face < 6; ++face)
    level.push_back(
        b.append("images", {{"uri", test::dataUri(test::pngBytes(2, 2, 4, 8, ramp(16, 7 + face)), "image/png")}}));
  b.json["extensions"]["EXT_lights_image_based"]["lights"] = {{{"specularImages", {level}},
                                                               {"specularImageSize", 2},
                                                               {"intensity", 2},
                                                               {"rotation", {0, 0.6, 0, 0.8}},
                                                               {"irradianceCoefficients", Json::array()}}};
  for (int i = 0; i < 9; ++i)
    b.json["extensions"]["EXT_lights_image_based"]["lights"][0]["irradianceCoefficients"].push_back({1, 0.5, -0.25});
  b.json["extensionsUsed"] = {"EXT_lights_image_based"};
  b.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 0;
  return {b.glb(), bytesOf(b.text())};
}

std::vector<Bytes> glbSeeds() {
  const Bytes one = test::triangle().glb();
  Bytes three = test::glbBytes("{}", ramp(8)), text = test::glbBytes("{}  ", {});
  three.insert(three.end(), {4, 0, 0, 0, 'X', 'Y', 'Z', 0, 1, 2, 3, 4});
  three[8] = static_cast<uint8_t>(three.size());
  return {one, three, text, Bytes(one.begin(), one.begin() + 12)};
}

std::vector<Bytes> dracoSeeds() {
  std::vector<Bytes> out;
  const size_t ids = 0 + 16 * 1 + 256 * 2;
  for (const auto method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING})
    for (const int bits : {0, 10})
      for (const int speed : {0, 5, 10}) {
        if (bits == 0 && method == draco::MESH_EDGEBREAKER_ENCODING && speed == 0) continue;
        out.push_back(head({16, 54, ids}, dracoSheet(4, method, bits, speed)));
      }
  return out;
}

std::vector<Bytes> meshoptSeeds() {
  std::vector<Bytes> out;
  const std::vector<float> vertices = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0, 3, 1, 0};
  Bytes encoded(meshopt_encodeVertexBufferBound(6, 12));
  encoded.resize(meshopt_encodeVertexBuffer(encoded.data(), encoded.size(), vertices.data(), 6, 12));
  for (const size_t filter : {0, 3}) out.push_back(head({3 * filter, 6, 12}, encoded));
  const Bytes quantized = ramp(48);
  Bytes eight(meshopt_encodeVertexBufferBound(6, 8));
  eight.resize(meshopt_encodeVertexBuffer(eight.data(), eight.size(), quantized.data(), 6, 8));
  for (const size_t filter : {1, 2}) out.push_back(head({3 * filter, 6, 8}, eight));
  const std::vector<uint32_t> indices = {0, 1, 2, 2, 1, 3};
  Bytes triangles(meshopt_encodeIndexBufferBound(6, 4)), sequence(meshopt_encodeIndexSequenceBound(6, 4));
  triangles.resize(meshopt_encodeIndexBuffer(triangles.data(), triangles.size(), indices.data(), 6));
  sequence.resize(meshopt_encodeIndexSequence(sequence.data(), sequence.size(), indices.data(), 6));
  out.push_back(head({1, 6, 2}, triangles)), out.push_back(head({2, 6, 4}, sequence));
  return out;
}

}  // namespace facet::fuzz
