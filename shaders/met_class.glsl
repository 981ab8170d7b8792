// Which class of surfaces a ray has met (PathClass of frame/traced.hpp).
#include "rays.glsl"
#include "scene_primitives.glsl"

// rayNone: missClass.
uint metClass(uint triangle) {
  if (triangle == rayNone) return missClass;
  return scenePrimitives[rayTriangle(triangle).primitive & rayPrimitiveMask].shading;
}
