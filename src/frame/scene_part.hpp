#pragma once

#include <cstdint>

#include "scene/model.hpp"

namespace facet::frame {

// A primitive whose data are read by index.
struct ScenePart {
  const scene::Primitive* primitive = nullptr;
  int material = 0;      // index in DrawList::materials
  uint32_t shading = 0;  // number of what is shaded alike
};

}  // namespace facet::frame
