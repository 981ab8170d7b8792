#pragma once

// Blended surfaces in the order of each pixel, whatever the order of their draws: what covers it is kept in a list
// (Yang et al. 2010, "Real-Time Concurrent Linked List Construction on the GPU"), which is put in order afterwards.

#include <span>

#include "frame/frame.hpp"

namespace facet::frame {

// What it needs (ARB_post_depth_coverage) is there. Of the current context.
bool listsAvailable();

// Makes or frees targets.lists.
void prepareBlendLists(Targets& targets, const DrawList& list, const PictureSettings& settings);

std::vector<ProgramGetter> neededListPrograms(const FrameInput& in, shading::ProgramStore& programs);

// Draws into targets.drawn, over what is there; the depth buffer stays. False where the lists would take more than the
// driver's buffers hold: nothing is drawn then. Waits for the GPU, to know whether there was room.
Result<bool> drawListed(const FrameInput& in, std::span<const Draw> draws, const Targets& targets,
                        shading::ProgramStore& programs, FrameStatistics& statistics);

}  // namespace facet::frame
