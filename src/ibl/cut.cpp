#include "ibl/cut.hpp"

#include <cassert>
#include <vector>

#include "layout.h"

namespace facet::ibl {

namespace {

constexpr GLbitfield written =
    GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT;

int groups(int texels) { return layout::groupsFor(texels); }

// Finest level first.
int levelOffset(int treeSize, int size) { return 8 * (treeSize * treeSize - size * size); }

}  // namespace

Result<CutTree> buildCutTree(const gl::Texture& cube, shading::ProgramStore& programs) {
  const auto program = programs.compute("passes/cut_nodes.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  CutTree tree;
  tree.size = cube.description().width;
  assert(tree.size >= 8 && tree.size <= 1024);
  const size_t count = static_cast<size_t>(levelOffset(tree.size, 1) + 6);
  tree.nodes = gl::Buffer(count * sizeof(glm::vec4), "cut tree");
  tree.visits = gl::Buffer::of(std::vector<uint32_t>{0}, "nodes visited");
  glUseProgram((*program)->id());
  glBindImageTexture(0, cube.id(), 0, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, tree.nodes.id());
  for (int size = tree.size; size >= 1; size /= 2) {
    (*program)->set(layout::nodesSizeLocation, size);
    (*program)->set(layout::nodesOffsetLocation, levelOffset(tree.size, size));
    (*program)->set(layout::nodesFineOffsetLocation, size == tree.size ? -1 : levelOffset(tree.size, 2 * size));
    glDispatchCompute(static_cast<GLuint>(groups(size)), static_cast<GLuint>(groups(size)), 6);
    glMemoryBarrier(written);
  }
  return tree;
}

Result<void> drawCut(const CutTarget& target, double alpha, const CutTree& tree, const gl::Texture& cube,
                     shading::ProgramStore& programs, const CutParameters& parameters) {
  assert(alpha > 0);
  const auto program = programs.compute("passes/prefilter_cut.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  glUseProgram((*program)->id());
  (*program)->set(layout::layerCubeLocation, target.cube);
  (*program)->set(layout::layerFirstFaceLocation, target.face);
  (*program)->set(layout::cutFirstRowLocation, target.firstRow);
  (*program)->set(layout::cutTreeSizeLocation, tree.size);
  (*program)->set(layout::cutParametersLocation,
                  glm::vec4(alpha, parameters.tolerance, parameters.across, parameters.weightedByG2 ? 1 : 0));
  cube.bind(layout::sourceUnit);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, tree.nodes.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, tree.visits.id());
  glBindImageTexture(0, target.array, target.level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
  glDispatchCompute(static_cast<GLuint>(groups(target.size)), static_cast<GLuint>(groups(target.rows)), 1);
  glMemoryBarrier(written);
  return {};
}

}  // namespace facet::ibl
