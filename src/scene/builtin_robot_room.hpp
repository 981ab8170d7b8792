#pragma once

// Where builtin:robot walks: a room of brick and tread plate, its corridor, lamps along them.

#include <glm/glm.hpp>
#include <vector>

#include "scene/glb_writer.hpp"

namespace facet::scene {

struct RoomLamp {
  double z;             // where it hangs along the way
  int light, material;  // of the file: what is to come on
  double candela;
  glm::dvec3 color;  // linear
};
// steel, dark: materials of the robot's that pipes and lamps have, too. In the order of the way.
std::vector<RoomLamp> addRobotRoom(GlbWriter& writer, int steel, int dark);

}  // namespace facet::scene
