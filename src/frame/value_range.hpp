#pragma once

// What the colours of a channel's quantities stand for.

#include <optional>
#include <string>

#include "frame/draw_list.hpp"
#include "frame/settings_fwd.hpp"
#include "scene/camera.hpp"

namespace facet::frame {

struct ValueRange {
  double from = 0, to = 1;  // from < to
  bool logarithmic = false;

  bool operator==(const ValueRange&) const = default;
};

// Of the list's channel, which shows quantities, where no range is asked for: what the scene has of it, as seen by the
// view, or what there usually is.
ValueRange usualRange(const DrawList& list, const scene::View& view);

// In the tone mapper's place.
bool showsLightInFalseColors(const Display& display, int channel);

// As one reads it: where each end of the colours lies.
struct RangeShown {
  std::string label, unit;  // of the channel; the unit may be empty
  ValueRange range;
};
// Nothing where the list's channel shows neither quantities nor light in false colours. display.range: its ends, which
// count where they are above 0 if the range is logarithmic.
std::optional<RangeShown> rangeShown(const DrawList& list, const scene::View& view, const Display& display);
// "depth from 1.2 to 3.4 m"
std::string describe(const RangeShown& shown);

}  // namespace facet::frame
