// Files of strangers, by the library that reads them and no more, so that a fuzzer of them has little to count.

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "base/disk_cache.hpp"
#include "fuzz/checks.hpp"
#include "fuzz/seeds.hpp"
#include "io/exr.hpp"
#include "io/glb.hpp"
#include "io/gltf.hpp"
#include "io/gltf_environment.hpp"
#include "io/hdr.hpp"
#include "io/ies.hpp"
#include "io/image.hpp"
#include "io/json_scan.hpp"
#include "io/merl.hpp"
#include "io/referenced_files.hpp"
#include "io/safe_files.hpp"
#include "io/uri.hpp"
#include "io/utia.hpp"
#include "io/validate/validate.hpp"
#include "scene/animation.hpp"
#include "scene/deformation.hpp"
#include "scene/geometry.hpp"
#include "scene/nodes.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"

namespace facet::fuzz {

namespace {

// Tight, so that a thousand inputs a second can be tried: what they guard is counted all the same.
io::Limits smallLimits() {
  io::Limits limits;
  limits.totalBytes = limits.geometryBytes = uint64_t{64} << 20;
  limits.imagePixels = limits.totalPixels = limits.radiancePixels = uint64_t{1} << 18;
  return limits;
}

bool isFinite(const glm::dmat4& matrix) {
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 4; ++row)
      if (!std::isfinite(matrix[column][row])) return false;
  return true;
}

// ---- Models ---------------------------------------------------------------------------------------------------------

void checkPrimitive(const scene::Primitive& primitive, const scene::Model& model) {
  const size_t vertices = primitive.positions.size();
  for (const uint32_t index : primitive.indices) demand(index < vertices, "indices name vertices");
  demand(primitive.normals.empty() || primitive.normals.size() == vertices, "a normal for each vertex");
  demand(primitive.tangents.empty() || primitive.tangents.size() == vertices, "a tangent for each vertex");
  demand(primitive.influences.size() == vertices * static_cast<size_t>(primitive.influencesPerVertex) ||
             primitive.influences.empty(),
         "influences for each vertex");
  demand(primitive.material >= -1 && primitive.material < static_cast<int>(model.materials.size()),
         "a material that exists");
}

void pose(const scene::Model& model, double time) {
  std::vector<int> animations;
  for (size_t i = 0; i < model.animations.size(); ++i) animations.push_back(static_cast<int>(i));
  const scene::Pose pose = scene::poseAt(model, animations, time);
  for (size_t i = 0; i < std::max<size_t>(1, std::min<size_t>(model.scenes.size(), 3)); ++i) {
    const scene::FlatScene flat = scene::flatten(model, static_cast<int>(i), pose);
    for (const scene::Instance& instance : flat.instances)
      demand(isFinite(instance.worldFromNode), "an instance stands somewhere");
    for (const auto& joints : flat.joints)
      for (const glm::dmat4& joint : joints) demand(isFinite(joint), "a joint stands somewhere");
    scene::sceneBounds(model, flat, pose);
  }
}

void poseModel(io::LoadedModel loaded) {
  Notes notes;
  scene::completeGeometry(loaded.model, notes);
  for (const scene::Mesh& mesh : loaded.model.meshes)
    for (const scene::Primitive& primitive : mesh.primitives) checkPrimitive(primitive, loaded.model);
  for (const double time : {0.0, 0.4, 1e30}) pose(loaded.model, time);
  io::decodeImages(loaded.model, std::vector<bool>(loaded.model.images.size(), true), notes, smallLimits());
  io::describeImages(loaded.model, smallLimits());
}

// A thousand small primitives cost more than they teach.
bool isSmall(const scene::Model& model) {
  size_t vertices = 0;
  for (const scene::Mesh& mesh : model.meshes)
    for (const scene::Primitive& primitive : mesh.primitives)
      vertices += primitive.positions.size() * (1 + primitive.targets.size()) + primitive.indices.size();
  return vertices < 200'000;
}

void runGltf(Input bytes) {
  Result<io::LoadedModel> loaded = io::loadGltfBytes(bytes, "m", {}, smallLimits());
  if (good(loaded) && isSmall(loaded->model)) poseModel(std::move(*loaded));
}

void runValidate(Input bytes) {
  const io::validate::Report report = io::validateBytes(bytes, "m", {}, smallLimits());
  for (const io::validate::Finding& finding : report.findings)
    demand(!finding.text.empty() && finding.text.size() < 65536, "a finding is a sentence");
}

// A file's own environment, and which files it names.
void runLights(Input bytes) {
  static const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.write("m.gltf", bytes);
  Notes notes;
  const Result<scene::Environment> environment = io::loadGltfEnvironment(file, "", notes, smallLimits());
  io::referencedFiles(file);
  if (!good(environment)) return;
  demand(environment->radiance.size() == static_cast<size_t>(environment->width * environment->height),
         "an environment has its pixels");
  for (const glm::vec3& value : environment->radiance)
    demand(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z), "radiance is finite");
}

// Light profiles, and what shines by them.
void runIes(Input bytes) {
  Notes notes;
  const Result<optics::LightProfile> profile = io::readIes(bytes, "m", "/p", notes);
  if (!good(profile)) return;
  demand(profile->candela.size() == profile->polar.size() * profile->azimuth.size(), "a number for each direction");
  demand(std::isfinite(optics::lumens(*profile)), "its flux is finite");
  for (const glm::dvec3& d : {glm::dvec3(0, 0, -1), glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0),
                              glm::dvec3(-0.3, 0.2, -0.7), glm::dvec3(0.1, -0.9, 0.4), glm::dvec3(0)}) {
    const double candela = optics::candela(*profile, d);
    demand(candela >= 0 && candela <= 1.001 * double{profile->mostCandela}, "no more light than was measured");
  }
}

void runGlb(Input bytes) {
  if (!io::isGlb(bytes)) return;
  const Result<io::GlbParts> parts = io::splitGlb(bytes);
  if (!good(parts)) return;
  const auto inside = [&](const void* data, size_t size) {
    const auto* at = static_cast<const uint8_t*>(data);
    return size == 0 || (at >= bytes.data() && at + size <= bytes.data() + bytes.size());
  };
  demand(inside(parts->json.data(), parts->json.size()), "the JSON is inside of the file");
  demand(inside(parts->binary.data(), parts->binary.size()), "the binary chunk is inside of the file");
}

void runJson(Input bytes) {
  const std::string_view text = textOf(bytes);
  const auto utf8 = withValidUtf8(text);
  if (utf8) demand(!withValidUtf8(*utf8), "what was mended is UTF-8");
  const auto whole = io::withWholeNumbers(text);
  if (whole) demand(!io::withWholeNumbers(*whole), "what was mended has whole numbers");
  const Result<io::JsonOutline> outline = io::scanJson(text, 64);
  if (!good(outline)) return;
  demand(outline->depth <= 64, "no deeper than allowed");
  for (const io::JsonMember& member : outline->members)
    demand(member.begin <= member.end && member.end <= text.size(), "a member is inside of the text");
  for (const auto& object : outline->accessorsWithoutView)
    demand(object.begin <= text.size(), "an object is inside of the text");
  for (const io::JsonMember& member : outline->members) outline->elements(member.key);
}

// A folder with a file, a folder and links that lead inside and out.
const std::filesystem::path& uriFolder() {
  static const test::TemporaryFolder outer;
  static const std::filesystem::path folder = [] {
    outer.write("m/a.bin", std::string("a"));
    outer.write("m/b/c.png", std::string("c"));
    outer.write("secret", std::string("s"));
    std::filesystem::create_symlink("../secret", outer.path() / "m/out");
    std::filesystem::create_symlink("b", outer.path() / "m/in");
    return std::filesystem::canonical(outer.path() / "m");
  }();
  return folder;
}

void runUri(Input bytes) {
  const std::string_view text = textOf(bytes);
  const std::string decoded = io::percentDecode(text);
  demand(decoded.size() <= text.size(), "decoding does not lengthen");
  io::hasScheme(text);
  if (io::isDataUri(text)) io::decodeDataUri(text);
  demand(!withValidUtf8(io::inQuotes(text)), "a quotation is UTF-8");
  const std::filesystem::path& folder = uriFolder();
  const Result<std::filesystem::path> path = io::resolveBelow(folder, std::string(text));
  if (!path) return;
  demand(path->string() == folder.string() || path->string().starts_with(folder.string() + "/"),
         "a file below the folder");
}

// meshopt and Draco below a document that fits them; the first bytes say how.

struct Head {
  size_t at = 0;
  Input bytes;
  size_t take(size_t most) {
    const size_t high = at < bytes.size() ? bytes[at] : 0, low = at + 1 < bytes.size() ? bytes[at + 1] : 0;
    at = std::min(at + 2, bytes.size());
    return (high << 8 | low) % most;
  }
  Bytes rest() const { return {bytes.begin() + static_cast<ptrdiff_t>(at), bytes.end()}; }
};

void runDraco(Input bytes) {
  Head head{0, bytes};
  const size_t points = head.take(4096), indices = head.take(8192), ids = head.take(4096);
  test::GltfBuilder b;
  const int view = b.addView(head.rest());
  const auto add = [&](size_t count, int component, const char* type, bool normalized) {
    return b.addAccessor({{"componentType", component}, {"type", type}, {"count", count}, {"normalized", normalized}});
  };
  nlohmann::json primitive;
  primitive["attributes"] = {{"POSITION", add(points, test::floatType, "VEC3", false)},
                             {"NORMAL", add(points, test::floatType, "VEC3", false)},
                             {"COLOR_0", add(points, test::ubyteType, "VEC4", true)}};
  primitive["indices"] = add(indices, test::ushortType, "SCALAR", false);
  primitive["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", view},
      {"attributes", {{"POSITION", ids % 16}, {"NORMAL", ids / 16 % 16}, {"COLOR_0", ids / 256}}}};
  b.json["extensionsUsed"] = b.json["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  b.json["meshes"] = {{{"primitives", {primitive}}}};
  b.json["nodes"] = {{{"mesh", 0}}};
  b.json["scenes"] = {{{"nodes", {0}}}};
  runGltf(b.glb());
}

void runMeshopt(Input bytes) {
  constexpr const char* modes[] = {"ATTRIBUTES", "TRIANGLES", "INDICES"};
  constexpr const char* filters[] = {"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
  Head head{0, bytes};
  const size_t choice = head.take(65536), count = head.take(4096), stride = head.take(260);
  const Bytes data = head.rest();
  test::GltfBuilder b;
  b.bytes = data;
  b.json["buffers"] = {
      {{"byteLength", data.size()}},
      {{"byteLength", count * stride + 1}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}}};
  b.json["bufferViews"] = {{{"buffer", 1},
                            {"byteLength", count * stride},
                            {"extensions",
                             {{"EXT_meshopt_compression",
                               {{"buffer", 0},
                                {"byteLength", data.size()},
                                {"byteStride", stride},
                                {"count", count},
                                {"mode", modes[choice % 3]},
                                {"filter", filters[choice / 3 % 4]}}}}}}};
  if (choice % 3 == 0) b.json["bufferViews"][0]["byteStride"] = stride;
  b.json["extensionsUsed"] = {"EXT_meshopt_compression"};
  b.json["accessors"] = {{{"bufferView", 0}, {"componentType", 5126}, {"type", "VEC3"}, {"count", count}}};
  b.json["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}}};
  b.json["nodes"] = {{{"mesh", 0}}};
  b.json["scenes"] = {{{"nodes", {0}}}};
  runGltf(b.glb());
}

// ---- Pictures -------------------------------------------------------------------------------------------------------

void runImage(Input bytes) {
  const io::Limits limits = smallLimits();
  const Result<io::Pixels> pixels = io::decodeImage(bytes, "i", limits);
  if (!good(pixels)) return;
  demand(pixels->width > 0 && pixels->height > 0, "a picture has pixels");
  const uint64_t count = static_cast<uint64_t>(pixels->width) * static_cast<uint64_t>(pixels->height);
  demand(count <= limits.imagePixels, "no more pixels than allowed");
  demand(pixels->data.size() == count * static_cast<uint64_t>(pixels->channels * pixels->bytesPerSample),
         "as many samples as pixels");
}

void checkRadiance(const Result<io::RadianceImage>& image) {
  if (!good(image)) return;
  const uint64_t count = static_cast<uint64_t>(image->width) * static_cast<uint64_t>(image->height);
  demand(image->pixels.size() == count && count > 0, "as many pixels as it says");
  demand(count <= smallLimits().radiancePixels, "no more pixels than allowed");
}

void runHdr(Input bytes) {
  if (io::isHdr(bytes)) checkRadiance(io::decodeHdr(bytes, "h", smallLimits()));
}

void runExr(Input bytes) {
  if (io::isExr(bytes)) checkRadiance(io::decodeExr(bytes, "e", smallLimits()));
}

// ---- Measured BRDFs -------------------------------------------------------------------------------------------------

// Megabytes of cells that no fuzzer would find: the input again and again.
Bytes tiled(Input head, Input cells, size_t size) {
  Bytes bytes(head.begin(), head.end());
  bytes.resize(size);
  for (size_t at = head.size(); at < size && !cells.empty();) {
    const size_t n = std::min(cells.size(), size - at);
    std::memcpy(bytes.data() + at, cells.data(), n);
    at += n;
  }
  return bytes;
}

void runMerl(Input bytes) {
  good(io::decodeMerl(bytes, "b"));
  if (!io::isMerl(bytes) || bytes.size() % 16 != 4) return;  // seldom: 35 MB
  const Bytes whole = tiled(bytes.first(12), bytes.subspan(12), io::merlBytes(180));
  const Result<optics::MeasuredBrdf> brdf = io::decodeMerl(whole, "b");
  if (good(brdf))
    for (const glm::vec3& value : brdf->values)
      demand(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z), "cells are finite");
}

void runUtia(Input bytes) {
  if (bytes.empty()) return;
  const auto decode = static_cast<io::UtiaDecode>(bytes[0] % 3);
  good(io::decodeUtia(bytes, "b", decode));
  if (bytes.size() % 16 != 1) return;  // seldom: 2 MB
  const Bytes whole = tiled({}, bytes.subspan(1), io::utiaBytes);
  const Result<optics::MeasuredBrdf> brdf = io::decodeUtia(whole, "b", decode);
  if (good(brdf))
    for (const glm::vec3& value : brdf->values)
      demand(std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z), "cells are finite");
}

// ---- The disk caches ------------------------------------------------------------------------------------------------

// The input is the entry's file: whatever it holds, what comes back passed its checksum.
void runCache(Input bytes) {
  static const test::TemporaryFolder folder;
  static const DiskCache cache{folder.path(), 1 << 20};
  static const std::filesystem::path file = [] {
    writeCached(cache, "key", {});
    return std::filesystem::directory_iterator(cache.folder)->path();
  }();
  folder.write(file.filename().string(), Bytes(bytes.begin(), bytes.end()));
  if (const auto value = readCached(cache, "key")) demand(value->size() < bytes.size(), "a value is part of its file");
}

constexpr Target table[] = {
    {"gltf", "a model, whole way from bytes to a posed scene with its images", runGltf, gltfSeeds, 65536, true},
    {"validate", "what facet inspect says of a model by the letter", runValidate, gltfSeeds, 65536, true},
    {"lights", "EXT_lights_image_based, and the files that a model names", runLights, lightsSeeds, 16384, true},
    {"ies", "IES light profiles", runIes, iesSeeds, 4096, false},
    {"glb", "the binary container's framing", runGlb, glbSeeds, 4096, false},
    {"json", "the scan of JSON text before it is parsed", runJson, jsonSeeds, 4096, false},
    {"uri", "URIs, and which files they name", runUri, uriSeeds, 1024, false},
    {"draco", "KHR_draco_mesh_compression", runDraco, dracoSeeds, 8192, false},
    {"meshopt", "EXT_meshopt_compression", runMeshopt, meshoptSeeds, 8192, false},
    {"png", "PNG", runImage, pngSeeds, 8192, false},
    {"jpeg", "JPEG", runImage, jpegSeeds, 8192, false},
    {"webp", "WebP", runImage, webpSeeds, 8192, false},
    {"avif", "AVIF", runImage, avifSeeds, 8192, false},
    {"ktx2", "KTX2 and Basis Universal", runImage, ktx2Seeds, 8192, false},
    {"hdr", "Radiance pictures", runHdr, hdrSeeds, 8192, false},
    {"exr", "OpenEXR pictures", runExr, exrSeeds, 16384, false},
    {"merl", "MERL's BRDFs", runMerl, merlSeeds, 1024, false},
    {"utia", "UTIA's BRDFs", runUtia, utiaSeeds, 1024, false},
    {"cache", "entries of the disk caches", runCache, cacheSeeds, 4096, false},
};

}  // namespace

std::span<const Target> fileTargets() { return table; }

}  // namespace facet::fuzz
