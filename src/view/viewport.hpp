#pragma once

// The OpenGL side of the viewer: the scene on the GPU, environments with their tables, targets, timers.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/pass_clock.hpp"
#include "frame/picture.hpp"
#include "gl/context.hpp"
#include "view/comparison.hpp"
#include "view/environments.hpp"
#include "view/error_view.hpp"
#include "view/frame_clock.hpp"
#include "view/loader.hpp"
#include "view/measured.hpp"
#include "view/moving.hpp"
#include "view/outline.hpp"
#include "view/overlay_view.hpp"
#include "view/refinement.hpp"
#include "view/second_model.hpp"
#include "view/trees.hpp"
#include "view/truth_view.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct SceneSlot : frame::LoadedScene {
  bool again = false;  // takes the place of what was read from the same file before
  FileWatch watch;     // of its files, as they were before it was read
};

// What the last frame was drawn from; while it is unchanged, the frame is still good.
struct DrawnFrame {
  int list = 0;  // Viewport::listNumber: what is loaded and what lists are made of
  scene::OrbitCamera camera;
  frame::Viewpoint viewpoint;
  frame::FrameSettings frame;
  frame::Display display;
  frame::Quality quality;

  bool operator==(const DrawnFrame&) const = default;
};

struct Viewport {
  Viewport(gl::ContextInfo contextInfo, shading::ProgramStore store)
      : context(std::move(contextInfo)), programs(std::move(store)) {}

  gl::ContextInfo context;
  shading::ProgramStore programs;
  ibl::TableCache tableCache;        // the default: none
  std::unique_ptr<SceneSlot> scene;  // shown
  std::unique_ptr<SceneSlot> next;   // read, waits for what it needs
  Environments environments;
  frame::Drawable shown;                // of `scene`
  frame::Plan plan = {.moving = true};  // of what comes next
  std::string loadingEnvironment;
  MeasuredView measured;
  Comparison comparison;
  int listNumber = 0;  // of shown
  frame::Targets targets;
  std::optional<DrawnFrame> drawn;
  FrameClock clock;
  frame::PassClock passClock;
  bool passesDone = false;  // a whole frame's, which the GPU may not have come to
  Moving moving;
  Refinement refinement;
  Trees trees;
  Outline outline;
  OverlayView overlay;
  ErrorView errorView;
  TruthView truthView;
  SecondModel second;
  // Of what comes up, so much goes on the GPU in one turn: the window answers in between.
  std::chrono::milliseconds slice{20};
  bool comingUp = false;       // there is more of it
  bool sketch = false;         // the next frame is the model's first
  bool shadersBroken = false;  // as they are in the file now; the last good frame stays
};

// After a change of the shaders' files: compiles anew what is drawn. Where that fails, the last good frame stays.
void reloadShaders(Viewport& viewport, ViewerState& state);

// The view of what is shown now; nothing where nothing is shown yet or the file has no such camera (which is told).
std::optional<scene::View> currentView(const Viewport& viewport, ViewerState& state);

// Draws into the targets where anything has changed since the last time, else refines what is there. True where the
// display picture is new.
bool drawViewport(Viewport& viewport, ViewerState& state);

// There is more to come without anybody's doing: drawViewport() is to be called again soon.
bool atWork(const Viewport& viewport, const ViewerState& state);

}  // namespace facet::view
