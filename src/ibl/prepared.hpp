#pragma once

// An environment map before it goes on the GPU: no OpenGL, on any thread.

#include <optional>

#include "ibl/method.hpp"
#include "scene/environment.hpp"
#include "scene/sun.hpp"

namespace facet::ibl {

// A power of two by which radiance is divided before it is stored, so that half floats hold it: mostly 1.
float radianceScaleFor(const scene::Environment& environment);

// Reduces a map to at most the given width by an integer factor, each texel weighted by its solid angle.
scene::Environment reduceEquirect(const scene::Environment& environment, int maxWidth);

// Near the poles texels are needles that samples miss: there runs of texels take their mean, none wider on the sphere
// than maxWidth radians. The flux of every row stays what it is.
void blendPolarTexels(scene::Environment& environment, double maxWidth);

// What all tables of an environment begin with. A window makes it beside itself.
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

}  // namespace facet::ibl
