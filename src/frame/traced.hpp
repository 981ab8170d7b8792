#pragma once

// A draw list as rays meet it: all primitives with triangles, each where its instances put it, skinned and morphed as
// it is drawn. Pure, no OpenGL.

#include <deque>

#include "frame/draw_list.hpp"
#include "frame/scene_part.hpp"
#include "rays/traced_scene.hpp"

namespace facet::frame {

// What of it is shaded alike: one program, and one set of textures where there are any.
struct PathClass {
  shading::VariantKey key;                      // without what only drawing reads
  int material = -1;                            // index in DrawList::materials of those textures; -1: it has none
  const scene::Primitive* primitive = nullptr;  // one of those that are of it
};

// A triangle that glows, as shaders/path_glow.glsl reads it.
struct GlowingTriangle {
  glm::vec3 corner = glm::vec3(0);
  float shareUpTo = 0;  // of all light, this one's too
  glm::vec4 edge1 = glm::vec4(0), edge2 = glm::vec4(0);
  glm::vec3 radiance = glm::vec3(0);
  float share = 0;
};
static_assert(sizeof(GlowingTriangle) == layout::glowingTexels * 16);

struct TracedList {
  rays::TracedScene scene;       // Triangle::primitive: index in parts
  std::vector<ScenePart> parts;  // ScenePart::shading: 1 + index in classes
  std::vector<PathClass> classes;
  // The list's, and two that leave data in the world as they are: of shapes that wind as they did, and of mirrored
  // ones.
  std::vector<layout::Instance> instances;
  std::deque<scene::Primitive> deformed;  // in the world; parts point to them
  // Opaque ones of one emission that no coat covers, in the world: paths look at them as at lights. Others are found by
  // chance: textured emission, what is instanced as a tree of its own.
  std::vector<GlowingTriangle> glowing;
  double glow = 0;     // sum of luminance times area [nt m^2]
  int lights = 0;      // of the list's, the first so many: the environment holds its sun itself
  bool media = false;  // there are bodies that light passes through
  int thin = 0;        // draws of lines and points, which rays do not meet
};

// A draw's vertices in the world, as shaders/passes/mesh.vert.glsl places them: skinned, morphed, relative to the
// list's origin.
scene::Primitive placedShape(const DrawList& list, const Draw& draw, const layout::Instance& instance);

// Points of the world relative to the list's origin, as on the GPU.
TracedList tracedList(const DrawList& list);

}  // namespace facet::frame
