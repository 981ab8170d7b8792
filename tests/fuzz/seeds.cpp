#include "fuzz/seeds.hpp"

#include <avif/avif.h>
#include <draco/compression/encode.h>
#include <draco/mesh/mesh.h>
#include <meshoptimizer.h>
#include <turbojpeg.h>
#include <webp/encode.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>

#include "base/disk_cache.hpp"
#include "compare/regression.hpp"
#include "io/radiance.hpp"
#include "support/gltf_builder.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"
#include "support/temporary_folder.hpp"

namespace facet::fuzz {

namespace {

using test::GltfBuilder;
using Json = nlohmann::json;

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

Bytes fileBytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

Bytes ramp(size_t count, size_t step = 37) {
  Bytes out(count);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<uint8_t>(1 + step * i % 255);
  return out;
}

std::vector<Bytes> texts(std::initializer_list<std::string_view> all) {
  std::vector<Bytes> out;
  for (const std::string_view text : all) out.push_back(bytesOf(text));
  return out;
}

Bytes smallPng() { return test::pngBytes(2, 2, 3, 8, ramp(12)); }

// ---- Models ---------------------------------------------------------------------------------------------------------

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

std::string job(const std::string& more) { return R"({"model": "a.glb", )" + more + "}"; }

}  // namespace

std::vector<Bytes> gltfSeeds() {
  std::vector<Bytes> out;
  for (const GltfBuilder& b : {test::triangle(), dressed(), moving(), odd()}) {
    out.push_back(b.glb());
    out.push_back(bytesOf(b.text()));
  }
  return out;
}

std::vector<Bytes> glbSeeds() {
  const Bytes one = test::triangle().glb();
  Bytes three = test::glbBytes("{}", ramp(8)), text = test::glbBytes("{}  ", {});
  three.insert(three.end(), {4, 0, 0, 0, 'X', 'Y', 'Z', 0, 1, 2, 3, 4});
  three[8] = static_cast<uint8_t>(three.size());
  return {one, three, text, Bytes(one.begin(), one.begin() + 12)};
}

std::vector<Bytes> jsonSeeds() {
  std::vector<Bytes> out =
      texts({R"({"a":[1,2.0,3e2,{"b":null}],"a":"x\"\\\u00e9","accessors":[{"count":3},{"bufferView":0}]})",
             R"([{"mesh":1.0},{"mesh":1.5}])", R"({"nodes":[{"children":[1.0,2e0]}]})", "{\"n\":\"caf\xe9\"}",
             "{\"a\":[[[[[[[[[[1]]]]]]]]]]}", "{ } x"});
  out.push_back(bytesOf(test::triangle().json.dump(1)));
  return out;
}

std::vector<Bytes> uriSeeds() {
  return texts({"a.bin", "b/c.png", "./b/../a.bin", "../secret", "out", "in/c.png", "%2e%2e/secret", "/etc/passwd",
                "file:///etc/passwd", "C:\\x", "http://x/y", "a%00b", "caf%C3%A9.png", "data:,plain%20text",
                "data:image/png;base64,AAEC AwQ=", "data:;base64,A*==", "//x/y", "b//c.png", "b/."});
}

std::vector<Bytes> pngSeeds() {
  std::vector<Bytes> out;
  for (const int channels : {1, 2, 3, 4})
    for (const int bits : {8, 16})
      out.push_back(test::pngBytes(3, 2, channels, bits, ramp(static_cast<size_t>(6 * channels * bits / 8))));
  return out;
}

std::vector<Bytes> jpegSeeds() {
  std::vector<Bytes> out;
  tjhandle handle = tjInitCompress();
  const Bytes pixels = ramp(size_t{24} * 17 * 4, 11);
  const auto add = [&](int format, int sampling, int flags) {
    unsigned char* data = nullptr;
    unsigned long size = 0;
    if (tjCompress2(handle, pixels.data(), 24, 0, 17, format, &data, &size, sampling, 60, flags) == 0)
      out.emplace_back(data, data + size);
    tjFree(data);
  };
  for (const int sampling : {TJSAMP_444, TJSAMP_420, TJSAMP_GRAY}) add(TJPF_RGB, sampling, 0);
  add(TJPF_RGB, TJSAMP_422, TJFLAG_PROGRESSIVE);
  add(TJPF_CMYK, TJSAMP_444, 0);
  tjDestroy(handle);
  return out;
}

std::vector<Bytes> webpSeeds() {
  std::vector<Bytes> out;
  const Bytes pixels = ramp(size_t{20} * 13 * 4, 11);
  const auto add = [&](auto encode, int channels, auto... quality) {
    uint8_t* data = nullptr;
    const size_t size = encode(pixels.data(), 20, 13, 20 * channels, quality..., &data);
    out.emplace_back(data, data + size);
    WebPFree(data);
  };
  add(WebPEncodeLosslessRGB, 3), add(WebPEncodeLosslessRGBA, 4);
  add(WebPEncodeRGB, 3, 50.0f), add(WebPEncodeRGBA, 4, 50.0f);
  return out;
}

// None where libavif has no encoder.
std::vector<Bytes> avifSeeds() {
  std::vector<Bytes> out;
  for (const int depth : {8, 10})
    for (const auto format : {AVIF_PIXEL_FORMAT_YUV444, AVIF_PIXEL_FORMAT_YUV420, AVIF_PIXEL_FORMAT_YUV400}) {
      const bool alpha = format == AVIF_PIXEL_FORMAT_YUV420;
      Bytes pixels = ramp(size_t{12} * 10 * (alpha ? 4 : 3) * (depth > 8 ? 2 : 1), 11);
      if (depth > 8)
        for (size_t i = 1; i < pixels.size(); i += 2) pixels[i] &= 3;
      avifImage* image = avifImageCreate(12, 10, depth, format);
      avifRGBImage rgb;
      avifRGBImageSetDefaults(&rgb, image);
      rgb.format = alpha ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
      rgb.pixels = pixels.data(), rgb.rowBytes = static_cast<uint32_t>(pixels.size() / 10);
      avifEncoder* encoder = avifEncoderCreate();
      encoder->speed = 10;
      avifRWData data = AVIF_DATA_EMPTY;
      if (avifImageRGBToYUV(image, &rgb) == AVIF_RESULT_OK && avifEncoderWrite(encoder, image, &data) == AVIF_RESULT_OK)
        out.emplace_back(data.data, data.data + data.size);
      avifRWDataFree(&data);
      avifEncoderDestroy(encoder);
      avifImageDestroy(image);
    }
  return out;
}

std::vector<Bytes> ktx2Seeds() {
  std::vector<Bytes> out;
  for (const std::string_view hex :
       {test::etc1sOpaque, test::etc1sAlpha, test::uastcAlpha, test::uastcRamps, test::etc1sRamps})
    out.push_back(test::fromHex(hex));
  const auto add = [&](uint32_t format, size_t blockBytes, int width, int height, uint8_t model) {
    test::Ktx2File file;
    file.vkFormat = format, file.model = model;
    file.width = static_cast<uint32_t>(width), file.height = static_cast<uint32_t>(height);
    file.levels = {ramp(blockBytes)};
    out.push_back(file.bytes());
    file.uncompressed = {blockBytes};
    file.scheme = 2, file.levels = {test::zstandard(ramp(blockBytes))};
    out.push_back(file.bytes());
    file.scheme = 3, file.levels = {test::zlibDeflated(ramp(blockBytes))};
    out.push_back(file.bytes());
  };
  add(37, 3 * 2 * 4, 3, 2, 1);                                                        // RGBA8
  for (const uint32_t format : {131u, 133u, 139u}) add(format, 8, 4, 4, 128);         // BC1, BC1 with alpha, BC4
  for (const uint32_t format : {135u, 137u, 141u, 145u}) add(format, 16, 4, 4, 128);  // BC2, BC3, BC5, BC7
  for (const uint32_t format : {147u, 149u, 153u}) add(format, 8, 4, 4, 161);         // ETC2, EAC
  for (const uint32_t format : {151u, 155u}) add(format, 16, 4, 4, 161);
  for (const uint32_t format : {157u, 171u}) add(format, 16, 4, 4, 162);  // ASTC 4 x 4, 8 x 8
  return out;
}

std::vector<Bytes> hdrSeeds() {
  const std::string magic = "#?RADIANCE\n", format = "FORMAT=32-bit_rle_rgbe\n";
  const auto file = [&](const std::string& header, const Bytes& data) {
    Bytes out = bytesOf(header);
    out.insert(out.end(), data.begin(), data.end());
    return out;
  };
  Bytes runs;
  for (int row = 0; row < 2; ++row) {
    runs.insert(runs.end(), {2, 2, 0, 9});
    for (int plane = 0; plane < 4; ++plane) runs.insert(runs.end(), {128 + 5, 130, 4, 1, 2, 3, 4});
  }
  Bytes old = ramp(16);
  old.insert(old.end(), {1, 1, 1, 4});
  return {file(magic + format + "\n-Y 2 +X 9\n", runs),
          file(magic + format +
                   "EXPOSURE=2\nCOLORCORR=1 2 3\nPRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.31 0.33\n\n-Y 2 +X 4\n",
               old),
          file(magic + "FORMAT=32-bit_rle_xyze\n\n+X 2 -Y 2\n", ramp(16)),
          file("#?RGBE\n" + format + "\n+Y 2 -X 2\n", ramp(16))};
}

std::vector<Bytes> merlSeeds() {
  Bytes dims;
  for (const uint8_t n : std::initializer_list<uint8_t>{90, 90, 180}) dims.insert(dims.end(), {n, 0, 0, 0});
  Bytes cells = dims, wide = dims;
  for (const double value : {1.0, -1.0, 0.25, 1500.0}) {
    const auto bits = std::bit_cast<std::array<uint8_t, 8>>(value);
    cells.insert(cells.end(), bits.begin(), bits.end());
  }
  wide[8] = 104, wide[9] = 1;  // 360
  return {dims, cells, wide, Bytes(12, 0)};
}

std::vector<Bytes> utiaSeeds() {
  std::vector<Bytes> out;
  for (uint8_t decode = 0; decode < 3; ++decode) {
    Bytes bytes = {decode};
    for (const double value : {0.1, 0.0, 0.5, -0.01}) {
      const auto bits = std::bit_cast<std::array<uint8_t, 8>>(value);
      bytes.insert(bytes.end(), bits.begin(), bits.end());
    }
    out.push_back(bytes);
  }
  return out;
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

std::vector<Bytes> suiteSeeds() {
  return texts({R"({"defaults": {"size": "32x32", "samples": 1, "tolerance": {"flip": 0.1}},
   "jobs": [{"name": "a", "model": "builtin:spheres", "camera": "0"}, {"name": "b", "model": "b.glb", "env": "s.hdr",
   "tolerance": {"flip": null, "alpha": 3}}],
   "renderers": [{"name": "mine", "matches": "*Mesa*", "tolerance": {"flip": 1}}]})",
                R"({"jobs": [{"name": "a", "model": "m", "size": [4, 4], "orbit": [1, 2, 3], "exposure": -1.5}]})"});
}

std::vector<Bytes> sweepSeeds() {
  return texts({R"({"models": ["builtin:spheres", "a.glb"], "environments": ["builtin:sky", "s.hdr", "none"],
   "sizes": ["16x16", "8x4"], "samples": [1, 4], "seeds": 2, "repeat": 1, "common": {"exposure": 1},
   "methods": [{"name": "tables", "visibility": "none"}, {"name": "paths", "light": "paths", "bounces": 3}],
   "reference": {"samples": 256, "light": "paths"}})",
                R"({"methods": [{"name": "a"}]})", "{}"});
}

std::vector<Bytes> anglesSeeds() {
  return texts({"thetaV,thetaL,phi\n30,45,180\n0,90,0\n", "phi, thetaL ,thetaV,phiV\r\n180,1e1,2.5,-90\r\n",
                "30,45,180,90\n\n# no comment\n"});
}

std::vector<Bytes> jobsSeeds() {
  return texts({"[" + job(R"("output": "a.png", "size": "32x32", "env": "builtin:sky", "env-rotation": 90)") + "," +
                    job(R"("output": "a.exr", "stats": "a.json", "max-error": 0.01, "ground": true)") + "]",
                R"({"jobs": [)" + job(R"("output": "b.png", "animation": "all", "time": 1, "background": "transparent",
                 "brdf": "builtin:ggx-0.3", "tonemap": "agx", "orbit": [1, 2, 3], "lights": "none", "variant": "x")") +
                    "]}"});
}

std::vector<Bytes> reportSeeds() {
  compare::RegressionReport report;
  report.suite = "s", report.renderer = "r", report.shard = 1, report.shards = 2;
  report.stale = {"old.png"};
  compare::JobResult good;
  good.index = 0, good.name = "a", good.model = "builtin:spheres", good.command = "facet render";
  good.status = compare::JobStatus::passed, good.figures = {{"flip", 0.01}}, good.limits = {{"flip", 0.1}};
  good.picture = "a.png", good.baseline = "a.baseline.png", good.renderer = good.baselineRenderer = "r";
  compare::JobResult bad = good;
  bad.index = 2, bad.name = "b", bad.status = compare::JobStatus::failed, bad.message = "m", bad.warnings = {"w"};
  report.jobs = {good, bad};
  return {bytesOf(compare::reportJson(report)), bytesOf(compare::jobText(good)), bytesOf(compare::jobText(bad))};
}

std::vector<Bytes> preferencesSeeds() {
  return texts({R"({"theme": "light", "scale": 1.5, "startWithLast": true, "size": [800, 600]})",
                R"({"theme": "dark", "scale": 0, "playOnOpening": false})", "{}"});
}

std::vector<Bytes> keysSeeds() {
  return texts({R"({"screenshot": ["Ctrl+S", "F12"], "flyUp": "e", "help": []})", "{}"});
}

std::vector<Bytes> cacheSeeds() {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path(), 1 << 20};
  std::vector<Bytes> out;
  for (const size_t size : {0, 5, 500}) {
    const Bytes value = ramp(size);
    writeCached(cache, "key", std::as_bytes(std::span(value)));
    out.push_back(fileBytes(std::filesystem::directory_iterator(cache.folder)->path()));
  }
  return out;
}

}  // namespace facet::fuzz
