#pragma once

// Values in place of a file's: what somebody changes of a model without changing the file.

#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"

namespace facet::scene {

// What is set is named by a JSON pointer: all that KHR_animation_pointer names, and of a material alphaMode (0 opaque,
// 1 mask, 2 blend), doubleSided, and its textures, of which one without values is left out. For an index there may be
// the object's name (all of that name), or * for all; "/lights/" is short for the extension's list; the path may be its
// end, where that is the end of one alone: "/materials/Gold/roughnessFactor".
struct Edit {
  std::string pointer;
  std::vector<double> values;

  bool operator==(const Edit&) const = default;
};
using Edits = std::vector<Edit>;

// "POINTER=VALUE;POINTER=VALUE", values with commas between; true, false, none, opaque, mask and blend by their words.
// Errors: no pointer, no number.
Result<Edits> parseEdits(std::string_view text);
std::string writeEdits(const Edits& edits);

// Of edits that name one object by its index, as an editor writes them.
const Edit* findEdit(const Edits& edits, std::string_view pointer);
void setEdit(Edits& edits, std::string_view pointer, std::vector<double> values);
void removeEdit(Edits& edits, std::string_view pointer);

}  // namespace facet::scene
