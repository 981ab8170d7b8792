#pragma once

// From what the loader has read to what is shown: what is new comes up on the GPU beside what is shown and takes its
// place when it is complete.

#include "view/loader.hpp"
#include "view/viewport.hpp"

namespace facet::view {

// These tell state.status what failed; what is shown then stays.
void takeModel(Viewport& viewport, ViewerState& state, ModelLoaded loaded);
void takeEnvironment(Viewport& viewport, ViewerState& state, EnvironmentLoaded loaded);
void takeMeasured(Viewport& viewport, ViewerState& state, MeasuredLoaded loaded);
void takeFit(Viewport& viewport, ViewerState& state, FitMade made);
void takeImages(Viewport& viewport, ViewerState& state, ImagesDecoded decoded);
// Into what waits for them.
void keepImages(frame::LoadedScene& scene, ImagesDecoded decoded);

// The plan's next steps, as many as a turn has time for. True: it is complete; Viewport::comingUp: there is more to do.
Result<bool> advanceSlice(Viewport& viewport, frame::Plan& plan, frame::LoadedScene& scene,
                          const frame::PictureSettings& wish, const frame::Drawable* shown,
                          const frame::Supply& supply);
// Asks the loader for what the state wants and is not there yet, and shows it as soon as everything is there. True
// where the draw list is new.
bool bringUp(Viewport& viewport, ViewerState& state, Loader& loader);

// Nothing of what is being read will be shown.
void cancelLoading(Viewport& viewport, ViewerState& state, Loader& loader);

}  // namespace facet::view
