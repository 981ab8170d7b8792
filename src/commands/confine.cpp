#include "commands/confine.hpp"

#include <cstdlib>

#include "base/disk_cache.hpp"
#include "base/log.hpp"
#include "io/gltf_environment.hpp"
#include "io/measured.hpp"
#include "io/sources.hpp"

namespace facet::commands {

namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& file) {
  std::error_code ignored;
  const fs::path whole = fs::absolute(fs::weakly_canonical(file, ignored), ignored);
  return whole.parent_path();
}

bool isFile(const std::string& source) {
  return !source.empty() && source != "none" && source != io::standardInput && !source.starts_with(io::builtinPrefix);
}

// What a glTF file names lies beside it; through a link, beside the link.
void needModel(Needed& needed, const fs::path& file) {
  std::error_code ignored;
  needed.read.push_back(folderOf(file)), needed.read.push_back(fs::absolute(file, ignored).parent_path());
}

// Mesa's and NVIDIA's.
constexpr const char* driverCaches[] = {"MESA_SHADER_CACHE_DIR", "__GL_SHADER_DISK_CACHE_PATH"};

}  // namespace

void needPicture(Needed& needed, const std::string& model, const frame::PictureSettings& settings) {
  const frame::Sources& sources = settings.sources;
  if (isFile(model)) needModel(needed, model);
  for (const std::string& other : sources.with)
    if (isFile(other)) needModel(needed, other);
  for (const std::string& folder : {sources.allowOutside, sources.shaderDir})
    if (!folder.empty()) needed.read.emplace_back(folder);
  if (isFile(sources.environment)) {
    const std::string file = io::splitLayer(sources.environment).file;
    needed.read.emplace_back(file);
    if (io::isGltfName(file)) needModel(needed, file);  // its images may be files of their own
  }
  if (!sources.bump.empty()) needed.read.emplace_back(sources.bump);
  if (isFile(sources.brdf)) needMeasured(needed, sources.brdf, sources.brdfDir);
}

void needFiles(Needed& needed, const fs::path& fileOrFolder) {
  if (fileOrFolder.empty()) return;
  needed.read.push_back(fileOrFolder);
  std::error_code problem;
  for (fs::directory_iterator it(fileOrFolder, problem), end; !problem && it != end; it.increment(problem)) {
    std::error_code ignored;
    if (it->is_symlink(ignored)) needed.read.push_back(it->path());
  }
}

void needMeasured(Needed& needed, const std::string& source, const fs::path& brdfDir) {
  if (isFile(source)) needFiles(needed, source);
  for (const fs::path& folder : io::brdfFolders(brdfDir)) needFiles(needed, folder);
}

void addNoSandbox(CLI::App& app, bool& noSandbox) {
  app.add_flag("--no-sandbox", noSandbox, "read files with all of the user's rights");
}

void needOutput(Needed& needed, const fs::path& file) {
  if (!file.empty() && file != "-") needed.written.push_back(folderOf(file));
}

void needOutputFolder(Needed& needed, const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code ignored;
  fs::path there = fs::absolute(folder, ignored).lexically_normal();
  while (!fs::exists(there, ignored) && there.has_relative_path()) there = there.parent_path();
  needed.written.push_back(there);
}

void keepDriverCacheApart() {
  fs::path folder = userCacheFolder();
  if (folder.empty()) {
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 0), setenv("__GL_SHADER_DISK_CACHE", "0", 0);
    return;
  }
  folder /= "driver";
  std::error_code ignored;
  fs::create_directories(folder, ignored);
  for (const char* variable : driverCaches) setenv(variable, folder.c_str(), 0);
  setenv("MESA_SHADER_CACHE_MAX_SIZE", "128M", 0);
}

Confined confine(Needed needed, bool ownCache) {
  for (const char* variable : driverCaches)
    if (const char* folder = std::getenv(variable)) needed.written.emplace_back(folder);
  if (const fs::path cache = ownCache ? userCacheFolder() : fs::path(); !cache.empty()) {
    std::error_code ignored;
    fs::create_directories(cache, ignored);
    needed.written.push_back(cache);
  }
  const Confined confined = confineProcess(needed);
  log::debug("sandbox: files " + confined.files + ", calls " + confined.calls);
  return confined;
}

}  // namespace facet::commands
