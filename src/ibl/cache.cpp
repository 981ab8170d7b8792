#include "ibl/cache.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <sstream>

#include "ibl/layers.hpp"

namespace facet::ibl {

namespace {

using Clock = std::chrono::steady_clock;

struct Entry {
  const char* name;
  gl::Texture Tables::*texture;
  bool Needs::*need;
  bool ofEnvironment;
};
// The background is the file's own texels: nothing to be saved.
constexpr Entry entries[] = {{"DFG", &Tables::dfg, &Needs::dfg, false},
                             {"sheen", &Tables::sheen, &Needs::sheen, false},
                             {"irradiance", &Tables::irradiance, &Needs::irradiance, true},
                             {"LD mirror layers", &Tables::mirrorLayers, &Needs::layers, true},
                             {"LD rough layers", &Tables::roughLayers, &Needs::layers, true},
                             {"environment cube", &Tables::cube, &Needs::cube, true}};

// All of them: another value makes other tables.
std::string methodKey(const Method& m) {
  static_assert(sizeof(Method) == 120, "a new parameter belongs into this key");
  std::ostringstream text;
  text << std::hexfloat << static_cast<int>(m.cube) << ' ' << m.cubeTaps << ' ' << m.steepTaps << ' ' << m.steepness
       << ' ' << m.equirectWidth << ' ' << static_cast<int>(m.ld) << ' ' << m.samples << ' ' << m.filterGain << ' '
       << m.sumSize << ' ' << m.cutTolerance << ' ' << m.cutAcross << ' ' << m.cutByG2 << m.takeSunOut << ' '
       << static_cast<int>(m.irradiance) << ' ' << m.irradianceSize << ' ' << m.harmonicsOrder << ' '
       << static_cast<int>(m.dfg) << ' ' << m.dfgSize << ' ' << m.dfgRadii << ' ' << m.dfgAngles << ' ' << m.dfgSamples
       << ' ' << m.sheenSize << ' ' << m.sheenHeights << ' ' << m.sheenAngles;
  return text.str();
}

bool isLayer(const Entry& entry, size_t layer) {
  return entry.texture == (layers[layer].mirror ? &Tables::mirrorLayers : &Tables::roughLayers);
}
// The layers of an array that are needed: 1 or 0 for each.
std::string neededLayers(const Entry& entry, const Needs& needs) {
  std::string text;
  if (entry.need != &Needs::layers) return text;
  const LayerRange range = layersFor(needs.lowestRoughness, needs.highestRoughness);
  for (int i = range.first; i <= range.last; ++i)
    if (isLayer(entry, static_cast<size_t>(i))) text += std::to_string(i) + " ";
  return text;
}

std::string entryKey(const Entry& entry, const TableCache& cache, const std::string& content, const Method& method,
                     const Needs& needs) {
  return "facet table\n" + std::string(entry.name) + "\n" + (entry.ofEnvironment ? content : "-") + "\n" +
         methodKey(method) + "\n" + neededLayers(entry, needs) + "\n" + cache.version;
}

// How a texture's texels are moved; bytes 0: of a format that is not stored.
struct Transfer {
  GLenum format = GL_NONE, type = GL_NONE;
  size_t bytes = 0;  // a texel
};
Transfer transferOf(GLenum format) {
  switch (format) {
    case GL_R32F:
      return {GL_RED, GL_FLOAT, 4};
    case GL_RG16F:
      return {GL_RG, GL_HALF_FLOAT, 4};
    case GL_RGBA16F:
      return {GL_RGBA, GL_HALF_FLOAT, 8};
    case GL_RGBA32F:
      return {GL_RGBA, GL_FLOAT, 16};
    default:
      return {};
  }
}

int facesOf(const gl::TextureDescription& d) {
  if (d.target == GL_TEXTURE_CUBE_MAP) return 6;
  return d.target == GL_TEXTURE_CUBE_MAP_ARRAY ? 6 * d.layers : 1;
}
size_t levelBytes(const gl::TextureDescription& d, int level) {
  const auto size = [&](int edge) { return static_cast<size_t>(std::max(1, edge >> level)); };
  return size(d.width) * size(d.height) * static_cast<size_t>(facesOf(d)) * transferOf(d.format).bytes;
}
size_t texelBytes(const gl::TextureDescription& d) {
  size_t sum = 0;
  for (int level = 0; level < d.levels; ++level) sum += levelBytes(d, level);
  return sum;
}

// What precedes the texels.
struct StoredTexture {
  gl::TextureDescription description;
  GLint minFilter = 0, magFilter = 0;
  float radianceScale = 1;
};

std::vector<std::byte> pack(const gl::Texture& texture, float radianceScale) {
  StoredTexture stored{texture.description(), 0, 0, radianceScale};
  glGetTextureParameteriv(texture.id(), GL_TEXTURE_MIN_FILTER, &stored.minFilter);
  glGetTextureParameteriv(texture.id(), GL_TEXTURE_MAG_FILTER, &stored.magFilter);
  const gl::TextureDescription& d = stored.description;
  const Transfer transfer = transferOf(d.format);
  if (transfer.bytes == 0) return {};
  std::vector<std::byte> bytes(sizeof stored + texelBytes(d));
  std::memcpy(bytes.data(), &stored, sizeof stored);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  std::byte* at = bytes.data() + sizeof stored;
  for (int level = 0; level < d.levels; ++level) {
    const size_t size = levelBytes(d, level);
    glGetTextureImage(texture.id(), level, transfer.format, transfer.type, static_cast<GLsizei>(size), at);
    at += size;
  }
  return bytes;
}

// An empty texture where the bytes are none; they passed the checksum, so that they are this build's own.
gl::Texture unpack(const std::vector<std::byte>& bytes, const char* name, float& radianceScale) {
  StoredTexture stored;
  if (bytes.size() < sizeof stored) return {};
  std::memcpy(&stored, bytes.data(), sizeof stored);
  const gl::TextureDescription& d = stored.description;
  const Transfer transfer = transferOf(d.format);
  if (transfer.bytes == 0 || bytes.size() != sizeof stored + texelBytes(d)) return {};
  gl::Texture texture(d, name);
  texture.filterLinear();
  texture.parameter(GL_TEXTURE_MIN_FILTER, stored.minFilter);
  texture.parameter(GL_TEXTURE_MAG_FILTER, stored.magFilter);
  const std::byte* at = bytes.data() + sizeof stored;
  for (int level = 0; level < d.levels; ++level) {
    const int width = std::max(1, d.width >> level), height = std::max(1, d.height >> level);
    if (d.target == GL_TEXTURE_2D)
      glTextureSubImage2D(texture.id(), level, 0, 0, width, height, transfer.format, transfer.type, at);
    else
      glTextureSubImage3D(texture.id(), level, 0, 0, 0, width, height, facesOf(d), transfer.format, transfer.type, at);
    at += levelBytes(d, level);
  }
  radianceScale = stored.radianceScale;
  return texture;
}

bool wanted(const Entry& entry, const Tables& tables, const Needs& needs) {
  if (entry.need == &Needs::layers && neededLayers(entry, needs).empty()) return false;
  return needs.*entry.need && !(tables.*entry.texture);
}

std::vector<TableStatistics> load(Tables& tables, const Needs& needs, const TableCache& cache,
                                  const std::string& content, const Method& method) {
  std::vector<TableStatistics> loaded;
  for (const Entry& entry : entries) {
    if (!wanted(entry, tables, needs)) continue;
    const auto start = Clock::now();
    const auto bytes = readCached(cache.disk, entryKey(entry, cache, content, method, needs));
    if (!bytes) continue;
    float radianceScale = 1;
    gl::Texture texture = unpack(*bytes, entry.name, radianceScale);
    if (!texture) continue;
    if (entry.ofEnvironment) tables.radianceScale = radianceScale;
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
    loaded.push_back({std::string(entry.name) + " (cached)", texture.bytes(), 0, spent.count()});
    tables.*entry.texture = std::move(texture);
    if (entry.need == &Needs::layers) {
      const LayerRange range = layersFor(needs.lowestRoughness, needs.highestRoughness);
      for (int i = range.first; i <= range.last; ++i)
        if (const auto layer = static_cast<size_t>(i); isLayer(entry, layer)) tables.layersMade[layer] = true;
    }
  }
  return loaded;
}

}  // namespace

TableCache userTableCache(const std::string& driver) {
  const std::string build = buildId();
  const std::filesystem::path folder = userCacheFolder();
  if (build.empty() || folder.empty()) return {};
  return {{folder / "tables", cachedTableBytes}, build + "\n" + driver};
}

std::string contentKey(const scene::Environment& environment) {
  const std::array<uint64_t, 2> hash = contentHash(std::as_bytes(std::span(environment.radiance)));
  return std::to_string(environment.width) + "x" + std::to_string(environment.height) + " " + hexText(hash[0]) +
         hexText(hash[1]);
}

Result<void> prepareTables(Tables& tables, const scene::Environment* environment, std::string& content,
                           const Needs& needs, shading::ProgramStore& programs, const TableCache& cache,
                           const Method& method) {
  const auto isWanted = [&](const Entry& entry) { return wanted(entry, tables, needs); };
  std::vector<const Entry*> missing;
  std::vector<TableStatistics> loaded;
  if (!cache.disk.folder.empty() && std::ranges::any_of(entries, isWanted)) {
    if (content.empty() && environment) content = contentKey(*environment);
    loaded = load(tables, needs, cache, content, method);
    for (const Entry& entry : entries)
      if (isWanted(entry)) missing.push_back(&entry);
  }
  if (!loaded.empty() && method.takeSunOut && environment)
    if (const std::optional<scene::FoundSun> found = scene::findSun(*environment)) tables.sun = found->sun;
  if (Result<void> r = computeTables(tables, environment, needs, programs, method); !r) return r;
  for (const Entry* entry : missing)
    if (const std::vector<std::byte> bytes = pack(tables.*entry->texture, tables.radianceScale); !bytes.empty())
      writeCached(cache.disk, entryKey(*entry, cache, content, method, needs), bytes);
  tables.statistics.insert(tables.statistics.begin(), loaded.begin(), loaded.end());
  return {};
}

}  // namespace facet::ibl
