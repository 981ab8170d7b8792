#include "frame/value_range.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "frame/settings.hpp"

namespace facet::frame {

namespace {

using shading::Channel;

// Distances of the scene's box along the view's axis.
ValueRange depthRange(const scene::Bounds& bounds, const scene::View& view) {
  if (bounds.empty()) return {};
  ValueRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int corner = 0; corner < 8; ++corner) {
    glm::dvec3 at = bounds.min;
    for (int axis = 0; axis < 3; ++axis)
      if (corner >> axis & 1) at[axis] = bounds.max[axis];
    const double distance = glm::dot(at - view.eye, view.forward);
    range.from = std::min(range.from, distance), range.to = std::max(range.to, distance);
  }
  if (!view.orthographic) range.from = std::max(range.from, 0.0);
  return range;
}

// From 0 to the largest of the materials that are drawn.
ValueRange upTo(const DrawList& list, float scene::Material::*member) {
  double largest = 0;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws) {
      const double value = static_cast<double>(list.materials[static_cast<size_t>(draw.material)].*member);
      if (std::isfinite(value)) largest = std::max(largest, value);
    }
  return {0, largest};
}

// Ten octaves around a texture of 1024 texels over the scene.
ValueRange densities(const scene::Bounds& bounds) {
  const double radius = bounds.empty() || bounds.radius() <= 0 ? 1 : bounds.radius();
  const double from = std::exp2(std::floor(std::log2(16 / radius)));
  return {from, 1024 * from, true};
}

const char* unitOf(int channel) {
  switch (static_cast<Channel>(channel)) {
    case Channel::depth:
    case Channel::thickness:
    case Channel::attenuationDistance:
      return "m";
    case Channel::iridescenceThickness:
      return "nm";
    case Channel::texelDensity:
      return "texels/m";
    default:
      return "";
  }
}

// Sixteen stops around what a screen shows as white: at 2^-exposure.
ValueRange lightRange(const Display& display) {
  const auto stops = static_cast<double>(display.exposureStops);
  return {std::exp2(-10 - stops), std::exp2(6 - stops), true};
}

}  // namespace

ValueRange usualRange(const DrawList& list, const scene::View& view) {
  const auto spread = [](ValueRange range) {
    if (!(range.to > range.from)) range.to = range.from + 1;
    return range;
  };
  switch (static_cast<Channel>(list.features.channel)) {
    case Channel::depth:
      return spread(depthRange(list.bounds, view));
    case Channel::thickness:
      return spread(upTo(list, &scene::Material::thicknessFactor));
    case Channel::attenuationDistance:
      return spread(upTo(list, &scene::Material::attenuationDistance));
    case Channel::dispersion:
      return spread(upTo(list, &scene::Material::dispersion));
    case Channel::iridescenceThickness:
      return {0, 1000};
    case Channel::ior:
    case Channel::iridescenceIor:
      return {1, 3};
    case Channel::handedness:
      return {-1, 1};
    case Channel::texelDensity:
      return densities(list.bounds);
    case Channel::mipLevel:
      return {-2, 10};
    case Channel::overdraw:
      return {0, 8};
    default:
      return {};
  }
}

bool showsLightInFalseColors(const Display& display, int channel) {
  return display.falseColors && shading::showsLight(channel);
}

std::optional<RangeShown> rangeShown(const DrawList& list, const scene::View& view, const Display& display) {
  const int channel = list.features.channel;
  const std::optional<glm::dvec2>& wish = display.range;
  RangeShown shown{
      channel == 0 ? "radiance" : std::string(rowOf(shading::channels, channel).label), unitOf(channel), {}};
  if (showsLightInFalseColors(display, channel))
    shown.range = lightRange(display);
  else if (shading::channelKind(channel) == shading::ChannelKind::quantity)
    shown.range = usualRange(list, view);
  else
    return std::nullopt;
  if (wish && (!shown.range.logarithmic || wish->x > 0)) shown.range.from = wish->x, shown.range.to = wish->y;
  return shown;
}

std::string describe(const RangeShown& shown) {
  char text[96];
  std::snprintf(text, sizeof text, " from %.4g to %.4g%s%s%s", shown.range.from, shown.range.to,
                shown.unit.empty() ? "" : " ", shown.unit.c_str(), shown.range.logarithmic ? ", logarithmic" : "");
  return shown.label + text;
}

}  // namespace facet::frame
