// Paths of light under way: one each pixel at a time, moved on together a surface at a time (src/frame/paths.hpp). Read by
// C++ and by GLSL alike.
#pragma once
#include "both_languages.h"

LAYOUT_BEGIN

struct PathState {
  vec4 origin;     // xyz where the ray starts; w from which distance on it meets something
  vec4 direction;  // xyz unit; w density with which a surface drew it [1/sr], 0: it comes from the camera, negative: path_through.glsl
  vec4 throughput;  // rgb what of the radiance that the ray brings reaches the pixel; w share of broad lobes in that
  vec4 radiance;    // rgb what has been gathered; a coverage, or, where a drawn picture is corrected, alpha of the first surface
  // A light that is seen from the last surface unless something is between.
  vec4 lightOrigin;     // xyz; w distance to it
  vec3 lightDirection;  // unit
  uint outerMedia;      // as media, of the next four bodies
  vec4 lightRadiance;   // rgb what it adds; w as of throughput
  vec4 onMiss;          // rgb what it adds if the ray meets nothing; w 1: in the environment's place
  // What the ray has met: index of its triangle in the leaves' order, that of the placement's instance, where.
  uint triangle, instance;
  float distance;
  uint vertices;   // surfaces met so far
  vec2 weights;    // of the second and third corner
  uint pixel;      // x, in the upper half y
  uint media;      // bodies around the ray, the innermost in the lowest byte: number of the medium, 0 for none
};

// What paths of some rows have in common.
struct PathUniforms {
  // Where rays begin and where they go: at the picture's centre, and per half a picture to the right and up. The first
  // origin's w: nearest distance along the view's axis.
  vec4 origins[3];
  vec4 directions[3];
  uint paths;           // room for so many
  uint classes;         // of what a ray can meet
  uint number;          // which sample of its pixel
  uint mostVertices;    // surfaces that a path leaves
  uint firstRow, rows;  // of the picture, counted from the bottom
  uint lights;          // of the scene's, the first so many
  float share;          // of the picture
  vec2 offset;          // within the pixel, where paths correct what is drawn at it
  uint firstColumn, columns;  // of the picture
  uint glowing;               // triangles that paths look at as lights (path_glow.glsl)
  float perGlow;              // 1 over their luminance times area [1 / (nt m^2)]
  float unused1, unused2;
};

// Words of the work buffer: how many paths are at what, then lists of their indices.
LAYOUT_UINT workActive = 0u;   // paths under way
LAYOUT_UINT workNext = 1u;     // of those that go on
LAYOUT_UINT workLights = 2u;   // lights to be seen from surfaces
LAYOUT_UINT workTurn = 3u;     // surfaces after which the two lists of active paths have changed places
LAYOUT_UINT workRays = 4u;     // that have been traced so far, two words
LAYOUT_UINT workClasses = 6u;  // first of the classes' counters: number, first in the sorted list, placed so far
// Lists behind them, each as long as there are paths: active, next (they take turns), sorted by class, lights.
LAYOUT_UINT workLists = 4u;

// Work groups of the next dispatches, three words each.
LAYOUT_UINT groupsActive = 0u;
LAYOUT_UINT groupsLights = 1u;
LAYOUT_UINT groupsClasses = 2u;

// What a ray can meet: nothing, or a surface of a class that is shaded alike.
LAYOUT_UINT missClass = 0u;

// Texels of the environment's importance at its finest level, along an axis.
LAYOUT_UINT texelTableLargest = 2048u;

#ifdef __cplusplus
static_assert(sizeof(PathState) == 10 * 16);
static_assert(sizeof(PathUniforms) == 10 * 16);
#endif
LAYOUT_END
