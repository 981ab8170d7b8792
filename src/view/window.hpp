#pragma once

// The viewer: a window on a model.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/settings.hpp"

namespace facet::view {

struct WindowOptions {
  std::string model = "builtin:poster";  // a path or "builtin:NAME"
  std::string secondModel = {};          // beside it; empty: none
  frame::PictureSettings settings;       // the size is the window's
  bool modelNamed = false;               // else the only model of the only folder takes its place
  std::vector<std::string> folders;      // to be browsed
  bool sizeGiven = false;                // else the window gets the size that it had last
  bool diskCache = true;                 // program binaries, tables
  bool glDebug = false;                  // KHR_debug
  std::function<void()> atWork = {};     // called once the driver is at work, before a model is read
};
// Folders that the window writes to: preferences, layout, what was opened last, screenshots.
std::vector<std::filesystem::path> writtenFolders();

// What can be told without reading anything, so that it is told without a window: the model, the environment or the
// measured BRDF does not exist.
Result<void> checkStart(const WindowOptions& options);

// Runs until the window is closed. What the options name is read while it is open. False: nothing was ever shown,
// because no model could be. Errors: no display, no usable OpenGL.
Result<bool> runWindow(const WindowOptions& options);

}  // namespace facet::view
