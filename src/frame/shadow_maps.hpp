#pragma once

// What lights see of the scene: for each a map of depths, for points within it six. Of opaque surfaces and of masked
// ones where they are there; what light passes through casts no shadow.

#include <glm/glm.hpp>
#include <vector>

#include "frame/draw_list.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "scene/camera.hpp"
#include "shading/programs.hpp"

namespace facet::frame {

struct FrameInput;
struct FrameStatistics;

// Texels along a map's edge: half as many where there are many maps.
int shadowMapSize(const DrawList& list);

// Says in list.lights which maps each of them has. Where mostShadowMaps do not do for all, those that need one come
// first.
void assignShadowMaps(DrawList& list);
// How many lights have none for lack of room.
int lightsWithoutMap(const DrawList& list);

// What each map shows, in their order: all of the scene, of the sun, of directional lights and from outside; of lights
// within it what lies around them, or in a spot's cone. environmentRotationDeg: of the environment, and so of its sun.
std::vector<scene::View> shadowViews(const DrawList& list, double environmentRotationDeg);

struct ShadowMaps {
  gl::Texture depths;  // DEPTH_COMPONENT32F array, reversed, compared
  gl::Buffer uniforms;
  bool drawn = false;                // of the list, and
  float environmentRotationDeg = 0;  // for this rotation
};

// Draws all of them, where they are not there or are another rotation's.
Result<void> drawShadowMaps(const FrameInput& in, ShadowMaps& maps, shading::ProgramStore& programs,
                            FrameStatistics& statistics);

}  // namespace facet::frame
