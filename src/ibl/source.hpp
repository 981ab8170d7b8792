#pragma once

// An equirectangular map on the GPU and the cube that everything is filtered from.

#include "base/error.hpp"
#include "gl/texture.hpp"
#include "ibl/prepared.hpp"
#include "shading/programs.hpp"

namespace facet::ibl {

// In the map's units divided by scale. The texture, and the rows [first, end) of it.
gl::Texture equirectTexture(const scene::Environment& environment, GLenum format, std::string_view label);
void uploadEquirectRows(const gl::Texture& texture, const scene::Environment& environment, float scale, int first,
                        int end);

// What an environment's cube is made from.
struct CubeSource {
  gl::Texture equirect;
  float steep = 0;  // difference of taps above which a texel takes more of them
};
CubeSource cubeSource(const PreparedEnvironment& prepared, const Method& method);

// Level 0 of the cube, these faces of it; alpha = the texel's solid angle.
Result<void> drawCubeFaces(const gl::Texture& cube, const CubeSource& source, int firstFace, int faces,
                           shading::ProgramStore& programs, const Method& method);
// All further levels, weighted by solid angle.
Result<void> drawCubeLevels(const gl::Texture& cube, shading::ProgramStore& programs);

gl::Texture cubeTexture(GLenum format, int size, int levels, std::string_view label);
// The first level whose faces are at most that large.
int levelOfSize(const gl::Texture& cube, int size);
void dispatchFaces(int size, int faces = 6);

uint64_t cubeFetches(int size, const Method& method);

}  // namespace facet::ibl
