#pragma once

// The depths of a scene's opaque surfaces, from any side.

#include "frame/frame.hpp"

namespace facet::frame {

enum class DepthOf { frontSides, bothSides };  // where the material has one side

// Into the framebuffer's depth, which is cleared, of that size or, of the rows of in.firstRow and on, lower; reversed.
// Instances, joints and weights need not be bound.
Result<void> drawDepth(const FrameInput& in, const scene::View& view, const gl::Framebuffer& framebuffer,
                       const glm::ivec2& size, DepthOf sides, shading::ProgramStore& programs,
                       FrameStatistics& statistics);

// What it needs for the list, each program once.
std::vector<ProgramGetter> neededDepthPrograms(const FrameInput& in, shading::ProgramStore& programs);

}  // namespace facet::frame
