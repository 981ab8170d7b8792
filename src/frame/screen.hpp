#pragma once

// What is known of what stands in the light's way without rays: shadow maps of the lights, and horizons in the depth
// buffer of the picture at half its size.

#include "frame/frame.hpp"
#include "frame/shadow_maps.hpp"

namespace facet::frame {

struct Screen {
  ShadowMaps shadows;
  int width = 0, height = 0;  // texels of the horizons
  gl::Texture depth;          // 32F, reversed
  gl::Texture found, shares;  // RG16F: open share, distance; as found, and smoothed
  gl::Framebuffer depthOnly, finding, smoothing;
  gl::VertexArray noAttributes;

  size_t bytes() const;  // of the textures
};

// Of one view, before its picture is drawn: shadow maps where they are not there, horizons anew. `in.screen` may be
// another's.
Result<void> prepareScreen(const FrameInput& in, Screen& screen, shading::ProgramStore& programs,
                           FrameStatistics& statistics);

// For the draws to come, where there is one.
void bindScreen(const FrameInput& in);

std::vector<ProgramGetter> neededScreenPrograms(const FrameInput& in, shading::ProgramStore& programs);

}  // namespace facet::frame
