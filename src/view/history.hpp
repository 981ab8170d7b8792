#pragma once

// Undo and redo of what is changed of the model and its look. Pure.

#include <optional>
#include <string>
#include <vector>

#include "frame/settings.hpp"

namespace facet::view {

struct Kept {
  frame::Arrangement arrangement;
  frame::Look look;

  bool operator==(const Kept&) const = default;
};

struct History {
  std::string model;  // that it is of
  std::vector<Kept> past, future;
  std::optional<Kept> now;
};

inline constexpr size_t keptSteps = 200;

// Once a turn: a change becomes a step as soon as no hand is on it. Another model begins anew.
void follow(History& history, const std::string& model, const frame::PictureSettings& settings, bool handOnIt);
// False where there is nothing to go back to.
bool undo(History& history, frame::PictureSettings& settings);
bool redo(History& history, frame::PictureSettings& settings);

}  // namespace facet::view
