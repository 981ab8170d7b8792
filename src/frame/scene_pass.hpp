#pragma once

// One draw of the scene, of those that a picture gathers (gather.hpp).

#include "frame/frame.hpp"
#include "frame/visibility.hpp"

namespace facet::frame {

// Those of the material that its shader reads where it draws the primitive, at the units of their slots.
void bindTextures(const FrameInput& in, int material, const scene::Primitive& primitive);

// Instances, lights, joints and weights of morph targets.
void bindScene(const FrameInput& in);

// The measured BRDF's table, or the model that was fitted to it.
void bindMeasured(const FrameInput& in);

// How the environment is seen behind the model (shaders/blurred_background.glsl).
std::vector<shading::Define> backgroundDefines(const FrameInput& in);

// offsetPixels: of the draw within its pixel.
layout::FrameUniforms frameUniforms(const FrameInput& in, int draw, int draws, const glm::dvec2& offsetPixels);

// Draw number `draw` of `draws` into targets.color, offset within the pixel; keeps to the scissor where that is on. The
// visible instances are bound.
Result<FrameStatistics> drawScene(const FrameInput& in, const VisibleDraws& visible, const Targets& targets, int draw,
                                  int draws, const glm::dvec2& offsetPixels, shading::ProgramStore& programs);

}  // namespace facet::frame
