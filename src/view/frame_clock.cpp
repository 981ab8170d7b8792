#include "view/frame_clock.hpp"

#include <algorithm>

namespace facet::view {

FrameClock::Slot* FrameClock::begin() {
  for (Slot& slot : slots) {
    if (slot.pending) continue;
    if (!slot.timer) slot.timer = gl::Timer::create();
    slot.timer.begin();
    slot.pending = true;
    return &slot;
  }
  return nullptr;
}

void FrameClock::end(Slot* slot) const {
  if (slot) slot->timer.end();
}

bool FrameClock::waiting() const {
  return std::ranges::any_of(slots, [](const Slot& slot) { return slot.pending; });
}

std::optional<double> FrameClock::poll() {
  for (Slot& slot : slots) {
    if (!slot.pending || !slot.timer.ready()) continue;
    slot.pending = false;
    return slot.timer.milliseconds();
  }
  return std::nullopt;
}

}  // namespace facet::view
