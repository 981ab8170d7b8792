#include "view/history.hpp"

#include <utility>

namespace facet::view {

namespace {

Kept keptOf(const frame::PictureSettings& settings) { return {settings.placement.arrangement, settings.look}; }

bool step(std::vector<Kept>& from, std::vector<Kept>& to, std::optional<Kept>& now, frame::PictureSettings& settings) {
  if (from.empty()) return false;
  to.push_back(keptOf(settings));
  now = std::move(from.back());
  from.pop_back();
  settings.placement.arrangement = now->arrangement;
  settings.look = now->look;
  return true;
}

}  // namespace

void follow(History& history, const std::string& model, const frame::PictureSettings& settings, bool handOnIt) {
  if (history.model != model) history = {model, {}, {}, {}};
  if (handOnIt) return;
  if (history.now && history.now->arrangement == settings.placement.arrangement && history.now->look == settings.look)
    return;
  if (history.now) {
    history.past.push_back(std::move(*history.now));
    if (history.past.size() > keptSteps) history.past.erase(history.past.begin());
    history.future.clear();
  }
  history.now = keptOf(settings);
}

bool undo(History& history, frame::PictureSettings& settings) {
  return step(history.past, history.future, history.now, settings);
}

bool redo(History& history, frame::PictureSettings& settings) {
  return step(history.future, history.past, history.now, settings);
}

}  // namespace facet::view
