#pragma once

// Tables kept on disk, so that an environment is filtered once. A table is named by the environment's content (size and
// texels), the method with all of its parameters, the program's build and the driver: the same table comes back byte by
// byte, or none.

#include <string>

#include "base/disk_cache.hpp"
#include "ibl/tables.hpp"

namespace facet::ibl {

inline constexpr uintmax_t cachedTableBytes = uintmax_t{256} << 20;  // a dozen environments

struct TableCache {
  DiskCache disk;
  std::string version;
};

// In $XDG_CACHE_HOME/facet/tables. driver: vendor, renderer and version. Off where the program's build is not known.
TableCache userTableCache(const std::string& driver);

// Names an environment's content.
std::string contentKey(const scene::Environment& environment);

// What of the needed tables is not there yet and the cache holds goes into the tables; tables.statistics names it.
// content: the environment's, made here where it is empty. Errors: the driver's, which leave the tables as they were.
Result<void> loadTables(Tables& tables, const scene::Environment* environment, std::string& content, const Needs& needs,
                        const TableCache& cache, const Method& method = {});

// What may be kept: a table, or a layer of LD.
struct Piece {
  std::string name;
  gl::Texture Tables::*texture = nullptr;
  int layer = -1;  // of LD
  bool ofEnvironment = false;
};
// What is needed and not there yet, but for the background, which is the file's own texels.
std::vector<Piece> missingPieces(const Tables& tables, const Needs& needs);

// A piece, read back from the GPU, on its way into the cache.
struct PackedPiece {
  std::string key;
  std::vector<std::byte> bytes;
};
PackedPiece packPiece(const Tables& tables, const Piece& piece, const std::string& content, const TableCache& cache,
                      const Method& method = {});

// computeTables of what neither the tables nor the cache hold; what was computed goes into the cache.
// tables.statistics names what came from the cache, too.
Result<void> prepareTables(Tables& tables, const scene::Environment* environment, std::string& content,
                           const Needs& needs, shading::ProgramStore& programs, const TableCache& cache,
                           const Method& method = {}, const PreparedEnvironment* prepared = nullptr,
                           const scene::FoundSun* found = nullptr);

}  // namespace facet::ibl
