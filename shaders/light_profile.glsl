// Candela of lights that have a profile (EXT_lights_ies). The twin is src/optics/light_profile.cpp.
#include "arc_tangent.glsl"
#include "layout.h"

// One profile after the other (src/frame/light_profiles.hpp): numbers of polar angles and of azimuths, photometry, then
// both kinds of angles [degrees], then candela by azimuth and polar angle.
layout(std430, binding = profileBinding) readonly buffer ProfileBlock { float profiles[]; };

struct ProfilePlace {
  int at;       // between the angle number `at` and the next
  float share;  // of the next
};

// x within the count angles from `first` on, which rise strictly; at < 0: it is not.
ProfilePlace profilePlace(int first, int count, float x) {
  if (!(x >= profiles[first] && x <= profiles[first + count - 1])) return ProfilePlace(-1, 0.0);
  int low = 0, high = count - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    if (profiles[first + middle] <= x) low = middle;
    else high = middle;
  }
  float a = profiles[first + low], b = profiles[first + high];
  return ProfilePlace(low, (x - a) / (b - a));
}

// a where both are alike, to the last bit.
float profileMix(float a, float b, float share) { return a + share * (b - a); }

float profileRow(int row, ProfilePlace polar) {
  return profileMix(profiles[row + polar.at], profiles[row + polar.at + 1], polar.share);
}

// d: unit, the way from the light; 1 where it has no profile.
float profileCandela(LightUniforms light, vec3 d) {
  if (light.profile.w == 0.0) return 1.0;
  int first = int(abs(light.profile.w)) - 1;
  int polars = int(profiles[first]), azimuths = int(profiles[first + 1]), photometry = int(profiles[first + 2]);
  vec3 aim = light.direction.xyz, x = light.profile.xyz, y = cross(x, aim) * (light.profile.w < 0.0 ? -1.0 : 1.0);
  vec3 lamp = vec3(dot(d, x), dot(d, y), dot(d, aim));
  vec3 p = photometry == 1 ? vec3(lamp.z, -lamp.y, lamp.x) : photometry == 2 ? vec3(lamp.z, lamp.x, -lamp.y) : lamp;
  int polarAt = first + 3, azimuthAt = polarAt + polars, candelaAt = azimuthAt + azimuths;
  ProfilePlace polar = profilePlace(polarAt, polars, min(degrees(arcTangent(length(p.xy), p.z)), 180.0));
  if (polar.at < 0) return 0.0;
  if (azimuths == 1) return profileRow(candelaAt, polar);
  float azimuth = degrees(arcTangent(p.y, p.x));
  float begin = profiles[azimuthAt], end = profiles[azimuthAt + azimuths - 1];
  if (end - begin >= 360.0) azimuth = min(azimuth - 360.0 * floor((azimuth - begin) / 360.0), end);
  ProfilePlace side = profilePlace(azimuthAt, azimuths, azimuth);
  if (side.at < 0) return 0.0;
  int row = candelaAt + side.at * polars;
  return profileMix(profileRow(row, polar), profileRow(row + polars, polar), side.share);
}
