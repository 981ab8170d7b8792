#include "shading/programs.hpp"

#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace facet::shading {

namespace {

using Clock = std::chrono::steady_clock;

// FNV-1a, 64 bit: names cache files only; the stored source is compared on reading.
uint64_t hash(std::string_view text) {
  uint64_t h = 14695981039346656037ull;
  for (const char c : text) h = (h ^ static_cast<uint8_t>(c)) * 1099511628211ull;
  return h;
}

std::string hex(uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

// File: length of the key, the key (driver and sources), format, binary.
gl::ProgramBinary readBinary(const std::filesystem::path& path, const std::string& key) {
  std::ifstream file(path, std::ios::binary);
  uint64_t keyLength = 0;
  gl::ProgramBinary binary;
  if (!file.read(reinterpret_cast<char*>(&keyLength), sizeof keyLength) || keyLength != key.size()) return {};
  std::string stored(key.size(), '\0');
  if (!file.read(stored.data(), static_cast<std::streamsize>(stored.size())) || stored != key) return {};
  if (!file.read(reinterpret_cast<char*>(&binary.format), sizeof binary.format)) return {};
  binary.bytes.assign(std::istreambuf_iterator<char>(file), {});
  return binary;
}

// Written aside and renamed, so that a reader in another process never sees half a file. Failing to write is no error.
void writeBinary(const std::filesystem::path& path, const std::string& key, const gl::ProgramBinary& binary) {
  std::error_code ignored;
  std::filesystem::create_directories(path.parent_path(), ignored);
  const std::filesystem::path temporary = path.string() + "." + std::to_string(getpid());
  {
    std::ofstream file(temporary, std::ios::binary);
    const uint64_t keyLength = key.size();
    file.write(reinterpret_cast<const char*>(&keyLength), sizeof keyLength);
    file.write(key.data(), static_cast<std::streamsize>(key.size()));
    file.write(reinterpret_cast<const char*>(&binary.format), sizeof binary.format);
    file.write(reinterpret_cast<const char*>(binary.bytes.data()), static_cast<std::streamsize>(binary.bytes.size()));
    file.close();
    if (!file) {
      std::filesystem::remove(temporary, ignored);
      return;
    }
  }
  std::filesystem::rename(temporary, path, ignored);
}

}  // namespace

std::filesystem::path userCacheFolder() {
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg == '/') return std::filesystem::path(xdg) / "facet";
  if (const char* home = std::getenv("HOME"); home && *home == '/')
    return std::filesystem::path(home) / ".cache" / "facet";
  return {};
}

ProgramStore::ProgramStore(ShaderReader reader, std::filesystem::path cacheFolder, std::string driver)
    : reader_(std::move(reader)), cacheFolder_(std::move(cacheFolder)), driver_(std::move(driver)) {}

Result<const gl::Program*> ProgramStore::render(const std::string& vertex, const std::string& fragment,
                                                const std::vector<Define>& defines) {
  return get({{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}, defines);
}

Result<const gl::Program*> ProgramStore::compute(const std::string& entry, const std::vector<Define>& defines) {
  return get({{GL_COMPUTE_SHADER, entry}}, defines);
}

Result<const gl::Program*> ProgramStore::get(const std::vector<Stage>& stages, const std::vector<Define>& defines) {
  std::string label;
  for (const Stage& stage : stages) label += (label.empty() ? "" : " + ") + stage.entry;
  for (const Define& define : defines) label += " " + define.name + (define.value == "1" ? "" : "=" + define.value);
  if (const auto found = programs_.find(label); found != programs_.end()) return &found->second;
  Result<gl::Program> program = build(stages, defines, label);
  if (!program) return tl::unexpected(program.error());
  return &programs_.emplace(label, std::move(*program)).first->second;
}

Result<gl::Program> ProgramStore::build(const std::vector<Stage>& stages, const std::vector<Define>& defines,
                                        const std::string& label) {
  const Clock::time_point start = Clock::now();
  const auto count = [&](int& counter) {
    ++counter;
    statistics_.milliseconds += std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  };
  std::vector<gl::ShaderSource> sources;
  std::vector<AssembledShader> assembled;
  std::string key = driver_;
  for (const Stage& stage : stages) {
    Result<AssembledShader> shader = assemble(stage.entry, defines, reader_);
    if (!shader) return tl::unexpected(shader.error());
    sources.push_back({stage.type, shader->text});
    key += shader->text;
    assembled.push_back(std::move(*shader));
  }
  const std::filesystem::path file =
      cacheFolder_.empty() ? std::filesystem::path() : cacheFolder_ / "programs" / (hex(hash(key)) + ".bin");
  if (!file.empty()) {
    const gl::ProgramBinary binary = readBinary(file, key);
    if (!binary.bytes.empty())
      if (gl::Program program = gl::Program::fromBinary(binary, label)) {
        count(statistics_.fromDisk);
        return program;
      }
  }
  Result<gl::Program> program = gl::Program::build(sources, label);
  if (!program) {
    Error error = program.error();
    // The error's place is the stage whose source the numbers in the log mean; a linker's log has none.
    for (size_t i = 0; i < stages.size(); ++i)
      if (error.place == gl::stageName(stages[i].type)) error.problem = translateLog(error.problem, assembled[i].files);
    error.problem.erase(error.problem.find_last_not_of(" \n\r") + 1);
    return tl::unexpected(error);
  }
  count(statistics_.compiled);
  if (!file.empty())
    if (const gl::ProgramBinary binary = program->binary(); !binary.bytes.empty()) writeBinary(file, key, binary);
  return program;
}

}  // namespace facet::shading
