// Joints and weights of skinned meshes.

#include <array>
#include <cmath>

#include "io/validate/checks.hpp"
#include "io/validate/elements.hpp"
#include "io/validate/formats.hpp"
#include "io/validate/graph.hpp"

namespace facet::io::validate {

namespace {

// What a weight may be off by when it is written in single precision, as the yardstick has it.
constexpr double weightTolerance = 2e-7;
constexpr size_t mostSets = 16;

struct Set {
  std::vector<std::array<double, 4>> joints, weights;
};

std::optional<std::vector<std::array<double, 4>>> vectorsOf(Asset& asset, int index, std::string_view attribute) {
  if (index < 0) return std::nullopt;
  const Accessor& a = asset.accessors[static_cast<size_t>(index)];
  if (!a.wellFormed || !isAttributeFormat(asset, attribute, false, a)) return std::nullopt;
  std::vector<std::array<double, 4>> out;
  const bool read = forEachElement(asset, a, true, [&](uint64_t, std::span<const double> v) {
    out.push_back({v[0], v[1], v[2], v[3]});
  });
  return read ? std::optional(std::move(out)) : std::nullopt;
}

struct Tallies {
  Tally beyond, twice, negative, idle, sum;
};

void checkVertex(const std::vector<Set>& sets, size_t vertex, size_t jointCount, std::vector<Tallies>& tallies) {
  std::set<double> seen;
  float sum = 0;
  double tolerance = 0;
  for (size_t s = 0; s < sets.size(); ++s)
    for (size_t c = 0; c < 4; ++c) {
      const double joint = sets[s].joints[vertex][c], weight = sets[s].weights[vertex][c];
      if (joint >= static_cast<double>(jointCount)) {
        tallies[s].beyond.add(vertex, joint);
      } else if (weight == 0) {
        if (joint != 0) tallies[s].idle.add(vertex, joint);
      } else if (weight < 0) {
        tallies[s].negative.add(vertex, weight);
      } else if (!seen.insert(joint).second) {
        tallies[s].twice.add(vertex, joint);
      } else {
        sum = static_cast<float>(static_cast<double>(sum) + weight);
        tolerance += weightTolerance;
      }
    }
  if (std::abs(static_cast<double>(sum) - 1) > tolerance)
    for (Tallies& t : tallies) t.sum.add(vertex, static_cast<double>(sum));
}

void checkPrimitive(Asset& asset, const Json& primitive, size_t jointCount, const std::string& place) {
  const Json& attributes = member(primitive, "attributes");
  std::vector<Set> sets;
  for (size_t s = 0; s < mostSets; ++s) {
    const std::string joints = "JOINTS_" + std::to_string(s), weights = "WEIGHTS_" + std::to_string(s);
    auto j = vectorsOf(asset, indexAt(asset, attributes, joints, "accessors"), joints);
    auto w = vectorsOf(asset, indexAt(asset, attributes, weights, "accessors"), weights);
    if (!j || !w || j->size() != w->size() || (!sets.empty() && sets[0].joints.size() != j->size())) break;
    sets.push_back({std::move(*j), std::move(*w)});
  }
  if (sets.empty()) return;
  std::vector<Tallies> tallies(sets.size());
  for (size_t vertex = 0; vertex < sets[0].joints.size(); ++vertex) checkVertex(sets, vertex, jointCount, tallies);
  for (size_t s = 0; s < sets.size(); ++s) {
    const std::string joints = place + "/attributes/JOINTS_" + std::to_string(s),
                      weights = place + "/attributes/WEIGHTS_" + std::to_string(s);
    const auto tell = [&](Code code, const std::string& where, const Tally& tally, const std::string& what) {
      if (tally.count > 0) asset.add(code, where, tallyText(tally, what));
    };
    const Tallies& t = tallies[s];
    tell(Code::ACCESSOR_JOINTS_INDEX_OOB, joints, t.beyond,
         "beyond the skin's " + std::to_string(jointCount) + " joints");
    tell(Code::ACCESSOR_JOINTS_INDEX_DUPLICATE, joints, t.twice, "with a joint twice");
    tell(Code::ACCESSOR_JOINTS_USED_ZERO_WEIGHT, joints, t.idle, "with a joint of weight zero");
    tell(Code::ACCESSOR_WEIGHTS_NEGATIVE, weights, t.negative, "negative");
    tell(Code::ACCESSOR_WEIGHTS_NON_NORMALIZED, weights, t.sum, "whose weights don't sum to one");
  }
}

}  // namespace

void checkInfluences(Asset& asset) {
  const Json &nodes = collection(asset, "nodes"), &meshes = collection(asset, "meshes");
  std::vector<size_t> fewest(meshes.size(), SIZE_MAX);  // joints of the skins that each mesh is shown with
  for (const Json& node : nodes) {
    const int mesh = indexAt(asset, node, "mesh", "meshes"), skin = indexAt(asset, node, "skin", "skins");
    if (mesh < 0 || skin < 0) continue;
    size_t& least = fewest[static_cast<size_t>(mesh)];
    if (const size_t joints = jointsOf(asset, skin).size(); joints > 0) least = std::min(least, joints);
  }
  for (size_t m = 0; m < meshes.size(); ++m) {
    const Json& primitives = member(meshes[m], "primitives");
    if (fewest[m] == SIZE_MAX || !primitives.is_array()) continue;
    for (size_t p = 0; p < primitives.size(); ++p) {
      const Json& attributes = member(primitives[p], "attributes");
      const std::string key = "influences " + std::to_string(fewest[m]) + member(attributes, "JOINTS_0").dump() + " " +
                              member(attributes, "WEIGHTS_0").dump() + " " + member(attributes, "JOINTS_1").dump();
      if (asset.checked.insert(key).second)
        checkPrimitive(asset, primitives[p], fewest[m], at(at("/meshes", m) + "/primitives", p));
    }
  }
}

}  // namespace facet::io::validate
