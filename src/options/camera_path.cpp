#include "options/camera_path.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/text.hpp"
#include "frame/settings.hpp"
#include "options/camera_text.hpp"

namespace facet::options {

namespace {

using frame::Viewpoint;

// What a key leaves out that another has, or has another of; null: they go together.
const char* difference(const Viewpoint& a, const Viewpoint& b) {
  if (a.orbit->radius.has_value() != b.orbit->radius.has_value()) return "radius in --orbit";
  if (a.target.has_value() != b.target.has_value()) return "--target";
  if (a.fovYDeg.has_value() != b.fovYDeg.has_value()) return "--fov-y";
  if (a.viewHeight.has_value() != b.viewHeight.has_value()) return "--view-height";
  if (a.projection != b.projection) return "--projection";
  return a.up == b.up ? nullptr : "--up";
}

// Through b at 0 and c at 1, with the slopes of their neighbours (Catmull-Rom).
double spline(const std::array<double, 4>& p, double t) {
  const double slope1 = (p[2] - p[0]) / 2, slope2 = (p[3] - p[1]) / 2;
  const double t2 = t * t, t3 = t2 * t;
  return (2 * t3 - 3 * t2 + 1) * p[1] + (t3 - 2 * t2 + t) * slope1 + (3 * t2 - 2 * t3) * p[2] + (t3 - t2) * slope2;
}

// Each at most half a turn from the one before.
void unwrap(std::array<double, 4>& degrees) {
  for (size_t i = 1; i < degrees.size(); ++i)
    degrees[i] = degrees[i - 1] + std::remainder(degrees[i] - degrees[i - 1], 360);
}

}  // namespace

Result<std::vector<Viewpoint>> parseCameraPath(std::string_view text, const std::string& name) {
  std::vector<Viewpoint> keys;
  int number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    const std::string place = "line " + std::to_string(number);
    line = line.substr(0, line.find('#'));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    Result<Viewpoint> key = viewpointOf(line);
    if (!key)
      return fail(name, place, key.error().place + (key.error().place.empty() ? "" : ": ") + key.error().problem,
                  key.error().remedy);
    if (!key->orbit)
      return fail(name, place, "there is no --orbit",
                  "copy a camera in the window, such as --orbit 30,75,2 --target 0,0,0");
    if (!keys.empty())
      if (const char* what = difference(keys.front(), *key))
        return fail(name, place, std::string("differs from the first camera in ") + what,
                    "give it in each line, or in none");
    keys.push_back(std::move(*key));
  }
  if (keys.size() < 2)
    return fail(name, "", "has " + std::to_string(keys.size()) + " cameras", "a way needs two, one a line");
  return keys;
}

Viewpoint alongPath(const std::vector<Viewpoint>& keys, double t) {
  const auto last = static_cast<double>(keys.size() - 1);
  const double at = std::clamp(t, 0.0, 1.0) * last;
  const double from = std::min(std::floor(at), last - 1);
  const auto key = [&](int i) -> const Viewpoint& {
    return keys[static_cast<size_t>(std::clamp(from + i, 0.0, last))];
  };
  const auto mixed = [&](auto read, bool angle = false) {
    std::array<double, 4> p = {read(key(-1)), read(key(0)), read(key(1)), read(key(2))};
    if (angle) unwrap(p);
    return spline(p, at - from);
  };
  const auto grown = [&](auto read) { return std::exp(mixed([&](const Viewpoint& v) { return std::log(read(v)); })); };
  Viewpoint out = key(0);
  out.orbit->thetaDeg = mixed([](const Viewpoint& v) { return v.orbit->thetaDeg; }, true);
  out.orbit->phiDeg = std::clamp(mixed([](const Viewpoint& v) { return v.orbit->phiDeg; }), 0.0, 180.0);
  out.rollDeg = mixed([](const Viewpoint& v) { return v.rollDeg; }, true);
  if (out.orbit->radius) out.orbit->radius = grown([](const Viewpoint& v) { return *v.orbit->radius; });
  if (out.viewHeight) out.viewHeight = grown([](const Viewpoint& v) { return *v.viewHeight; });
  if (out.fovYDeg) out.fovYDeg = std::clamp(mixed([](const Viewpoint& v) { return *v.fovYDeg; }), 1.0, 179.0);
  if (out.target)
    for (int c = 0; c < 3; ++c) (*out.target)[c] = mixed([c](const Viewpoint& v) { return (*v.target)[c]; });
  return out;
}

}  // namespace facet::options
