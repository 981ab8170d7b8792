#pragma once

// Changes to JSON that stay JSON: what random bytes hardly ever do.

#include <random>

#include "fuzz/targets.hpp"

namespace facet::fuzz {

// One to four changes of a JSON text, or of that in a .glb, whose binary chunk stays: extreme numbers, values of other
// types, members taken away, doubled, moved, given twice, exchanged; indices that make cycles; extension objects. Bytes
// that are no JSON come back as they are.
Bytes mutateJson(std::span<const uint8_t> bytes, std::mt19937& random);

}  // namespace facet::fuzz
