#include <algorithm>

#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/formats.hpp"
#include "io/validate/graph.hpp"

namespace facet::io::validate {

namespace {

// The node and all that are above it.
std::set<int> pathOf(const std::vector<int>& parents, int node) {
  std::set<int> path;
  while (node >= 0 && path.insert(node).second) node = parents[static_cast<size_t>(node)];
  return path;
}

void checkRoots(Asset& asset, const Json& skin, const std::vector<int>& joints, const std::vector<int>& parents,
                const std::string& place) {
  if (joints.empty()) return;
  std::set<int> common = pathOf(parents, joints[0]);
  for (const int joint : joints) {
    // A node is above nearly all joints: what is left shrinks to it at once.
    const std::set<int> path = pathOf(parents, joint);
    std::erase_if(common, [&](int node) { return !path.contains(node); });
    if (common.empty()) break;
  }
  if (common.empty()) asset.add(Code::SKIN_NO_COMMON_ROOT, place + "/joints", "there is no node that all are below");
  const int skeleton = indexAt(asset, skin, "skeleton", "nodes");
  if (skeleton >= 0 && !common.contains(skeleton))
    asset.add(Code::SKIN_SKELETON_INVALID, place + "/skeleton",
              "not all joints are below node " + std::to_string(skeleton));
}

void checkMatrices(Asset& asset, const Json& skin, size_t joints, const std::string& place) {
  const int index = indexAt(asset, skin, "inverseBindMatrices", "accessors");
  if (index < 0) return;
  useAccessor(asset, index, Use::matrices, place);
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  useView(asset, a.view, Use::matrices, place);
  if (a.view >= 0 && asset.views[static_cast<size_t>(a.view)].stride != 0)
    asset.add(Code::SKIN_IBM_ACCESSOR_WITH_BYTESTRIDE, place, "the buffer view has a stride");
  if (!a.wellFormed) return;
  if (a.type != "MAT4" || !isFloat(a.componentType)) {
    asset.add(Code::SKIN_IBM_INVALID_FORMAT, place, "is " + formatText(a));
  } else {
    Tally wrong;
    forEachElement(asset, a, false, [&](uint64_t element, std::span<const double> m) {
      for (const size_t i : {3, 7, 11})
        if (m[i] != 0) wrong.add(element, m[i]);
      if (m[15] != 1) wrong.add(element, m[15]);
    });
    if (wrong.count > 0) asset.add(Code::ACCESSOR_INVALID_IBM, place, tallyText(wrong, "of the last row not 0 0 0 1"));
  }
  if (a.count < joints)
    asset.add(Code::INVALID_IBM_ACCESSOR_COUNT, place,
              std::to_string(a.count) + " matrices for " + std::to_string(joints) + " joints");
}

}  // namespace

void checkSkins(Asset& asset) {
  const Json& skins = collection(asset, "skins");
  if (skins.empty()) return;
  const std::vector<int> parents = parentsOf(asset);
  for (size_t i = 0; i < skins.size(); ++i) {
    const std::string place = at("/skins", i);
    const std::vector<int> joints = jointsOf(asset, static_cast<int>(i));
    checkRoots(asset, skins[i], joints, parents, place);
    checkMatrices(asset, skins[i], joints.size(), place + "/inverseBindMatrices");
  }
}

}  // namespace facet::io::validate
