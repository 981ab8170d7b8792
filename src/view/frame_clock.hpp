#pragma once

#include <array>
#include <optional>

#include "gl/timer.hpp"

namespace facet::view {

// GPU time of frames, read when it is there; a frame that finds no free timer is not measured.
struct FrameClock {
  struct Slot {
    gl::Timer timer;
    bool pending = false;
  };
  std::array<Slot, 3> slots;

  Slot* begin();
  void end(Slot* slot) const;
  bool waiting() const;
  std::optional<double> poll();  // milliseconds of a frame that has ended
};

}  // namespace facet::view
