#pragma once

// What is seen through transmitting surfaces: a copy of the frame so far, with levels that are ever more blurred.

#include "frame/frame.hpp"

namespace facet::frame {

// What copyBehind needs. Its program for the first level is compiled where it is first used.
Result<const gl::Program*> behindProgram(shading::ProgramStore& programs);

// targets.drawn, several samples a pixel averaged, into targets.behind, all levels; binds it for the draws to come.
Result<void> copyBehind(const Targets& targets, shading::ProgramStore& programs);

}  // namespace facet::frame
