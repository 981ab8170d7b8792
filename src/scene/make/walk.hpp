#pragma once

// A walk on two legs whose feet stay where they are set down: legs of two bones, solved in the plane of the walk.

#include <glm/glm.hpp>

namespace facet::scene {

// Metres and seconds. Along +Z; the left leg begins.
struct Gait {
  double period = 1.2;                             // of two steps
  double stride = 0.9;                             // that the body goes in it
  double stance = 0.62;                            // share of the period that a foot is down
  double lift = 0.11;                              // of the ankle in the middle of a swing
  double thigh = 0.42, shin = 0.42, ankle = 0.10;  // lengths; height of the ankle above the sole
  double hip = 0.86;                               // its mean height
  double bob = 0.012;                              // that it rises and falls by, twice a period
};

// Of the body's origin, below the hips on the ground.
double bodyZ(const Gait& gait, double time);
double hipHeight(const Gait& gait, double time);

// Of the ankle in the world; phase: 0 the left leg's, 0.5 the right one's.
struct AnklePlace {
  double z, y;
  bool down;
};
AnklePlace anklePlace(const Gait& gait, double time, double phase);

// Angles in the plane of the walk from straight down towards +Z [rad], of thigh and shin each; the knee points
// forwards. What is too far is reached for.
struct LegAngles {
  double thigh, shin;
};
LegAngles legAngles(const Gait& gait, double time, double phase);

}  // namespace facet::scene
