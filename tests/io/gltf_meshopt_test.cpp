// EXT_meshopt_compression, with data from the library's own encoders and filter inputs written by hand after the
// extension's formulas.

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "io/validate/validate.hpp"
#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;
using Bytes = std::vector<uint8_t>;

constexpr const char* meshopt = "EXT_meshopt_compression";

template <class T>
Bytes encodeVertices(const std::vector<T>& data, size_t stride) {
  const size_t count = data.size() * sizeof(T) / stride;
  Bytes out(meshopt_encodeVertexBufferBound(count, stride));
  out.resize(meshopt_encodeVertexBuffer(out.data(), out.size(), data.data(), count, stride));
  return out;
}

Bytes encodeTriangles(const std::vector<uint32_t>& indices) {
  Bytes out(meshopt_encodeIndexBufferBound(indices.size(), 100));
  out.resize(meshopt_encodeIndexBuffer(out.data(), out.size(), indices.data(), indices.size()));
  return out;
}

Bytes encodeSequence(const std::vector<uint32_t>& indices) {
  Bytes out(meshopt_encodeIndexSequenceBound(indices.size(), 100));
  out.resize(meshopt_encodeIndexSequence(out.data(), out.size(), indices.data(), indices.size()));
  return out;
}

// A view into the fallback buffer 1, which need not exist, with its data in buffer 0.
int addCompressed(GltfBuilder& b, const Bytes& encoded, size_t count, size_t stride, const char* mode,
                  const char* filter = nullptr) {
  Json extension = {{"buffer", 0},    {"byteOffset", b.bytes.size()}, {"byteLength", encoded.size()},
                    {"count", count}, {"byteStride", stride},         {"mode", mode}};
  if (filter) extension["filter"] = filter;
  for (const uint8_t byte : encoded) b.bytes.push_back(byte);
  Json view = {
      {"buffer", 1}, {"byteOffset", 0}, {"byteLength", count * stride}, {"extensions", {{meshopt, extension}}}};
  if (std::string(mode) == "ATTRIBUTES") view["byteStride"] = stride;
  b.json["buffers"] = {{{"byteLength", b.bytes.size()}},
                       {{"byteLength", 1000000}, {"extensions", {{meshopt, {{"fallback", true}}}}}}};
  return b.append("bufferViews", view);
}

int addAttribute(GltfBuilder& b, int view, size_t count, test::Component component, const char* type,
                 bool normalized = false) {
  return b.addAccessor({{"bufferView", view},
                        {"componentType", component},
                        {"type", type},
                        {"count", count},
                        {"normalized", normalized}});
}

// Points with positions of their own and one attribute.
GltfBuilder points(size_t count) {
  GltfBuilder b;
  std::vector<float> positions(count * 3);
  for (size_t i = 0; i < positions.size(); ++i) positions[i] = static_cast<float>(i) * 0.37f;
  const int view = addCompressed(b, encodeVertices(positions, 12), count, 12, "ATTRIBUTES");
  b.append("meshes",
           {{"primitives",
             {{{"mode", 0}, {"attributes", {{"POSITION", addAttribute(b, view, count, test::floatType, "VEC3")}}}}}}});
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {meshopt};
  return b;
}

GltfBuilder grid() {
  GltfBuilder b = points(9);
  const std::vector<uint32_t> indices = {0, 1, 3, 3, 1, 4, 1, 2, 4, 4, 2, 5, 3, 4, 6, 6, 4, 7, 4, 5, 7, 7, 5, 8};
  const int view = addCompressed(b, encodeTriangles(indices), indices.size(), 2, "TRIANGLES");
  auto& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["mode"] = 4;
  primitive["indices"] = addAttribute(b, view, indices.size(), test::ushortType, "SCALAR");
  return b;
}

Json& extension(GltfBuilder& b, int view) { return b.json["bufferViews"][view]["extensions"][meshopt]; }

std::string loadMeshopt(const GltfBuilder& b, const io::Limits& limits = {}) {
  return outcome(io::loadGltfBytes(b.glb(), "m", {}, limits));
}

}  // namespace

TEST_CASE("Meshopt: vertices and triangles", "[io][meshopt]") {
  const auto model = loaded(grid());
  CHECK(notes(model) == "");
  const auto& p = primitive(model);
  REQUIRE(p.positions.size() == 9);
  for (size_t i = 0; i < 9; ++i) {
    for (int c = 0; c < 3; ++c) {
      CHECK(p.positions[i][c] == static_cast<float>(i * 3 + static_cast<size_t>(c)) * 0.37f);
    }
  }
  // Triangles keep their order and sense; the codec may begin each with another corner.
  const std::vector<std::array<uint32_t, 3>> wanted = {{0, 1, 3}, {1, 4, 3}, {1, 2, 4}, {2, 5, 4},
                                                       {3, 4, 6}, {4, 7, 6}, {4, 5, 7}, {5, 8, 7}};
  std::vector<std::array<uint32_t, 3>> got(p.indices.size() / 3);
  for (size_t i = 0; i < p.indices.size(); ++i) got[i / 3][i % 3] = p.indices[i];
  for (auto& t : got) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  CHECK(got == wanted);
}

TEST_CASE("Meshopt: a sequence of indices", "[io][meshopt]") {
  const std::vector<uint32_t> indices = {0, 5, 1, 8, 8, 2};
  for (const size_t stride : {2u, 4u}) {
    GltfBuilder b = points(9);
    const int view = addCompressed(b, encodeSequence(indices), indices.size(), stride, "INDICES");
    auto& primitive = b.json["meshes"][0]["primitives"][0];
    primitive["mode"] = 3;
    primitive["indices"] =
        addAttribute(b, view, indices.size(), stride == 2 ? test::ushortType : test::uintType, "SCALAR");
    CHECK(test::primitive(loaded(b)).indices == indices);
  }
}

TEST_CASE("Meshopt: octahedral filter by hand", "[io][meshopt]") {
  // x, y of the octahedron of size 127; the third number is that size, the fourth is kept. A sum above 127 folds to
  // z < 0. (32, 32, 63) has the length 77.57, so 127 / 77.57 of it rounds to (52, 52, 103).
  const std::vector<int8_t> input = {0, 0, 127, 0, 127, 0, 127, 0, 0, -127, 127, 0, 127, 127, 127, 0, 32, 32, 127, 0};
  const std::vector<glm::vec3> wanted = {
      {0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {0, 0, -1}, glm::normalize(glm::vec3(52, 52, 103))};
  GltfBuilder b = points(5);
  const int view = addCompressed(b, encodeVertices(input, 4), 5, 4, "ATTRIBUTES", "OCTAHEDRAL");
  attributes(b)["NORMAL"] = addAttribute(b, view, 5, test::byteType, "VEC3", true);
  const auto model = loaded(b);
  for (size_t i = 0; i < 5; ++i) {
    INFO(i);
    CHECK(glm::length(primitive(model).normals[i] - wanted[i]) < 1e-6f);
  }
}

TEST_CASE("Meshopt: octahedral filter after its encoder", "[io][meshopt]") {
  std::vector<float> vectors;
  for (int i = 0; i < 64; ++i) {
    const float z = (static_cast<float>(i) + 0.5f) / 32 - 1, angle = static_cast<float>(i) * 2.4f;
    const float r = std::sqrt(1 - z * z);
    for (const float c : {r * std::cos(angle), r * std::sin(angle), z, 0.0f}) vectors.push_back(c);
  }
  const auto largestError = [&](size_t stride, int bits) {
    Bytes filtered(64 * stride);
    meshopt_encodeFilterOct(filtered.data(), 64, stride, bits, vectors.data());
    GltfBuilder b = points(64);
    const int view = addCompressed(b, encodeVertices(filtered, stride), 64, stride, "ATTRIBUTES", "OCTAHEDRAL");
    attributes(b)["NORMAL"] = addAttribute(b, view, 64, stride == 4 ? test::byteType : test::shortType, "VEC3", true);
    const auto model = loaded(b);
    float error = 0;
    for (size_t i = 0; i < 64; ++i) {
      const glm::vec3 wanted(vectors[i * 4], vectors[i * 4 + 1], vectors[i * 4 + 2]);
      error = std::max(error, glm::length(primitive(model).normals[i] - wanted));
    }
    return error;
  };
  // Half a step of 1 / (2^(bits - 1) - 1) in x and y, stretched by up to 3 on the sphere, and half a step of the
  // output.
  for (const auto& [stride, bits] : {std::pair<size_t, int>(4, 8), {8, 12}, {8, 16}}) {
    const float step = 1 / static_cast<float>((1 << (bits - 1)) - 1);
    INFO(bits);
    CHECK(largestError(stride, bits) < 2.5f * step);
    CHECK(largestError(stride, bits) > 0.1f * step);
  }
}

// Rotations are only met in animations and instances; colours that a target changes are read as they are, so they show
// the filter's work.
std::vector<glm::vec4> throughQuaternionFilter(const std::vector<int16_t>& filtered) {
  const size_t count = filtered.size() / 4;
  GltfBuilder b = points(count);
  const int view = addCompressed(b, encodeVertices(filtered, 8), count, 8, "ATTRIBUTES", "QUATERNION");
  attributes(b)["COLOR_0"] = addAttribute(b, view, count, test::shortType, "VEC4", true);
  const int zeros = b.addAccessor({{"componentType", test::floatType}, {"type", "VEC4"}, {"count", count}});
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"COLOR_0", zeros}}};
  return primitive(loaded(b)).colors;
}

TEST_CASE("Meshopt: quaternion filter", "[io][meshopt]") {
  // By hand: three components in units of 1 / (sqrt(2) 32767), then 32764 + the place of the fourth, the largest.
  const int16_t one = 32767, size = 32764;
  const auto q = throughQuaternionFilter({0, 0, 0, size + 1, one, 0, 0, size + 3, 0, 0, one / 2 + 1, size + 0});
  const float half = std::sqrt(0.5f), quarter = half / 2, step = 1.0f / 32767;
  CHECK(glm::length(q[0] - glm::vec4(0, 1, 0, 0)) < 1e-6f);
  CHECK(glm::length(q[1] - glm::vec4(half, 0, 0, half)) < step);
  CHECK(glm::length(q[2] - glm::vec4(std::sqrt(1 - quarter * quarter), 0, 0, quarter)) < 1.5f * step);

  std::vector<float> wanted;
  for (int i = 0; i < 16; ++i) {
    const glm::vec4 v =
        glm::normalize(glm::vec4(std::sin(1.0f * static_cast<float>(i)), std::cos(2.3f * static_cast<float>(i)),
                                 std::sin(3.1f * static_cast<float>(i) + 1), 0.3f));
    for (int c = 0; c < 4; ++c) wanted.push_back(v[c]);
  }
  std::vector<int16_t> filtered(wanted.size());
  meshopt_encodeFilterQuat(filtered.data(), 16, 8, 16, wanted.data());
  const auto got = throughQuaternionFilter(filtered);
  for (size_t i = 0; i < 16; ++i) {
    const glm::vec4 v(wanted[i * 4], wanted[i * 4 + 1], wanted[i * 4 + 2], wanted[i * 4 + 3]);
    CHECK(1 - std::abs(glm::dot(glm::normalize(got[i]), v)) < 1e-6f);  // q and -q are one rotation
    CHECK(std::abs(glm::length(got[i]) - 1) < 2 * step);
  }
}

TEST_CASE("Meshopt: exponential filter", "[io][meshopt]") {
  // mantissa (24 bits, signed) times 2^exponent (8 bits, signed)
  const auto pack = [](int exponent, int mantissa) {
    return static_cast<uint32_t>(exponent) << 24 | (static_cast<uint32_t>(mantissa) & 0xffffff);
  };
  GltfBuilder b = points(2);
  const std::vector<uint32_t> input = {pack(-3, 5),        pack(0, -7), pack(10, 3),
                                       pack(-24, 1 << 22), pack(0, 0),  pack(-1, -8388608)};
  int view = addCompressed(b, encodeVertices(input, 12), 2, 12, "ATTRIBUTES", "EXPONENTIAL");
  attributes(b)["POSITION"] = addAttribute(b, view, 2, test::floatType, "VEC3");
  CHECK(primitive(loaded(b)).positions == std::vector<glm::vec3>{{0.625f, -7, 3072}, {0.25f, 0, -4194304}});

  const std::vector<float> values = {1.2345f, -0.001f, 99.5f, 1e-5f, 3e-6f, -7e-6f};
  std::vector<uint32_t> filtered(6);
#if MESHOPTIMIZER_VERSION >= 190
  meshopt_encodeFilterExp(filtered.data(), 2, 12, 15, values.data(), meshopt_EncodeExpSharedVector);
#else
  meshopt_encodeFilterExp(filtered.data(), 2, 12, 15, values.data());
#endif
  b = points(2);
  view = addCompressed(b, encodeVertices(filtered, 12), 2, 12, "ATTRIBUTES", "EXPONENTIAL");
  attributes(b)["POSITION"] = addAttribute(b, view, 2, test::floatType, "VEC3");
  const auto model = loaded(b);
  for (size_t i = 0; i < 6; ++i) {
    // The exponent is shared by a vertex: half a unit of 15 signed bits of its largest component, at most 2^-13 of it.
    const float largest = i < 3 ? 99.5f : 1e-5f;
    CHECK(std::abs(primitive(model).positions[i / 3][static_cast<int>(i % 3)] - values[i]) < largest / 8192);
  }
}

TEST_CASE("Meshopt: what is broken is refused", "[io][meshopt]") {
  const std::string place = "m: /bufferViews/", end = "; export the model again, or without meshopt compression.";
  const auto refused = [&](int view, void (*breakIt)(Json&)) {
    GltfBuilder b = grid();
    breakIt(extension(b, view));
    std::string text = loadMeshopt(b);
    const std::string head = place + std::to_string(view) + "/extensions/EXT_meshopt_compression";
    CHECK(text.starts_with(head));
    CHECK(text.ends_with(end));
    if (!text.starts_with(head) || !text.ends_with(end)) return text;
    return text.substr(head.size(), text.size() - head.size() - end.size());
  };
  CHECK(refused(0, [](Json& e) { e["byteLength"] = e["byteLength"].get<int>() - 1; }) ==
        ": its data has not the length that 9 elements take");
  CHECK(refused(1, [](Json& e) { e["byteLength"] = e["byteLength"].get<int>() - 12; }) ==
        ": its data ends before 24 elements are decoded");
  CHECK(refused(0, [](Json& e) { e["byteOffset"] = 1; }) ==
        ": its data does not begin as the mode ATTRIBUTES asks for");
  CHECK(refused(0, [](Json& e) { e["byteLength"] = 2; }) == ": its data ends before 9 elements are decoded");
  const std::string otherMode =
      refused(1, [](Json& e) { e["mode"] = "INDICES"; });  // meshoptimizer 0.22: the length first
  CHECK((otherMode == ": its data does not begin as the mode INDICES asks for" ||
         otherMode == ": its data ends before 24 elements are decoded"));
  CHECK(refused(0, [](Json& e) { e["count"] = 8; }) ==
        "/count: 8 elements of 12 bytes do not make the 108 bytes of the buffer view");
  CHECK(refused(0, [](Json& e) { e["count"] = 4294967296u; }) == "/count: 4294967296 elements are more than 2^32 - 1");
  CHECK(refused(1, [](Json& e) { e["count"] = 23; }) == "/count: 23 is not a multiple of 3");
  CHECK(refused(0, [](Json& e) { e["count"] = -9; }) == "/count: is not a whole number of 0 to 2^53 - 1");
  CHECK(refused(0, [](Json& e) { e.erase("count"); }) == "/count: is missing");
  CHECK(refused(0, [](Json& e) { e["byteStride"] = 10; }) ==
        "/byteStride: 10 is not a multiple of 4 up to 256, as the mode ATTRIBUTES asks for");
  CHECK(refused(0, [](Json& e) { e["byteStride"] = 0; }) ==
        "/byteStride: 0 is not a multiple of 4 up to 256, as the mode ATTRIBUTES asks for");
  CHECK(refused(0, [](Json& e) { e["byteStride"] = 260; }) ==
        "/byteStride: 260 is not a multiple of 4 up to 256, as the mode ATTRIBUTES asks for");
  CHECK(refused(0, [](Json& e) { e["byteStride"] = 16; }) == "/byteStride: is 16, but the buffer view's is 12");
  CHECK(refused(1, [](Json& e) { e["byteStride"] = 8; }) == "/byteStride: 8 is not 2 or 4, as indices ask for");
  CHECK(refused(0, [](Json& e) { e["mode"] = "POINTS"; }) ==
        "/mode: \"POINTS\" is none of ATTRIBUTES, TRIANGLES, INDICES");
  CHECK(refused(0, [](Json& e) { e["filter"] = "COLOR"; }) ==
        "/filter: \"COLOR\" is none of NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL");
  CHECK(refused(0, [](Json& e) { e["filter"] = "OCTAHEDRAL"; }) ==
        "/byteStride: 12 is not 4 or 8, as the filter OCTAHEDRAL asks for");
  CHECK(refused(0, [](Json& e) { e["filter"] = "QUATERNION"; }) ==
        "/byteStride: 12 is not 8, as the filter QUATERNION asks for");
  CHECK(refused(1, [](Json& e) { e["filter"] = "EXPONENTIAL"; }) == "/filter: filters are for the mode ATTRIBUTES");
  CHECK(refused(0, [](Json& e) { e["buffer"] = 1; }) == "/buffer: buffer 1 is a fallback, which holds no data");
  CHECK(refused(0, [](Json& e) { e["buffer"] = 2; }) == "/buffer: buffer 2 does not exist; there are 2");
  CHECK(refused(0, [](Json& e) { e["byteOffset"] = 9007199254740991u; }).find(": ends at byte 9007199254741") == 0);
}

TEST_CASE("Meshopt: limits and fallbacks", "[io][meshopt]") {
  GltfBuilder b = grid();
  b.json["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 4}});
  CHECK(loadMeshopt(b) ==
        "m: /bufferViews/2/buffer: buffer 1 is a fallback, which only compressed views may use; "
        "export the model again, or without meshopt compression.");
  // 108 bytes of vertices and 48 of indices beside the file's own
  b = grid();
  io::Limits limits;
  limits.totalBytes = b.glb().size() + 156;
  CHECK(loadMeshopt(b, limits) == "loaded");
  --limits.totalBytes;
  CHECK(loadMeshopt(b, limits) ==
        "m: /bufferViews/1/extensions/EXT_meshopt_compression: with its 48 bytes the model has more "
        "than the limit of " +
            std::to_string(limits.totalBytes) + "; use a smaller model.");
  // Few bytes that claim to be many are refused before memory is taken.
  extension(b, 0)["count"] = 100000000;
  b.json["bufferViews"][0]["byteLength"] = 1200000000;
  CHECK(loadMeshopt(b).find("bytes are too few to decode to 1200000000; export") != std::string::npos);
  // Without the mark, a buffer without data is a fallback where the extension is required, else one like others.
  b = grid();
  b.json["buffers"][1].erase("extensions");
  CHECK(loadMeshopt(b) == "loaded");
  b.json.erase("extensionsRequired");
  CHECK(loadMeshopt(b) == "m: /buffers/1: has no uri; embed the buffer or name its file.");
}

TEST_CASE("Meshopt: the KHR extension is read like EXT, and has a filter for colours", "[io][meshopt]") {
  // Renames the extension in views, buffers and lists.
  const auto asKhr = [](GltfBuilder b) {
    std::string text = b.json.dump();
    for (size_t i = 0; (i = text.find(meshopt, i)) != std::string::npos;) text.replace(i, 3, "KHR");
    b.json = Json::parse(text);
    return b;
  };
  CHECK(primitive(loaded(asKhr(grid()))).positions[8].x == 24 * 0.37f);
  // y, co, cg and alpha below a set bit that tells the number of bits, 8 here: 255 * value / 255.
  // (r, g, b) = (y + co - cg, y + cg, y - co - cg); alpha has 7 bits, the last of them twice.
  const auto colors = [&](const auto& input, size_t stride, test::Component component) {
    GltfBuilder b = points(3);
    const int view = addCompressed(b, encodeVertices(input, stride), 3, stride, "ATTRIBUTES", "COLOR");
    attributes(b)["COLOR_0"] = addAttribute(b, view, 3, component, "VEC4", true);
    return primitive(loaded(asKhr(b))).colors;
  };
  const auto c8 = [](int co) { return static_cast<uint8_t>(co); };
  const auto eight =
      colors(std::vector<uint8_t>{100, c8(-20), 30, 0x80 | 127, 200, 10, c8(-5), 0x80 | 64, 0, 0, 0, 0x80}, 4,
             test::ubyteType);
  CHECK(eight[0] == glm::vec4(50, 130, 90, 255) / 255.0f);
  CHECK(eight[1] == glm::vec4(215, 195, 195, 128) / 255.0f);
  CHECK(eight[2] == glm::vec4(0));
  // Five bits in bytes: 31 is one. 10 / 31 of 255 is 82.26.
  const auto five =
      colors(std::vector<uint8_t>{10, 0, 0, 16 | 15, 31, 0, 0, 16 | 5, 12, 3, c8(-4), 16}, 4, test::ubyteType);
  CHECK(five[0] == glm::vec4(82, 82, 82, 255) / 255.0f);
  CHECK(five[1] == glm::vec4(255, 255, 255, 90) / 255.0f);  // 11 of 31
  CHECK(five[2] == glm::vec4(156, 66, 107, 0) / 255.0f);    // 19, 8, 13 of 31
  // Sixteen bits.
  const auto sixteen = colors(std::vector<uint16_t>{40000, 1000, 65536 - 2000, 0xffff, 1, 0, 0, 0x8000, 0, 0, 0, 0}, 8,
                              test::ushortType);
  CHECK(sixteen[0] == glm::vec4(43000, 38000, 41000, 65535) / 65535.0f);
  CHECK(sixteen[1] == glm::vec4(1, 1, 1, 0) / 65535.0f);
  CHECK(sixteen[2] == glm::vec4(0));  // not valid
}

TEST_CASE("Meshopt: version 1 of the vertex codec is named where the library cannot read it", "[io][meshopt]") {
  GltfBuilder b = points(4);
  b.bytes[0] = 0xa1;
  const std::string said = loadMeshopt(b);
  // A newer library reads it, if not these bytes.
  if (said.find("version 1") != std::string::npos)
    CHECK(
        said ==
        "m: /bufferViews/0/extensions/EXT_meshopt_compression: its data is of version 1 of the vertex codec, which the "
        "meshoptimizer library in use cannot read; export the model again, or without meshopt compression.");
  CHECK(said != "loaded");
}

TEST_CASE("Meshopt: random damage never crashes", "[io][meshopt]") {
  const auto glb = grid().glb();
  uint32_t state = 3;
  const auto random = [&] { return state = state * 1664525u + 1013904223u; };
  size_t good = 0;
  for (int round = 0; round < 2000; ++round) {
    auto bytes = glb;
    for (int change = 0; change < 1 + round % 3; ++change) {
      const size_t tail = bytes.size() / (round % 2 == 0 ? 1 : 8);  // half of the time only the data
      bytes[bytes.size() - 1 - random() % tail] = static_cast<uint8_t>(random() >> 24);
    }
    good += io::loadGltfBytes(bytes, "m").has_value();
  }
  CHECK(good > 0);
  CHECK(good < 2000);
}

TEST_CASE("Validation looks into what is compressed", "[io][validate]") {
  const std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  GltfBuilder b;
  const int view = addCompressed(b, encodeVertices(positions, 12), 3, 12, "ATTRIBUTES");
  b.json["bufferViews"][0]["target"] = 34962;
  const int accessor = addAttribute(b, view, 3, test::floatType, "VEC3");
  b.json["accessors"][0].update({{"min", {0, 0, 0}}, {"max", {1, 2, 0}}});
  b.append("meshes", {{"primitives", {{{"attributes", {{"POSITION", accessor}}}}}}});
  b.append("nodes", {{"mesh", 0}});
  b.append("scenes", {{"nodes", {0}}});
  b.json["extensionsUsed"] = {meshopt};
  const auto codes = [&] {
    const Bytes file = b.glb();
    std::string out;
    for (const auto& f : io::validateBytes(file, "m.glb").findings)
      out += std::string(io::validate::name(f.code)) + " " + f.place + "\n";
    return out;
  };
  CHECK(codes() == "ACCESSOR_MAX_MISMATCH /accessors/0/max/1\n");
  b.json["accessors"][0]["max"] = {1, 1, 0};
  CHECK(codes() == "");
  b.bytes[0] = 0;  // no header of the codec's
  CHECK(codes().starts_with("FACET_NOT_CHECKED"));
}
