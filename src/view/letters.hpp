#pragma once

// Letters of names that the usual fonts lack, for which others are looked for: few of the ten thousands there are.

#include <cstdint>
#include <set>
#include <string_view>

#include "scene/model.hpp"

namespace facet::view {

using Letters = std::set<uint16_t>;  // code points of the basic plane, which ImGui's fonts hold

// Those of a UTF-8 text that the ranges of applyStyle do not have.
void addLetters(std::string_view text, Letters& letters);

// Those of all that has a name.
void addLetters(const scene::Model& model, Letters& letters);

}  // namespace facet::view
