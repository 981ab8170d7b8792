#include "shading/programs.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <span>

namespace facet::shading {

namespace {

using Clock = std::chrono::steady_clock;

constexpr uintmax_t cachedBytes = 64 << 20;

// A cached program: format, binary.
gl::ProgramBinary unpacked(std::span<const std::byte> bytes) {
  gl::ProgramBinary binary;
  if (bytes.size() <= sizeof binary.format) return {};
  std::memcpy(&binary.format, bytes.data(), sizeof binary.format);
  binary.bytes.resize(bytes.size() - sizeof binary.format);
  std::memcpy(binary.bytes.data(), bytes.data() + sizeof binary.format, binary.bytes.size());
  return binary;
}

std::vector<std::byte> packed(const gl::ProgramBinary& binary) {
  std::vector<std::byte> bytes(sizeof binary.format + binary.bytes.size());
  std::memcpy(bytes.data(), &binary.format, sizeof binary.format);
  std::memcpy(bytes.data() + sizeof binary.format, binary.bytes.data(), binary.bytes.size());
  return bytes;
}

}  // namespace

ProgramStore::ProgramStore(ShaderReader reader, std::filesystem::path cacheFolder, std::string driver)
    : reader_(std::move(reader)),
      cache_{cacheFolder.empty() ? cacheFolder : cacheFolder / "programs", cachedBytes},
      driver_(std::move(driver)) {}

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
  if (const auto found = programs_.find(label); found != programs_.end()) {
    found->second.used = ++uses_;
    return &found->second.program;
  }
  Result<gl::Program> program = build(stages, defines, label);
  if (!program) return tl::unexpected(program.error());
  return &programs_.emplace(label, Kept{std::move(*program), ++uses_}).first->second.program;
}

void ProgramStore::keepLatest(size_t most) {
  if (programs_.size() <= most) return;
  std::vector<uint64_t> uses;
  for (const auto& [label, kept] : programs_) uses.push_back(kept.used);
  std::ranges::nth_element(uses, uses.end() - static_cast<ptrdiff_t>(most));
  const uint64_t oldest = most == 0 ? uses_ + 1 : uses[uses.size() - most];
  std::erase_if(programs_, [&](const auto& entry) { return entry.second.used < oldest; });
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
  if (const auto cached = readCached(cache_, key))
    if (gl::Program program = gl::Program::fromBinary(unpacked(*cached), label)) {
      count(statistics_.fromDisk);
      return program;
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
  if (!cache_.folder.empty())
    if (const gl::ProgramBinary binary = program->binary(); !binary.bytes.empty())
      writeCached(cache_, key, packed(binary));
  return program;
}

}  // namespace facet::shading
