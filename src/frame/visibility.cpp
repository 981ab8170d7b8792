#include "frame/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <tuple>

namespace facet::frame {

namespace {

// Inside where dot(plane, (p, 1)) >= 0; clip coordinates' planes by rows of the matrix (Gribb and Hartmann 2001).
// Depth is reversed: 1 at the near plane, 0 far away.
std::array<glm::dvec4, 6> frustumPlanes(const glm::dmat4& clipFromWorld, const ClipRows& part, double margin) {
  const glm::dmat4 m = glm::transpose(clipFromWorld);
  return {m[0] + m[3] * (1 + margin),
          m[3] * (1 + margin) - m[0],
          m[1] - m[3] * (part.low - margin),
          m[3] * (part.high + margin) - m[1],
          m[2],
          m[3] - m[2]};
}

bool outside(const scene::Bounds& box, const std::array<glm::dvec4, 6>& planes) {
  const glm::dvec3 center = box.center(), half = box.max * 0.5 - box.min * 0.5;
  return std::ranges::any_of(planes, [&](const glm::dvec4& plane) {
    const glm::dvec3 normal(plane);
    return glm::dot(normal, center) + plane.w + glm::dot(glm::abs(normal), half) < 0;  // false for NaN
  });
}

// Larger is farther away. Of the box's centre: as good as any for the order.
double depth(const scene::Bounds& box, const scene::View& view) {
  const glm::dvec3 toCenter = (box.empty() ? view.eye : box.center()) - view.eye;
  return view.orthographic ? glm::dot(toCenter, view.forward) : glm::length(toCenter);
}

// Of the box's nearest point, in the measure of depth().
double nearestDepth(const scene::Bounds& box, const scene::View& view) {
  if (box.empty()) return 0;
  if (!view.orthographic) return glm::length(glm::clamp(view.eye, box.min, box.max) - view.eye);
  const glm::dvec3 half = box.max * 0.5 - box.min * 0.5;
  return glm::dot(box.center() - view.eye, view.forward) - glm::dot(half, glm::abs(view.forward));
}

struct Seen {
  double depth;
  uint32_t instance;
};

// The draw's instances within the picture, nearest first.
std::vector<Seen> seenInstances(const DrawList& list, const Draw& draw, const scene::View& view,
                                const std::array<glm::dvec4, 6>& planes) {
  std::vector<Seen> seen;
  seen.reserve(draw.instanceCount);
  for (uint32_t i = 0; i < draw.instanceCount; ++i) {
    const scene::Bounds& box = list.instanceBounds[draw.firstBounds + i];
    if (!box.empty() && outside(box, planes)) continue;
    seen.push_back({depth(box, view), draw.firstInstance + i});
  }
  std::ranges::stable_sort(seen, {}, &Seen::depth);
  return seen;
}

struct Sorted {
  Draw draw;
  double depth;
  double nearest;    // point of the boxes, in the measure of depth()
  double group = 0;  // of opaque draws: least hidingDepth of those of the same program and material
};

std::vector<Sorted> see(const DrawList& list, const std::vector<Draw>& draws, const scene::View& view,
                        const std::array<glm::dvec4, 6>& planes, VisibleDraws& visible) {
  std::vector<Sorted> sorted;
  for (const Draw& draw : draws) {
    const std::vector<Seen> seen = seenInstances(list, draw, view, planes);
    visible.culled += draw.instanceCount - seen.size();
    if (seen.empty()) continue;
    sorted.push_back({draw, seen.front().depth, std::numeric_limits<double>::infinity()});
    double& nearest = sorted.back().nearest;
    for (const Seen& s : seen)
      nearest = std::min(nearest,
                         nearestDepth(list.instanceBounds[draw.firstBounds + (s.instance - draw.firstInstance)], view));
    sorted.back().draw.firstInstance = static_cast<uint32_t>(visible.instances.size());
    sorted.back().draw.instanceCount = static_cast<uint32_t>(seen.size());
    for (const Seen& s : seen) visible.instances.push_back(s.instance);
  }
  return sorted;
}

// Before what lies behind it: by the nearest point, but for boxes around the eye, which say nothing by it.
double hidingDepth(const Sorted& s) {
  const double by = s.nearest > 0 ? s.nearest : s.depth;
  return std::isfinite(by) ? by : std::numeric_limits<double>::infinity();
}

// By program, then front to back by material, so that what hides others comes first and materials change no more often
// than there are some. nearestOfAll: lowered to the nearest point of all boxes, where asked for.
std::vector<Draw> seeOpaque(const DrawList& list, const std::vector<Draw>& draws, const scene::View& view,
                            const std::array<glm::dvec4, 6>& planes, VisibleDraws& visible,
                            double* nearestOfAll = nullptr) {
  std::vector<Sorted> sorted = see(list, draws, view, planes, visible);
  std::map<std::tuple<shading::VariantKey, int>, double> first;  // of each material's draws
  for (const Sorted& s : sorted) {
    const auto [known, added] = first.try_emplace({s.draw.key, s.draw.material}, hidingDepth(s));
    if (!added) known->second = std::min(known->second, hidingDepth(s));
  }
  for (Sorted& s : sorted) s.group = first.at({s.draw.key, s.draw.material});
  std::ranges::stable_sort(
      sorted, {}, [](const Sorted& s) { return std::tuple(s.draw.key, s.group, s.draw.material, hidingDepth(s)); });
  std::vector<Draw> out;
  for (const Sorted& s : sorted) {
    out.push_back(s.draw);
    if (nearestOfAll) *nearestOfAll = std::min(*nearestOfAll, s.nearest);
  }
  return out;
}

}  // namespace

VisibleDraws visibleDraws(const DrawList& list, const scene::View& view, const ClipRows& rows, double margin) {
  VisibleDraws visible;
  const std::array<glm::dvec4, 6> planes = frustumPlanes(view.clipFromWorld, rows, margin);
  visible.opaque = seeOpaque(list, list.opaque, view, planes, visible);
  double nearest = std::numeric_limits<double>::infinity();  // of what transmits
  visible.transmitting = seeOpaque(list, list.transmitting, view, planes, visible, &nearest);
  std::vector<Sorted> blended = see(list, list.blended, view, planes, visible);
  std::ranges::stable_sort(blended, std::greater<>(), &Sorted::depth);
  for (const Sorted& s : blended) {
    visible.blendedBehind += s.depth >= nearest ? 1 : 0;  // farthest first: they are the first ones
    visible.blended.push_back(s.draw);
  }
  return visible;
}

}  // namespace facet::frame
