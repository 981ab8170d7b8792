#pragma once

// The viewer: a window on a model.

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/settings.hpp"
#include "view/loader.hpp"

namespace facet::view {

struct WindowOptions {
  std::string model = "builtin:poster";  // a path or "builtin:NAME"
  frame::PictureSettings settings;       // the size is the window's
  std::vector<std::string> folders;      // to be browsed
  bool sizeGiven = false;                // else the window gets the size that it had last
  bool diskCache = true;                 // program binaries, tables
  bool glDebug = false;                  // KHR_debug
};

// What is read before there is a window, so that what was typed wrong is told without one.
struct Start {
  ModelLoaded model;
  EnvironmentLoaded environment;
  std::optional<MeasuredLoaded> measured;
};
// Errors: model, environment or measured BRDF cannot be read, or the model has no such scene or camera.
Result<Start> prepareStart(const WindowOptions& options);

// Runs until the window is closed. Errors: no display, no usable OpenGL.
Result<void> runWindow(const WindowOptions& options, Start start);

}  // namespace facet::view
