#include "frame/visibility.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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
};

std::vector<Sorted> see(const DrawList& list, const std::vector<Draw>& draws, const scene::View& view,
                        const std::array<glm::dvec4, 6>& planes, VisibleDraws& visible) {
  std::vector<Sorted> sorted;
  for (const Draw& draw : draws) {
    const std::vector<Seen> seen = seenInstances(list, draw, view, planes);
    visible.culled += draw.instanceCount - seen.size();
    if (seen.empty()) continue;
    sorted.push_back({draw, seen.front().depth});
    sorted.back().draw.firstInstance = static_cast<uint32_t>(visible.instances.size());
    sorted.back().draw.instanceCount = static_cast<uint32_t>(seen.size());
    for (const Seen& s : seen) visible.instances.push_back(s.instance);
  }
  return sorted;
}

}  // namespace

VisibleDraws visibleDraws(const DrawList& list, const scene::View& view, const ClipRows& rows, double margin) {
  VisibleDraws visible;
  const std::array<glm::dvec4, 6> planes = frustumPlanes(view.clipFromWorld, rows, margin);
  std::vector<Sorted> opaque = see(list, list.opaque, view, planes, visible);
  std::ranges::stable_sort(opaque, {},
                           [](const Sorted& s) { return std::tuple(s.draw.key, s.draw.material, s.depth); });
  std::vector<Sorted> blended = see(list, list.blended, view, planes, visible);
  std::ranges::stable_sort(blended, std::greater<>(), &Sorted::depth);
  for (const Sorted& s : opaque) visible.opaque.push_back(s.draw);
  for (const Sorted& s : blended) visible.blended.push_back(s.draw);
  return visible;
}

}  // namespace facet::frame
