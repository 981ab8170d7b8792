#include "ibl/albedo.hpp"

#include "gl/buffer.hpp"
#include "layout.h"
#include "optics/quadrature.hpp"

namespace facet::ibl {

namespace {

using shading::ProgramStore;

gl::Texture tableTexture(const char* name, GLenum format, int size) {
  gl::Texture table({.format = format, .width = size, .height = size}, name);
  table.filterLinear();
  return table;
}

// A square table by quadrature over two variables.
struct AlbedoTable {
  const char* name;
  const char* pass;
  GLenum format;
  int size, firstNodes, secondNodes;
  int firstNodesLocation;
};

Result<void> computeAlbedo(gl::Texture& table, ProgramStore& programs, const AlbedoTable& made) {
  const auto program = programs.compute(made.pass);
  if (!program) return tl::unexpected(program.error());
  std::vector<glm::vec2> nodes;
  for (const int count : {made.firstNodes, made.secondNodes}) {
    const optics::Quadrature rule = optics::gaussLegendre(static_cast<size_t>(count));
    for (size_t i = 0; i < rule.nodes.size(); ++i) nodes.emplace_back(rule.nodes[i], rule.weights[i]);
  }
  const gl::Buffer input = gl::Buffer::of(nodes, "quadrature");
  table = tableTexture(made.name, made.format, made.size);
  glUseProgram((*program)->id());
  (*program)->set(made.firstNodesLocation, made.firstNodes);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, input.id());
  glBindImageTexture(0, table.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, made.format);
  dispatchFaces(made.size, 1);
  return {};
}

void addAlbedo(std::vector<Step>& steps, gl::Texture& table, ProgramStore& programs, const AlbedoTable& made) {
  const auto size = static_cast<uint64_t>(made.size);
  const auto nodes = static_cast<uint64_t>(made.firstNodes * made.secondNodes);
  steps.push_back(
      {made.name, size * size * nodes, [=, &table, &programs] { return computeAlbedo(table, programs, made); }});
}

Result<void> computeDfgByImportance(gl::Texture& table, ProgramStore& programs, int size, int samples) {
  const auto program = programs.compute("passes/dfg_importance.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  table = tableTexture("DFG", GL_RGBA32F, size);
  glUseProgram((*program)->id());
  (*program)->set(layout::dfgSamplesLocation, samples);
  glBindImageTexture(0, table.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  dispatchFaces(size, 1);
  return {};
}

}  // namespace

void addDfgSteps(std::vector<Step>& steps, gl::Texture& table, ProgramStore& programs, const Method& method) {
  if (method.dfg == DfgMethod::legendre)
    return addAlbedo(steps, table, programs,
                     {"DFG", "passes/dfg.comp.glsl", GL_RGBA16F, method.dfgSize, method.dfgRadii, method.dfgAngles,
                      layout::dfgRadiiLocation});
  const auto texels = static_cast<uint64_t>(method.dfgSize) * static_cast<uint64_t>(method.dfgSize);
  steps.push_back({"DFG", texels * static_cast<uint64_t>(method.dfgSamples),
                   [=, &table, &programs, size = method.dfgSize, samples = method.dfgSamples] {
                     return computeDfgByImportance(table, programs, size, samples);
                   }});
}

void addSheenSteps(std::vector<Step>& steps, gl::Texture& table, ProgramStore& programs, const Method& method) {
  addAlbedo(steps, table, programs,
            {"sheen", "passes/sheen_albedo.comp.glsl", GL_R32F, method.sheenSize, method.sheenHeights,
             method.sheenAngles, layout::sheenHeightsLocation});
}

}  // namespace facet::ibl
