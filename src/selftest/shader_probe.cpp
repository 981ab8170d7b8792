#include "selftest/shader_probe.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>

#include "gl/buffer.hpp"
#include "gl/program.hpp"
#include "layout.h"

namespace facet::selftest {

namespace {

std::string entryPoint(const Probe& probe) {
  std::string text = "#include \"layout.h\"\n";
  for (const std::string& chunk : probe.chunks) text += "#include \"" + chunk + "\"\n";
  text +=
      "layout(local_size_x = groupInvocations) in;\n"
      "layout(std430, binding = computeInputBinding) readonly buffer ProbeInput { vec4 probeInput[]; };\n"
      "layout(std430, binding = computeOutputBinding) writeonly buffer ProbeOutput { vec4 probeOutput[]; };\n"
      "layout(location = probeCountLocation) uniform int probeCount;\n"
      "void main() {\n"
      "  int i = int(gl_GlobalInvocationID.x);\n"
      "  if (i >= probeCount) return;\n";
  const auto element = [](const char* array, int count, int k) {
    return std::string(array) + "[i * " + std::to_string(count) + " + " + std::to_string(k) + "]";
  };
  for (int k = 0; k < probe.inputs; ++k)
    text += "  vec4 in" + std::to_string(k) + " = " + element("probeInput", probe.inputs, k) + ";\n";
  for (int k = 0; k < probe.outputs; ++k) text += "  vec4 out" + std::to_string(k) + " = vec4(0.0);\n";
  text += probe.body + "\n";
  for (int k = 0; k < probe.outputs; ++k)
    text += "  " + element("probeOutput", probe.outputs, k) + " = out" + std::to_string(k) + ";\n";
  return text + "}\n";
}

constexpr const char* entryName = "probe.comp.glsl";

Result<shading::AssembledShader> assembleProbe(const Probe& probe, const shading::ShaderReader& reader) {
  const std::string text = entryPoint(probe);
  return shading::assemble(entryName, probe.defines, [&](const std::string& path) {
    return path == entryName ? std::optional(text) : reader(path);
  });
}

}  // namespace

std::vector<std::string> probeFiles(const Probe& probe, const shading::ShaderReader& reader) {
  const Result<shading::AssembledShader> assembled = assembleProbe(probe, reader);
  return assembled ? assembled->files : std::vector<std::string>{};
}

Result<std::vector<glm::vec4>> runProbe(const Probe& probe, std::span<const glm::vec4> inputs,
                                        const shading::ShaderReader& reader) {
  Result<TimedProbe> run = timeProbe(probe, inputs, reader, 1);
  if (!run) return tl::unexpected(run.error());
  return std::move(run->values);
}

Result<TimedProbe> timeProbe(const Probe& probe, std::span<const glm::vec4> inputs, const shading::ShaderReader& reader,
                             int repeat) {
  assert(probe.inputs > 0 && inputs.size() % static_cast<size_t>(probe.inputs) == 0);
  const Result<shading::AssembledShader> assembled = assembleProbe(probe, reader);
  if (!assembled) return tl::unexpected(assembled.error());
  Result<gl::Program> program = gl::Program::build({{GL_COMPUTE_SHADER, assembled->text}}, "probe");
  if (!program) {
    Error error = program.error();
    error.problem = shading::translateLog(error.problem, assembled->files);
    return tl::unexpected(error);
  }
  const size_t count = inputs.size() / static_cast<size_t>(probe.inputs);
  const size_t outputs = count * static_cast<size_t>(probe.outputs);
  const gl::Buffer in(std::as_bytes(inputs), "probe input");
  const gl::Buffer out(outputs * sizeof(glm::vec4), "probe output");
  program->set(layout::probeCountLocation, static_cast<int>(count));
  glUseProgram(program->id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, in.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.id());
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    glDispatchCompute(static_cast<GLuint>(layout::groupsFor(static_cast<int>(count), layout::groupInvocations)), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    if (repeat > 1) glFinish();
    times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  return TimedProbe{out.read<glm::vec4>(outputs), *std::ranges::min_element(times)};
}

}  // namespace facet::selftest
