#pragma once

// Two pictures in one, a measured BRDF and the model fitted to it a fast picture and the traced one, or two
// models: how both are shown, and how they differ.

#include <chrono>
#include <optional>
#include <vector>

#include "frame/display_pass.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct Viewport;

struct Comparison {
  // That the display picture was made with: a change asks for no new picture, only for showing it anew.
  std::optional<frame::BrdfComparison> shown;
  std::vector<frame::ComparisonSums> sums;        // of the picture on the screen, on their way
  std::chrono::steady_clock::time_point since{};  // when they were asked for
};

// The two that are shown beside each other, where there are two.
std::optional<frame::ShownPair> pairShown(const Viewport& viewport);

// The picture of the targets, times the scale, onto the screen; of two that are compared their figures, too, at most
// twice a second unless it is the last one.
Result<void> showPicture(Viewport& viewport, const frame::FrameInput& in, const frame::Targets& targets, float scale,
                         bool last);

// Starts to find out how they differ, as showPicture does it.
Result<void> compare(Viewport& viewport, const frame::FrameInput& in, const frame::Targets& targets, float scale,
                     bool last);

// Shows the pictures that are there as the settings have it now. False where that has to wait for a draw's end.
Result<bool> showAnew(Viewport& viewport, const frame::PictureSettings& settings, const scene::View& view);

}  // namespace facet::view
