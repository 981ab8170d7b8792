#pragma once

// One draw of a list as OpenGL calls.

#include "frame/frame.hpp"

namespace facet::frame {

// The program, its textures and buffers are bound.
void issue(const FrameInput& in, const Draw& draw, FrameStatistics& statistics);

void setCulling(bool doubleSided);

// Its uniforms, and the textures that its draws read.
void bindMaterial(const FrameInput& in, const Draw& draw);

}  // namespace facet::frame
