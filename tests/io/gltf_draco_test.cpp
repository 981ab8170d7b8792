// KHR_draco_mesh_compression, with data from Draco's own encoder.

#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;
using Bytes = std::vector<uint8_t>;
using Type = draco::GeometryAttribute;

constexpr const char* name = "KHR_draco_mesh_compression";
constexpr uint32_t positionId = 7, normalId = 3, colourId = 5;  // not their order

// A dome of 5 x 5 vertices over [0, 4] x [0, 4].
struct Dome {
  std::vector<glm::vec3> positions, normals;
  std::vector<std::array<uint8_t, 4>> colours;
  std::vector<uint32_t> indices;
};

Dome dome() {
  Dome d;
  for (uint32_t y = 0; y < 5; ++y) {
    for (uint32_t x = 0; x < 5; ++x) {
      const glm::vec2 p(x, y), away = (p - glm::vec2(2)) * 0.3f;
      d.normals.push_back(glm::normalize(glm::vec3(away, 1)));
      d.positions.push_back({p, 0.31f * d.normals.back().z});
      d.colours.push_back({static_cast<uint8_t>(51 * x), static_cast<uint8_t>(51 * y), 255, 102});
    }
  }
  for (uint32_t y = 0; y < 4; ++y) {
    for (uint32_t x = 0; x < 4; ++x) {
      const uint32_t a = 5 * y + x;
      for (const uint32_t i : {a, a + 1, a + 5, a + 5, a + 1, a + 6}) d.indices.push_back(i);
    }
  }
  return d;
}

template <class V>
void addTo(draco::Mesh& mesh, Type::Type type, draco::DataType data, int components, uint32_t id,
           const std::vector<V>& values) {
  draco::GeometryAttribute attribute;
  attribute.Init(type, nullptr, static_cast<int8_t>(components), data, data != draco::DT_FLOAT32, sizeof(V), 0);
  const int index = mesh.AddAttribute(attribute, true, static_cast<uint32_t>(values.size()));
  for (uint32_t i = 0; i < values.size(); ++i) {
    mesh.attribute(index)->SetAttributeValue(draco::AttributeValueIndex(i), &values[i]);
  }
  mesh.attribute(index)->set_unique_id(id);
}

// The mesh with the dome's triangles. bits: of the quantisation; 0: none.
Bytes encode(draco::Mesh& mesh, const Dome& d, draco::MeshEncoderMethod method, int positionBits, int normalBits) {
  mesh.SetNumFaces(d.indices.size() / 3);
  for (uint32_t f = 0; f < d.indices.size() / 3; ++f) {
    draco::Mesh::Face face;
    for (uint32_t c = 0; c < 3; ++c) face[c] = draco::PointIndex(d.indices[3 * f + c]);
    mesh.SetFace(draco::FaceIndex(f), face);
  }
  draco::Encoder encoder;
  encoder.SetEncodingMethod(method);
  if (positionBits > 0) encoder.SetAttributeQuantization(Type::POSITION, positionBits);
  if (normalBits > 0) encoder.SetAttributeQuantization(Type::NORMAL, normalBits);
  draco::EncoderBuffer buffer;
  REQUIRE(encoder.EncodeMeshToBuffer(mesh, &buffer).ok());
  return Bytes(buffer.data(), buffer.data() + buffer.size());
}

Bytes encode(const Dome& d, draco::MeshEncoderMethod method, int positionBits, int normalBits) {
  draco::Mesh mesh;
  mesh.set_num_points(static_cast<uint32_t>(d.positions.size()));
  addTo(mesh, Type::POSITION, draco::DT_FLOAT32, 3, positionId, d.positions);
  addTo(mesh, Type::NORMAL, draco::DT_FLOAT32, 3, normalId, d.normals);
  addTo(mesh, Type::COLOR, draco::DT_UINT8, 4, colourId, d.colours);
  return encode(mesh, d, method, positionBits, normalBits);
}

// Accessors without views, as the extension allows.
GltfBuilder file(const Bytes& encoded) {
  GltfBuilder b;
  const int view = b.addView(encoded);
  const auto accessor = [&](int component, const char* type, int count, bool normalized = false) {
    return b.addAccessor({{"componentType", component}, {"type", type}, {"count", count}, {"normalized", normalized}});
  };
  const Json ids = {{"POSITION", positionId}, {"NORMAL", normalId}, {"COLOR_0", colourId}};
  Json primitive;
  primitive["attributes"] = {{"POSITION", accessor(5126, "VEC3", 25)},
                             {"NORMAL", accessor(5126, "VEC3", 25)},
                             {"COLOR_0", accessor(5121, "VEC4", 25, true)}};
  primitive["indices"] = accessor(5123, "SCALAR", 96);
  primitive["extensions"][name] = {{"bufferView", view}, {"attributes", ids}};
  Json mesh;
  mesh["primitives"].push_back(primitive);
  b.append("meshes", mesh);
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {name};
  return b;
}

Bytes sequential() { return encode(dome(), draco::MESH_SEQUENTIAL_ENCODING, 0, 0); }
Bytes edgebreaker() { return encode(dome(), draco::MESH_EDGEBREAKER_ENCODING, 14, 10); }

Json& firstPrimitive(GltfBuilder& b) { return b.json["meshes"][0]["primitives"][0]; }

// The original vertex at a decoded position.
size_t original(const glm::vec3& p) {
  return static_cast<size_t>(std::lround(p.y)) * 5 + static_cast<size_t>(std::lround(p.x));
}

}  // namespace

TEST_CASE("Draco: sequential without quantisation is lossless", "[io][draco]") {
  const Dome d = dome();
  const auto model = loaded(file(sequential()));
  CHECK(notes(model) == "");
  const auto& p = primitive(model);
  CHECK(p.topology == scene::Topology::triangles);
  CHECK(p.positions == d.positions);
  CHECK(p.indices == d.indices);
  REQUIRE(p.normals.size() == 25);
  REQUIRE(p.colors.size() == 25);
  for (size_t i = 0; i < 25; ++i) {
    CHECK(glm::length(p.normals[i] - d.normals[i]) < 1e-6f);
    const auto& c = d.colours[i];
    CHECK(p.colors[i] == glm::vec4(c[0] / 255.0f, c[1] / 255.0f, 1, 102 / 255.0f));
  }
  CHECK(p.bounds.max.x == 4);
}

TEST_CASE("Draco: joints and weights", "[io][draco][skins]") {
  const Dome d = dome();
  std::vector<std::array<uint16_t, 4>> joints;
  std::vector<glm::vec4> weights;
  for (uint16_t i = 0; i < 25; ++i) {
    const auto share = static_cast<float>(i) / 32;  // below 1/2 the second joint has more
    joints.push_back({i, 30, 0, 0});
    weights.push_back({share, 1 - share, 0, 0});
  }
  draco::Mesh mesh;
  mesh.set_num_points(25);
  addTo(mesh, Type::POSITION, draco::DT_FLOAT32, 3, positionId, d.positions);
  addTo(mesh, Type::GENERIC, draco::DT_UINT16, 4, 1, joints);
  addTo(mesh, Type::GENERIC, draco::DT_FLOAT32, 4, 2, weights);
  const Bytes encoded = encode(mesh, d, draco::MESH_SEQUENTIAL_ENCODING, 0, 0);
  GltfBuilder b = file(encoded);
  const auto accessor = [&](int component) {
    return b.addAccessor({{"componentType", component}, {"type", "VEC4"}, {"count", 25}});
  };
  Json& p = firstPrimitive(b);
  p["attributes"] = {{"POSITION", 0}, {"JOINTS_0", accessor(5123)}, {"WEIGHTS_0", accessor(5126)}};
  p["extensions"][name]["attributes"] = {{"POSITION", positionId}, {"JOINTS_0", 1}, {"WEIGHTS_0", 2}};
  CHECK(primitive(loaded(b)).influences.empty());  // no skin
  Json skinJoints;
  for (int i = 0; i < 31; ++i) skinJoints.push_back(b.append("nodes", Json::object()));
  b.append("skins", {{"joints", skinJoints}});
  b.append("nodes", {{"mesh", 0}, {"skin", 0}});
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  const auto& influences = primitive(model).influences;
  REQUIRE(primitive(model).influencesPerVertex == 2);
  REQUIRE(influences.size() == 50);
  for (uint32_t i = 0; i < 25; ++i) {
    const auto &first = influences[2 * i], &second = influences[2 * i + 1];
    const bool own = i >= 16;  // at one half the order of the file counts
    CHECK(first.joint == (own ? i : 30));
    CHECK(first.weight == Approx(own ? i / 32.0 : 1 - i / 32.0).epsilon(1e-6));
    CHECK(second.joint == (own ? 30 : i));
    CHECK(second.weight == Approx(own ? 1 - i / 32.0 : i / 32.0).epsilon(1e-6));
  }
}

TEST_CASE("Draco: quantised values lie within half a step", "[io][draco]") {
  for (const int bits : {8, 11, 14}) {
    INFO(bits);
    const Dome d = dome();
    const auto model = loaded(file(encode(d, draco::MESH_SEQUENTIAL_ENCODING, bits, bits)));
    const auto& p = primitive(model);
    // One step for all axes: the largest extent, 4, over 2^bits - 1. Octahedral normals: half a step of 2 / (2^bits -
    // 2) in two coordinates, stretched by at most 3.
    const float step = 4.0f / static_cast<float>((1 << bits) - 1),
                normalStep = 2.0f / static_cast<float>((1 << bits) - 2);
    float position = 0, normal = 0;
    for (size_t i = 0; i < 25; ++i) {
      for (int c = 0; c < 3; ++c) position = std::max(position, std::abs(p.positions[i][c] - d.positions[i][c]));
      normal = std::max(normal, glm::length(p.normals[i] - d.normals[i]));
    }
    CHECK(position <= 0.501f * step);
    CHECK(position > 0.2f * step);
    CHECK(normal < 1.5f * normalStep);
    CHECK(normal > 0.1f * normalStep);
  }
}

TEST_CASE("Draco: edgebreaker gives the same triangles in another order", "[io][draco]") {
  const Dome d = dome();
  const auto model = loaded(file(edgebreaker()));
  const auto& p = primitive(model);
  REQUIRE(p.positions.size() == 25);
  const auto sorted = [](const std::vector<uint32_t>& indices, const auto& map) {
    std::vector<std::array<size_t, 3>> result;
    for (size_t i = 0; i + 2 < indices.size(); i += 3) {
      std::array<size_t, 3> t = {map(indices[i]), map(indices[i + 1]), map(indices[i + 2])};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      result.push_back(t);
    }
    std::sort(result.begin(), result.end());
    return result;
  };
  CHECK(sorted(p.indices, [&](uint32_t i) { return original(p.positions[i]); }) ==
        sorted(d.indices, [](uint32_t i) { return static_cast<size_t>(i); }));
  for (size_t i = 0; i < 25; ++i) {
    const size_t o = original(p.positions[i]);
    CHECK(glm::length(p.positions[i] - d.positions[o]) < 4.0f / 16383);
    CHECK(glm::length(p.normals[i] - d.normals[o]) < 3.0f / 1022);
    CHECK(p.colors[i].x == d.colours[o][0] / 255.0f);
  }
}

TEST_CASE("Draco: attributes beside the compressed ones, other types, strips", "[io][draco]") {
  GltfBuilder b = file(sequential());
  std::vector<float> uv(50);
  for (size_t i = 0; i < uv.size(); ++i) uv[i] = static_cast<float>(i);
  attributes(b)["TEXCOORD_0"] = b.add(uv, test::floatType, "VEC2");
  b.json["accessors"][2]["componentType"] = 5123;  // the data has bytes
  b.json["accessors"][2]["normalized"] = false;
  auto model = loaded(b);
  CHECK(primitive(model).texCoords[0][24] == glm::vec2(48, 49));
  CHECK(primitive(model).colors[6].x == 51 / 65535.0f);

  b = file(sequential());
  firstPrimitive(b)["mode"] = 5;
  b.json["accessors"][3]["count"] = 34;
  model = loaded(b);
  CHECK(primitive(model).topology == scene::Topology::triangles);
  CHECK(primitive(model).indices.size() == 96);
}

TEST_CASE("Draco: what is broken is refused", "[io][draco]") {
  const std::string head = "m: /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression";
  const std::string end = "; export the model again, or without Draco compression.";
  const auto refused = [&](const Bytes& bytes, void (*breakIt)(GltfBuilder&)) {
    GltfBuilder b = file(bytes);
    breakIt(b);
    const std::string text = outcome(b.text());
    if (!text.starts_with(head) || !text.ends_with(end)) return text;
    return text.substr(head.size(), text.size() - head.size() - end.size());
  };
  const auto extension = [](GltfBuilder& b) -> Json& { return firstPrimitive(b)["extensions"][name]; };
  static const auto ext = extension;
  const auto shorter = [](Bytes bytes, size_t size) {
    bytes.resize(size);
    return bytes;
  };
  const auto nothing = [](GltfBuilder&) {};
  const Bytes good = sequential(), edge = edgebreaker();
  CHECK(refused(good, nothing) == "loaded");
  CHECK(refused(Bytes(40, 'x'), nothing) == ": its data is not Draco data");
  CHECK(refused(shorter(good, 7), nothing) == ": its data is not Draco data");
  CHECK(refused(shorter(good, 11), nothing) == ": its data has a damaged header");
  for (const Bytes& bytes : {good, edge}) {
    for (const size_t size : {bytes.size() / 4, bytes.size() / 2, bytes.size() - 1}) {
      CHECK(refused(shorter(bytes, size), nothing).starts_with(": its data is damaged or too short"));
    }
  }
  Bytes changed = good;
  changed[6] = 1;
  CHECK(refused(changed, nothing) == ": its data has the Draco bitstream version 2.1; glTF allows only 2.2");
  changed = good;
  changed[7] = 0;
  CHECK(refused(changed, nothing) == ": its data holds no mesh");
  for (const Bytes& bytes : {good, edge}) {
    CHECK(refused(bytes, [](GltfBuilder& b) { b.json["accessors"][3]["count"] = 93; }) ==
          ": its data has 32 triangles, but the accessor of the indices has 93 elements");
    CHECK(refused(bytes, [](GltfBuilder& b) {
            for (int i = 0; i < 3; ++i) b.json["accessors"][i]["count"] = 24;
          }) == ": its data has 25 vertices, but the accessors have 24 elements");
  }
  CHECK(refused(good, [](GltfBuilder& b) { ext(b)["attributes"]["NORMAL"] = 4; }) ==
        "/attributes/NORMAL: its data has no attribute with the identifier 4");
  CHECK(refused(good, [](GltfBuilder& b) { ext(b)["attributes"]["NORMAL"] = colourId; }) ==
        "/attributes/NORMAL: its data has 4 components, but the accessor has 3");
  CHECK(refused(good, [](GltfBuilder& b) { ext(b)["attributes"]["NORMAL"] = -1; }) ==
        "/attributes/NORMAL: is not a whole number from 0 on");
  CHECK(refused(good, [](GltfBuilder& b) { ext(b)["attributes"]["TANGENT"] = 1; }) ==
        "/attributes/TANGENT: is no attribute of the primitive");
  CHECK(refused(good, [](GltfBuilder& b) { ext(b).erase("attributes"); }) == "/attributes: is not an object");
  CHECK(refused(good, [](GltfBuilder& b) { ext(b).erase("bufferView"); }) == "/bufferView: is not a whole number");
  CHECK(refused(good, [](GltfBuilder& b) { ext(b)["bufferView"] = 1; }) ==
        head + "/bufferView: buffer view 1 does not exist; there are 1; export the model again.");
  CHECK(refused(good, [](GltfBuilder& b) { firstPrimitive(b)["mode"] = 0; }) ==
        ": is for triangles and triangle strips only");
  CHECK(refused(good, [](GltfBuilder& b) { firstPrimitive(b).erase("indices"); }) ==
        "m: /meshes/0/primitives/0: has Draco data, but no accessor for indices" + end);
  CHECK(refused(good, [](GltfBuilder& b) { b.json["accessors"][1]["componentType"] = 5120; }) == "loaded");
}

TEST_CASE("Draco: truth values are refused, whatever their bytes hold", "[io][draco]") {
  const Dome d = dome();
  draco::Mesh mesh;
  mesh.set_num_points(25);
  addTo(mesh, Type::POSITION, draco::DT_FLOAT32, 3, positionId, d.positions);
  addTo(mesh, Type::GENERIC, draco::DT_BOOL, 3, normalId, std::vector<std::array<uint8_t, 3>>(25, {0, 1, 144}));
  addTo(mesh, Type::COLOR, draco::DT_UINT8, 4, colourId, d.colours);
  GltfBuilder b = file(encode(mesh, d, draco::MESH_SEQUENTIAL_ENCODING, 0, 0));
  CHECK(outcome(b.text()).find("/attributes/NORMAL: its data are truth values, which glTF has none of") !=
        std::string::npos);
}

TEST_CASE("Draco: a header that claims very much is refused before memory is taken", "[io][draco]") {
  // "DRACO", 2.2, mesh, sequential, no flags, 300 000 000 triangles and 25 points as varints
  const Bytes bytes = {'D', 'R', 'A', 'C', 'O', 2, 2, 1, 0, 0, 0, 0x80, 0xc6, 0x86, 0x8f, 0x01, 25};
  GltfBuilder b = file(bytes);
  b.json["accessors"][3]["count"] = 900000000;
  CHECK(outcome(b.text()) ==
        "m: /meshes/0/primitives/0/extensions/KHR_draco_mesh_compression: 17 bytes are too few for 300000000 "
        "triangles; export the model again, or without Draco compression.");
}

TEST_CASE("Draco: random damage never crashes", "[io][draco]") {
  uint32_t state = 5;
  const auto random = [&] { return state = state * 1664525u + 1013904223u; };
  for (const Bytes& good : {sequential(), edgebreaker()}) {
    size_t ok = 0;
    for (int round = 0; round < 1500; ++round) {
      Bytes bytes = good;
      for (int change = 0; change < 1 + round % 3; ++change) {
        bytes[random() % bytes.size()] = static_cast<uint8_t>(random() >> 24);
      }
      ok += io::loadGltfBytes(file(bytes).glb(), "m").has_value();
    }
    CHECK(ok > 0);
    CHECK(ok < 1500);
  }
}
