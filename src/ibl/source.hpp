#pragma once

// An equirectangular map on the GPU and the cube that everything is filtered from.

#include <optional>

#include "base/error.hpp"
#include "gl/texture.hpp"
#include "ibl/method.hpp"
#include "scene/environment.hpp"
#include "scene/sun.hpp"
#include "shading/programs.hpp"

namespace facet::ibl {

// A power of two by which radiance is divided before it is stored, so that half floats hold it: mostly 1.
float radianceScaleFor(const scene::Environment& environment);

// In the map's units divided by scale. The texture, and the rows [first, end) of it.
gl::Texture equirectTexture(const scene::Environment& environment, GLenum format, std::string_view label);
void uploadEquirectRows(const gl::Texture& texture, const scene::Environment& environment, float scale, int first,
                        int end);

// Reduces a map to at most the given width by an integer factor, each texel weighted by its solid angle.
scene::Environment reduceEquirect(const scene::Environment& environment, int maxWidth);

// Near the poles texels are needles that samples miss: there runs of texels take their mean, none wider on the sphere
// than maxWidth radians. The flux of every row stays what it is.
void blendPolarTexels(scene::Environment& environment, double maxWidth);

// What all tables of an environment begin with, as far as no OpenGL is needed: a window makes it beside itself.
struct PreparedEnvironment {
  float radianceScale = 1;
  std::optional<scene::Sun> sun;  // taken out of `reduced`; only where the method asks for it
  scene::Environment reduced;     // at most method.equirectWidth wide
};
// found: what scene::findSun says of it, where it is known to have a sun; null: it is asked where the method wants it.
PreparedEnvironment prepareEnvironment(const scene::Environment& environment, const Method& method,
                                       const scene::FoundSun* found = nullptr);
// The same at another width.
PreparedEnvironment reducedFurther(const PreparedEnvironment& prepared, int maxWidth);

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
