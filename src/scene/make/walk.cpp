#include "scene/make/walk.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace facet::scene {

double bodyZ(const Gait& gait, double time) { return gait.stride * time / gait.period; }

double hipHeight(const Gait& gait, double time) {
  // Lowest where both feet are down.
  return gait.hip - gait.bob * std::cos(4 * pi * (time / gait.period - gait.stance / 2 + 0.25));
}

AnklePlace anklePlace(const Gait& gait, double time, double phase) {
  const double cycle = time / gait.period + phase, whole = std::floor(cycle), at = cycle - whole;
  // Where it is set down for that cycle: so far ahead of the body that it passes below in the middle of the stance.
  const auto placeOf = [&](double k) { return gait.stride * (k - phase + gait.stance / 2); };
  if (at <= gait.stance) return {placeOf(whole), gait.ankle, true};
  const double swing = (at - gait.stance) / (1 - gait.stance);
  const double ahead = swing * swing * swing * (swing * (6 * swing - 15) + 10);  // at rest at both ends
  const double up = std::sin(pi * swing);
  return {glm::mix(placeOf(whole), placeOf(whole + 1), ahead), gait.ankle + gait.lift * up * up, false};
}

LegAngles legAngles(const Gait& gait, double time, double phase) {
  const AnklePlace ankle = anklePlace(gait, time, phase);
  const double z = ankle.z - bodyZ(gait, time), down = hipHeight(gait, time) - ankle.y;
  const double reach = gait.thigh + gait.shin;
  const double distance = std::clamp(std::hypot(z, down), std::abs(gait.thigh - gait.shin) + 1e-6, reach - 1e-6);
  const double cosine =
      (gait.thigh * gait.thigh + distance * distance - gait.shin * gait.shin) / (2 * gait.thigh * distance);
  const double thigh = std::atan2(z, down) + std::acos(std::clamp(cosine, -1.0, 1.0));
  const double kneeZ = gait.thigh * std::sin(thigh), kneeDown = gait.thigh * std::cos(thigh);
  return {thigh, std::atan2(z - kneeZ, down - kneeDown)};
}

}  // namespace facet::scene
