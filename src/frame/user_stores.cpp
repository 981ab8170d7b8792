#include "frame/user_stores.hpp"

#include "base/log.hpp"

namespace facet::frame {

namespace {

std::string driverName(const gl::ContextInfo& info) { return info.vendor + "\n" + info.renderer + "\n" + info.version; }

}  // namespace

shading::ProgramStore userPrograms(const gl::ContextInfo& context, const std::string& shaderDir, bool diskCache) {
  const bool cached = diskCache && context.programBinaries;
  if (const std::string problem = userCacheProblem(); diskCache && !problem.empty()) log::warning(problem);
  return {shading::shaderReader(shaderDir), cached ? userCacheFolder() : std::filesystem::path(), driverName(context)};
}

ibl::TableCache userTables(const gl::ContextInfo& context, const std::string& shaderDir, bool diskCache) {
  return diskCache && shaderDir.empty() ? ibl::userTableCache(driverName(context)) : ibl::TableCache();
}

}  // namespace facet::frame
