#pragma once

// Programs by entry points and defines: compiled on first use, kept until others are used more, and as binaries on
// disk.

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "base/disk_cache.hpp"
#include "base/error.hpp"
#include "gl/program.hpp"
#include "shading/assembler.hpp"

namespace facet::shading {

struct ProgramStatistics {
  int compiled = 0;  // built from source in this process
  int fromDisk = 0;  // taken from the disk cache
  double milliseconds = 0;
};

// Of a process that draws on and on: a program takes three megabytes of a driver that draws on the CPU, and a picture
// needs ten or twenty.
inline constexpr size_t keptPrograms = 64;

class ProgramStore {
 public:
  // cacheFolder: empty = no disk cache. driver: vendor, renderer and version; part of the cache's key.
  ProgramStore(ShaderReader reader, std::filesystem::path cacheFolder, std::string driver);

  // The pointer stays valid until keepLatest() or reload(). Errors name chunk:line.
  Result<const gl::Program*> render(const std::string& vertex, const std::string& fragment,
                                    const std::vector<Define>& defines = {});
  Result<const gl::Program*> compute(const std::string& entry, const std::vector<Define>& defines = {});

  const ProgramStatistics& statistics() const { return statistics_; }
  size_t size() const { return programs_.size(); }
  // Of more than `most`, those that were used longest ago are freed: between pictures.
  void keepLatest(size_t most);
  void reload() { programs_.clear(); }  // after shader files have changed

 private:
  struct Stage {
    GLenum type;
    std::string entry;
  };
  Result<const gl::Program*> get(const std::vector<Stage>& stages, const std::vector<Define>& defines);
  Result<gl::Program> build(const std::vector<Stage>& stages, const std::vector<Define>& defines,
                            const std::string& label);

  ShaderReader reader_;
  DiskCache cache_;
  std::string driver_;
  struct Kept {
    gl::Program program;
    uint64_t used = 0;  // the larger the later
  };
  std::map<std::string, Kept> programs_;
  uint64_t uses_ = 0;
  ProgramStatistics statistics_;
};

}  // namespace facet::shading
