#pragma once

// LD by an adaptive cut through a tree of the environment's texels (passes/prefilter_cut.comp.glsl).

#include "base/error.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "shading/programs.hpp"

namespace facet::ibl {

// Nodes with mean radiance and mean square of luminance, from a cube's finest level on down to 1^2: weighted by solid
// angle, in single precision (squares of a sun's radiance exceed half floats).
struct CutTree {
  gl::Buffer nodes;
  gl::Buffer visits;  // uint: nodes read by all cuts so far
  int size = 0;       // of the finest level's faces

  uint64_t readVisits() const { return visits.read<uint32_t>(1)[0]; }  // waits; counts modulo 2^32
};
// cube: RGBA32F, at least 8^2.
Result<CutTree> buildCutTree(const gl::Texture& cube, shading::ProgramStore& programs);

struct CutParameters {
  double tolerance = 0.01;  // largest error of a node, of the result
  double across = 1.5;      // nodes across the kernel's scale, at least
  bool weightedByG2 = false;
};

// Rows of a face of a layer: alpha > 0.
struct CutTarget {
  GLuint array = 0;  // cube map array, RGBA16F
  int cube = 0, level = 0, size = 0;
  int face = 0, firstRow = 0, rows = 0;
};
Result<void> drawCut(const CutTarget& target, double alpha, const CutTree& tree, const gl::Texture& cube,
                     shading::ProgramStore& programs, const CutParameters& parameters = {});

}  // namespace facet::ibl
