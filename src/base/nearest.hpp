#pragma once

#include <span>
#include <string>
#include <string_view>

namespace facet {

// The name that somebody who typed `typed` may have meant, or an empty view. Optimal string alignment distance
// (insertions, deletions, replacements, swapped neighbours: one each), case ignored; at most a third of the longer
// name's length may differ, but a single slip is always forgiven. Of equals the first wins.
std::string_view nearest(std::string_view typed, std::span<const std::string_view> names);

// "perhaps NAME is meant" where there is a nearest name, else "choose one of A, B, C".
std::string suggestion(std::string_view typed, std::span<const std::string_view> names);

}  // namespace facet
