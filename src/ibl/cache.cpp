#include "ibl/cache.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <sstream>

#include "gl/context.hpp"
#include "ibl/layers.hpp"

namespace facet::ibl {

namespace {

using Clock = std::chrono::steady_clock;

// All of them: another value makes other tables.
std::string methodKey(const Method& m) {
  static_assert(sizeof(Method) == 120, "a new parameter belongs into this key");
  std::ostringstream text;
  text << std::hexfloat;
  for (const int choice : {int(m.cube), int(m.ld), int(m.irradiance), int(m.dfg), int(m.cutByG2), int(m.takeSunOut)})
    text << choice << ' ';
  for (const int number :
       {m.cubeTaps, m.steepTaps, m.equirectWidth, m.samples, m.sumSize, m.irradianceSize, m.harmonicsOrder, m.dfgSize,
        m.dfgRadii, m.dfgAngles, m.dfgSamples, m.sheenSize, m.sheenHeights, m.sheenAngles})
    text << number << ' ';
  text << m.steepness << ' ' << m.filterGain << ' ' << m.cutTolerance << ' ' << m.cutAcross;
  return text.str();
}

std::string keyOf(const Piece& piece, const TableCache& cache, const std::string& content, const Method& method) {
  return "facet table\n" + piece.name + "\n" + (piece.ofEnvironment ? content : "-") + "\n" + methodKey(method) + "\n" +
         cache.version;
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
    case GL_RG32F:
      return {GL_RG, GL_FLOAT, 8};
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

// The part of a texture that a piece is.
struct Region {
  int firstLevel = 0, levels = 1;
  int firstFace = 0, faces = 1;
};
Region regionOf(const Piece& piece, const gl::TextureDescription& d) {
  if (piece.layer >= 0) {
    const Layer& layer = layers[static_cast<size_t>(piece.layer)];
    return {layer.level, 1, 6 * layer.cube, 6};
  }
  return {0, d.levels, 0, d.target == GL_TEXTURE_CUBE_MAP ? 6 : 1};
}

int edge(int size, int level) { return std::max(1, size >> level); }

size_t levelBytes(const gl::TextureDescription& d, const Region& region, int level) {
  return static_cast<size_t>(edge(d.width, level)) * static_cast<size_t>(edge(d.height, level)) *
         static_cast<size_t>(region.faces) * transferOf(d.format).bytes;
}
size_t regionBytes(const gl::TextureDescription& d, const Region& region) {
  size_t sum = 0;
  for (int i = 0; i < region.levels; ++i) sum += levelBytes(d, region, region.firstLevel + i);
  return sum;
}

// What precedes the texels.
struct StoredTexture {
  gl::TextureDescription description;
  GLint minFilter = 0, magFilter = 0;
  float radianceScale = 1;
};

gl::Texture created(const StoredTexture& stored, const std::string& name) {
  gl::Texture texture(stored.description, name);
  texture.filterLinear();
  texture.parameter(GL_TEXTURE_MIN_FILTER, stored.minFilter);
  texture.parameter(GL_TEXTURE_MAG_FILTER, stored.magFilter);
  return texture;
}

bool sameStorage(const gl::TextureDescription& a, const gl::TextureDescription& b) {
  return a.target == b.target && a.format == b.format && a.width == b.width && a.height == b.height &&
         a.layers == b.layers && a.levels == b.levels;
}

void upload(const gl::Texture& texture, const Region& region, const std::byte* at) {
  const gl::TextureDescription& d = texture.description();
  const Transfer transfer = transferOf(d.format);
  for (int level = region.firstLevel; level < region.firstLevel + region.levels; ++level) {
    const int width = edge(d.width, level), height = edge(d.height, level);
    if (d.target == GL_TEXTURE_2D)
      glTextureSubImage2D(texture.id(), level, 0, 0, width, height, transfer.format, transfer.type, at);
    else
      glTextureSubImage3D(texture.id(), level, 0, 0, region.firstFace, width, height, region.faces, transfer.format,
                          transfer.type, at);
    at += levelBytes(d, region, level);
  }
}

// False where the bytes are none of the piece's; they passed the checksum, so that they are this build's own.
bool unpack(const std::vector<std::byte>& bytes, const Piece& piece, Tables& tables) {
  StoredTexture stored;
  if (bytes.size() < sizeof stored) return false;
  std::memcpy(&stored, bytes.data(), sizeof stored);
  const Region region = regionOf(piece, stored.description);
  if (transferOf(stored.description.format).bytes == 0) return false;
  if (bytes.size() != sizeof stored + regionBytes(stored.description, region)) return false;
  gl::Texture& texture = tables.*piece.texture;
  if (!texture) texture = created(stored, piece.name);
  if (!sameStorage(texture.description(), stored.description)) return false;
  upload(texture, region, bytes.data() + sizeof stored);
  if (piece.layer >= 0) tables.layersMade[static_cast<size_t>(piece.layer)] = true;
  if (piece.ofEnvironment) tables.radianceScale = stored.radianceScale;
  return true;
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

std::vector<Piece> missingPieces(const Tables& tables, const Needs& needs) {
  std::vector<Piece> pieces;
  const auto add = [&](const char* name, gl::Texture Tables::*texture, bool need, bool ofEnvironment) {
    if (need && !(tables.*texture)) pieces.push_back({name, texture, -1, ofEnvironment});
  };
  add("DFG", &Tables::dfg, needs.dfg, false);
  add("sheen", &Tables::sheen, needs.sheen, false);
  add("irradiance", &Tables::irradiance, needs.irradiance, true);
  add("environment cube", &Tables::cube, needs.cube, true);
  add("environment without lamps", &Tables::rest, needs.samples, true);
  add("lamps", &Tables::lamps, needs.samples, true);
  add("lamp points", &Tables::lampPoints, needs.samples, true);
  if (!needs.layers) return pieces;
  const LayerRange range = layersFor(needs.lowestRoughness, needs.highestRoughness);
  for (int i = range.first; i <= range.last; ++i)
    if (!tables.layersMade[static_cast<size_t>(i)])
      pieces.push_back({"LD layer " + std::to_string(i),
                        layers[static_cast<size_t>(i)].mirror ? &Tables::mirrorLayers : &Tables::roughLayers, i, true});
  return pieces;
}

PackedPiece packPiece(const Tables& tables, const Piece& piece, const std::string& content, const TableCache& cache,
                      const Method& method) {
  const gl::Texture& texture = tables.*piece.texture;
  StoredTexture stored{texture.description(), 0, 0, tables.radianceScale};
  glGetTextureParameteriv(texture.id(), GL_TEXTURE_MIN_FILTER, &stored.minFilter);
  glGetTextureParameteriv(texture.id(), GL_TEXTURE_MAG_FILTER, &stored.magFilter);
  const gl::TextureDescription& d = stored.description;
  const Transfer transfer = transferOf(d.format);
  const Region region = regionOf(piece, d);
  PackedPiece packed{keyOf(piece, cache, content, method), {}};
  if (transfer.bytes == 0) return packed;
  packed.bytes.resize(sizeof stored + regionBytes(d, region));
  std::memcpy(packed.bytes.data(), &stored, sizeof stored);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  std::byte* at = packed.bytes.data() + sizeof stored;
  for (int level = region.firstLevel; level < region.firstLevel + region.levels; ++level) {
    const size_t size = levelBytes(d, region, level);
    glGetTextureSubImage(texture.id(), level, 0, 0, region.firstFace, edge(d.width, level), edge(d.height, level),
                         region.faces, transfer.format, transfer.type, static_cast<GLsizei>(size), at);
    at += size;
  }
  return packed;
}

Result<void> loadTables(Tables& tables, const scene::Environment* environment, std::string& content, const Needs& needs,
                        const TableCache& cache, const Method& method) {
  tables.statistics.clear();
  if (cache.disk.folder.empty()) return {};
  const std::vector<Piece> missing = missingPieces(tables, needs);
  const auto layersBefore = tables.layersMade;
  std::vector<gl::Texture Tables::*> absent;
  for (const Piece& piece : missing)
    if (!(tables.*piece.texture)) absent.push_back(piece.texture);
  for (const Piece& piece : missing) {
    if (content.empty() && piece.ofEnvironment) content = contentKey(*environment);
    const auto start = Clock::now();
    const auto bytes = readCached(cache.disk, keyOf(piece, cache, content, method));
    if (!bytes || !unpack(*bytes, piece, tables)) continue;
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start;
    const std::string name = (piece.layer >= 0 ? "LD layers" : piece.name) + " (cached)";
    std::vector<TableStatistics>& booked = tables.statistics;
    if (booked.empty() || booked.back().name != name) booked.push_back({.name = name});
    booked.back().bytes += bytes->size() - sizeof(StoredTexture);
    booked.back().milliseconds += spent.count();
  }
  Result<void> whole = gl::checkDriver(tablesOfLight);
  if (whole) return whole;
  for (gl::Texture Tables::*texture : absent) tables.*texture = {};
  tables.layersMade = layersBefore;
  return whole;
}

Result<void> prepareTables(Tables& tables, const scene::Environment* environment, std::string& content,
                           const Needs& needs, shading::ProgramStore& programs, const TableCache& cache,
                           const Method& method, const PreparedEnvironment* prepared, const scene::FoundSun* found) {
  if (Result<void> r = loadTables(tables, environment, content, needs, cache, method); !r) return r;
  const std::vector<TableStatistics> loaded = tables.statistics;
  const std::vector<Piece> missing = missingPieces(tables, needs);
  if (Result<void> r = computeTables(tables, environment, needs, programs, method, prepared, found); !r) return r;
  if (!cache.disk.folder.empty())
    for (const Piece& piece : missing) {
      const PackedPiece packed = packPiece(tables, piece, content, cache, method);
      writeCached(cache.disk, packed.key, packed.bytes);
    }
  tables.statistics.insert(tables.statistics.begin(), loaded.begin(), loaded.end());
  return {};
}

}  // namespace facet::ibl
