#include "options/viewpoint_options.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

#include "base/text.hpp"
#include "frame/settings.hpp"
#include "options/arrangement_options.hpp"

namespace facet::options {

namespace {

using frame::PictureSettings;
using Text = std::string_view;

constexpr Text axisWords[] = {"x", "y", "z"};

}  // namespace

Result<void> parseOrbit(Text text, PictureSettings& settings) {
  const std::vector<Text> parts = split(text, ',');
  if (parts.size() != 2 && parts.size() != 3) {
    return fail({}, {}, inQuotes(text) + " is not an orbit", "give THETA,PHI or THETA,PHI,RADIUS such as 25,75,0.4");
  }
  const Result<double> theta = parseNumber(parts[0], -36000, 36000), phi = parseNumber(parts[1], 0, 180);
  if (!theta) return tl::unexpected(theta.error());
  if (!phi) return tl::unexpected(phi.error());
  frame::Orbit orbit{.thetaDeg = *theta, .phiDeg = *phi, .radius = {}};
  if (parts.size() == 3) {
    const Result<double> radius = parseNumber(parts[2], 1e-9, 1e9);
    if (!radius) return tl::unexpected(radius.error());
    orbit.radius = *radius;
  }
  settings.viewpoint.orbit = orbit;
  return {};
}

std::string writeOrbit(const PictureSettings& settings) {
  if (!settings.viewpoint.orbit) return {};
  const std::string angles =
      number(settings.viewpoint.orbit->thetaDeg) + "," + number(settings.viewpoint.orbit->phiDeg);
  return settings.viewpoint.orbit->radius ? angles + "," + number(*settings.viewpoint.orbit->radius) : angles;
}

Result<void> parseTarget(Text text, PictureSettings& settings) {
  return parseVector(text, 1e9, "a point", "in metres such as 0,1.5,0").map([&](const glm::dvec3& target) {
    settings.viewpoint.target = target;
  });
}

std::string writeTarget(const PictureSettings& settings) {
  return settings.viewpoint.target ? writeVector(*settings.viewpoint.target) : std::string();
}

Result<void> parseUp(Text text, PictureSettings& settings) {
  const double sign = text.starts_with('-') ? -1 : 1;
  const auto axis = std::ranges::find(axisWords, text.substr(sign < 0 ? 1 : 0));
  if (axis != std::end(axisWords)) {
    settings.viewpoint.up = glm::dvec3(0);
    settings.viewpoint.up[static_cast<int>(axis - axisWords)] = sign;
    return {};
  }
  constexpr const char* remedy = "give x, y, z or X,Y,Z such as 0,0,-1";
  const Result<glm::dvec3> up = parseVector(text, 1e9, "a direction", "such as 0,0,-1; or x, y, z");
  if (!up) return tl::unexpected(up.error());
  if (!(glm::length(*up) > 1e-9)) return fail({}, {}, inQuotes(text) + " is no direction", remedy);
  settings.viewpoint.up = *up;
  return {};
}

std::string writeUp(const PictureSettings& settings) {
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 axis(0);
    axis[i] = 1;
    if (settings.viewpoint.up == axis) return std::string(axisWords[i]);
  }
  return writeVector(settings.viewpoint.up);
}

Result<void> parseViewHeight(Text text, PictureSettings& settings) {
  return parseNumber(text, 1e-9, 1e9).map([&](double height) { settings.viewpoint.viewHeight = height; });
}

}  // namespace facet::options
