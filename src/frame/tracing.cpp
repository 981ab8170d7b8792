// What is done about what stands in the way of a draw list's light, and why not.

#include <algorithm>

#include "frame/draw_list.hpp"
#include "frame/shadow_maps.hpp"
#include "scene/convex.hpp"
#include "scene/geometry.hpp"

namespace facet::frame {

bool SizeRange::holds(const scene::Bounds& bounds) const {
  const double radius = bounds.radius();
  return radius == 0 || (radius >= least && radius <= most);
}

namespace {

bool anyUses(const DrawList& list, shading::Feature feature) {
  return std::ranges::any_of(list.classes(), [&](const std::vector<Draw>* draws) {
    return std::ranges::any_of(*draws, [&](const Draw& draw) { return shading::usesFeature(draw.key, feature); });
  });
}

// A single convex body that lets no light pass: what faces the light gets it, nothing gets it from the body.
bool nothingInTheWay(const DrawList& list) {
  if (!list.transmitting.empty() || !list.blended.empty() || list.opaque.size() != 1) return false;
  const Draw& draw = list.opaque.front();
  return draw.instanceCount == 1 && !draw.doubleSided && !shading::usesFeature(draw.key, shading::Feature::skin) &&
         !shading::usesFeature(draw.key, shading::Feature::morphTargets) &&
         !shading::usesFeature(draw.key, shading::Feature::diffuseTransmission) && scene::isConvex(*draw.primitive);
}

// Lines or points.
bool drawsThin(const DrawList& list) {
  const auto thin = [](const Draw& draw) { return !scene::hasTriangles(draw.primitive->topology); };
  return std::ranges::any_of(list.classes(), [&](const auto* draws) { return std::ranges::any_of(*draws, thin); });
}

// Why the list is left as it is, before its materials are looked at; else empty.
std::string whyUntraced(const DrawList& list, const DrawOptions& options) {
  if (!shading::showsLight(list.features.channel)) return "a channel shows no light";
  if (!tracedSizes.holds(list.bounds)) return "rays do not reach in a scene of this size";
  if (options.tracesAnyway) return "";
  if (nothingInTheWay(list)) return "a convex body, alone";
  if (options.tracing == Tracing::paths && drawsThin(list)) return "paths do not meet lines and points";
  // Without tables there is nothing that rays could correct without noise of their own.
  if (options.tracing == Tracing::difference && list.features.measured != shading::Measured::none)
    return "few samples of a measured BRDF are noise enough";
  return "";
}

// Shadow maps and horizons, of which each draw takes what it can show.
void setScreen(DrawList& list) {
  shading::FrameFeatures features = list.features;
  features.shadows = features.horizons = true;
  setFeatures(list, features);
  // What no draw reads changes none of them, and is not made.
  list.features.shadows = anyUses(list, shading::Feature::shadows);
  list.features.horizons = anyUses(list, shading::Feature::horizons);
  if (list.features.shadows) assignShadowMaps(list);
  if (!list.features.shadows && !list.features.horizons) list.untraced = "nothing is lit";
}

}  // namespace

void setTracing(DrawList& list, const DrawOptions& options) {
  list.untraced.clear();
  if (list.features.shadows || list.features.horizons) {
    shading::FrameFeatures without = list.features;
    without.shadows = without.horizons = false;
    setFeatures(list, without);
  }
  if (options.tracing == Tracing::none) return;
  list.untraced = whyUntraced(list, options);
  if (!list.untraced.empty()) return;
  if (options.tracing == Tracing::screen) return setScreen(list);
  const shading::FrameFeatures drawn = list.features;
  shading::FrameFeatures traced = shading::pathFeatures(drawn);
  setFeatures(list, traced);
  if (!anyUses(list, shading::Feature::paths)) {
    list.untraced = "nothing is lit";
    return setFeatures(list, drawn);
  }
  if (options.tracing == Tracing::paths) return;
  traced.paths = false, traced.difference = true;  // what is wrong with the tables is less than what few samples miss
  setFeatures(list, traced);
}

}  // namespace facet::frame
