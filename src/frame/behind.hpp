#pragma once

// What is seen through transmitting surfaces: a copy of the frame so far, with levels that are ever more blurred.

#include "frame/frame.hpp"

namespace facet::frame {

// Compiles what copyBehind needs. Its program for several samples a pixel is compiled where it is first used.
Result<void> prepareBehindPrograms(shading::ProgramStore& programs);

// targets.drawn, several samples a pixel averaged, into targets.behind, all levels; binds it for the draws to come.
Result<void> copyBehind(const Targets& targets, shading::ProgramStore& programs);

}  // namespace facet::frame
