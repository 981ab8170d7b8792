#pragma once

// What the window showed when it was closed, for the next start; what it shows, kept as a session on wish.

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "frame/settings.hpp"

namespace facet::view {

// $XDG_STATE_HOME/facet/last.json, else below ~/.local/state; empty where neither is known.
std::filesystem::path lastFile();

// {"folder": where facet was started, "model": "...", "picture": {"orbit": "30,75,2", ...}}: what a job has, without
// the size; "second": "..." where there is a second model. Errors: cannot be written.
Result<void> writeLast(const std::filesystem::path& file, const std::string& model, const std::string& second,
                       const frame::PictureSettings& settings);

// "start with what was shown last" is chosen in the window.
bool startsWithLast();

}  // namespace facet::view
