#include "io/validate/vertex_data.hpp"

#include <cmath>

#include "io/validate/elements.hpp"

namespace facet::io::validate {

namespace {

bool isFirst(Asset& asset, int accessor, const std::string& check) {
  return asset.checked.insert(std::to_string(accessor) + " " + check).second;
}

double largestIndex(int componentType) {
  return componentType == 5121 ? 255 : componentType == 5123 ? 65535 : 4294967295.0;
}

}  // namespace

void checkUnitVectors(Asset& asset, int accessor, bool tangents, const std::string& place) {
  if (!isFirst(asset, accessor, tangents ? "tangent" : "normal")) return;
  Tally length, sign;
  const Accessor& a = asset.accessors[static_cast<size_t>(accessor)];
  forEachElement(asset, a, true, [&](uint64_t element, std::span<const double> v) {
    const double size = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (std::abs(size - 1) > unitTolerance) length.add(element, size);
    if (tangents && std::abs(v[3]) != 1) sign.add(element, v[3]);
  });
  if (length.count > 0) asset.add(Code::ACCESSOR_VECTOR3_NON_UNIT, place, tallyText(length, "not of unit length"));
  if (sign.count > 0) asset.add(Code::ACCESSOR_INVALID_SIGN, place, tallyText(sign, "whose w is neither 1 nor -1"));
}

void checkClamped(Asset& asset, int accessor, const std::string& place) {
  if (!isFirst(asset, accessor, "colour")) return;
  Tally outside;
  forEachElement(asset, asset.accessors[static_cast<size_t>(accessor)], false,
                 [&](uint64_t element, std::span<const double> v) {
                   for (const double value : v)
                     if (value < 0 || value > 1) outside.add(element, value);
                 });
  if (outside.count > 0) asset.add(Code::ACCESSOR_NON_CLAMPED, place, tallyText(outside, "not within 0 and 1"));
}

void checkIndexData(Asset& asset, int accessor, uint64_t vertices, bool triangles, const std::string& place) {
  if (!isFirst(asset, accessor, "index " + std::to_string(vertices) + (triangles ? " t" : ""))) return;
  const Accessor& a = asset.accessors[static_cast<size_t>(accessor)];
  const double restart = largestIndex(a.componentType);
  Tally beyond, restarts;
  uint64_t degenerate = 0;
  double corners[3] = {};
  forEachElement(asset, a, false, [&](uint64_t element, std::span<const double> v) {
    if (v[0] >= static_cast<double>(vertices)) beyond.add(element, v[0]);
    if (v[0] == restart) restarts.add(element, v[0]);
    corners[element % 3] = v[0];
    if (triangles && element % 3 == 2 &&
        (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]))
      ++degenerate;
  });
  if (beyond.count > 0)
    asset.add(Code::ACCESSOR_INDEX_OOB, place,
              tallyText(beyond, "not below the number of vertices, " + std::to_string(vertices)));
  if (restarts.count > 0)
    asset.add(Code::ACCESSOR_INDEX_PRIMITIVE_RESTART, place, tallyText(restarts, "the value that restarts primitives"));
  if (degenerate > 0)
    asset.add(Code::ACCESSOR_INDEX_TRIANGLE_DEGENERATE, place,
              std::to_string(degenerate) + " of " + std::to_string(a.count / 3) + " triangles name a vertex twice");
}

}  // namespace facet::io::validate
