#pragma once

// Tables kept on disk, so that an environment is filtered once. A table is named by the environment's content (size and
// texels), the method with all of its parameters, the program's build and the driver: the same table comes back byte by
// byte, or none.

#include <string>

#include "base/disk_cache.hpp"
#include "ibl/tables.hpp"

namespace facet::ibl {

inline constexpr uintmax_t cachedTableBytes = uintmax_t{256} << 20;  // about a dozen environments

struct TableCache {
  DiskCache disk;
  std::string version;
};

// In $XDG_CACHE_HOME/facet/tables. driver: vendor, renderer and version. Off where the program's build is not known.
TableCache userTableCache(const std::string& driver);

// Names an environment's content.
std::string contentKey(const scene::Environment& environment);

// computeTables of what neither the tables nor the cache hold; what was computed goes into the cache. content: the
// environment's contentKey, made here where it is empty. tables.statistics names what came from the cache, too.
Result<void> prepareTables(Tables& tables, const scene::Environment* environment, std::string& content,
                           const Needs& needs, shading::ProgramStore& programs, const TableCache& cache,
                           const Method& method = {});

}  // namespace facet::ibl
