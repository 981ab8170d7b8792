#include "scene/deformation.hpp"

#include <algorithm>

namespace facet::scene {

namespace {

// Calls use(target, weight) for those that move positions.
template <class Use>
void forEachMoving(const Primitive& primitive, std::span<const float> weights, const Use& use) {
  const size_t count = std::min(weights.size(), primitive.targets.size());
  for (size_t t = 0; t < count; ++t)
    if (weights[t] != 0 && !primitive.targets[t].positions.empty()) use(primitive.targets[t], double(weights[t]));
}

bool isSkinned(const Primitive& primitive, std::span<const glm::dmat4> joints) {
  return !primitive.influences.empty() && !joints.empty();
}

// The sum of the targets' boxes may be far larger than the box of the sums: targets move different vertices. Where it
// is cheap, the latter is computed.
constexpr size_t exactMorphSums = 1 << 16;  // vertices times targets

Bounds morphedBounds(const Primitive& primitive, std::span<const float> weights, const Bounds& enclosing) {
  size_t targets = 0;
  forEachMoving(primitive, weights, [&](const MorphTarget&, double) { ++targets; });
  if (targets < 2 || primitive.positions.size() * targets > exactMorphSums) return enclosing;
  Bounds box;
  for (size_t v = 0; v < primitive.positions.size(); ++v) {
    glm::dvec3 position(primitive.positions[v]);
    forEachMoving(primitive, weights,
                  [&](const MorphTarget& t, double weight) { position += weight * glm::dvec3(t.positions[v]); });
    box.add(position);
  }
  // Vertices that no triangle uses are not in the enclosing box.
  return {glm::max(box.min, enclosing.min), glm::min(box.max, enclosing.max)};
}

void include(Bounds& box, const Bounds& other) {
  if (other.empty()) return;
  box.add(other.min);
  box.add(other.max);
}

}  // namespace

std::vector<float> morphWeights(const Mesh& mesh, const Node& node) {
  size_t targets = 0;
  for (const Primitive& primitive : mesh.primitives) targets = std::max(targets, primitive.targets.size());
  const std::vector<float>& weights = node.weights.empty() ? mesh.weights : node.weights;
  return {weights.begin(), weights.begin() + long(std::min(targets, weights.size()))};
}

Bounds deformedBounds(const Primitive& primitive, std::span<const float> weights, std::span<const glm::dmat4> joints,
                      const glm::dmat4& worldFromNode) {
  Bounds difference{glm::dvec3(0), glm::dvec3(0)};
  forEachMoving(primitive, weights, [&](const MorphTarget& target, double weight) {
    if (target.bounds.empty()) return;
    const glm::dvec3 a = target.bounds.min * weight, b = target.bounds.max * weight;
    difference.min += glm::min(a, b);
    difference.max += glm::max(a, b);
  });
  const auto morphed = [&](const Bounds& box) {
    return box.empty() ? box : Bounds{box.min + difference.min, box.max + difference.max};
  };
  if (!isSkinned(primitive, joints))
    return transformed(morphedBounds(primitive, weights, morphed(primitive.bounds)), worldFromNode);

  Bounds all;
  const size_t count = std::min(joints.size(), primitive.jointBounds.size());
  for (size_t j = 0; j < count; ++j) include(all, transformed(morphed(primitive.jointBounds[j]), joints[j]));
  if (all.empty() || primitive.influencesPerVertex == 1) return all;
  // In single precision several weights add up to 1 within half an epsilon each, and so far the vertex may be from the
  // mean, relative to its distance from the origin.
  const double slack = primitive.influencesPerVertex * 0.5 * double(std::numeric_limits<float>::epsilon());
  const glm::dvec3 reach = glm::max(glm::abs(all.min), glm::abs(all.max)) * slack;
  return {all.min - reach, all.max + reach};
}

Bounds deformedBounds(const Primitive& primitive, std::span<const float> weights, std::span<const glm::dmat4> joints,
                      const glm::dmat4& worldFromNode, MorphedBounds& morphed) {
  if (primitive.targets.empty() || isSkinned(primitive, joints))
    return deformedBounds(primitive, weights, joints, worldFromNode);
  const auto [found, isNew] = morphed.try_emplace({&primitive, {weights.begin(), weights.end()}});
  if (isNew) found->second = deformedBounds(primitive, weights, {}, glm::dmat4(1));
  return transformed(found->second, worldFromNode);
}

glm::dvec3 deformedPosition(const Primitive& primitive, size_t vertex, std::span<const float> weights,
                            std::span<const glm::dmat4> joints, const glm::dmat4& worldFromNode) {
  glm::dvec3 p = primitive.positions[vertex];
  forEachMoving(primitive, weights,
                [&](const MorphTarget& target, double weight) { p += glm::dvec3(target.positions[vertex]) * weight; });
  if (!isSkinned(primitive, joints)) return glm::dvec3(worldFromNode * glm::dvec4(p, 1));
  glm::dvec3 sum(0);
  const auto per = size_t(primitive.influencesPerVertex);
  for (size_t i = vertex * per; i < (vertex + 1) * per; ++i) {
    const Influence& influence = primitive.influences[i];
    if (influence.weight > 0) sum += glm::dvec3(joints[influence.joint] * glm::dvec4(p, 1)) * double(influence.weight);
  }
  return sum;
}

}  // namespace facet::scene
