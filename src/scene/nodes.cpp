#include "scene/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/deformation.hpp"

namespace facet::scene {

namespace {

bool isIndex(int i, size_t count) { return i >= 0 && size_t(i) < count; }

bool isFinite(const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

// Divides a column by its largest component first, so that neither tiny nor huge scales under- or overflow.
glm::dvec3 safeNormalize(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
  return glm::normalize(v / largest);
}

// 1 right-handed, -1 left-handed, 0 singular.
int handedness(const glm::dmat4& m) {
  const double volume = glm::dot(glm::cross(safeNormalize(m[0]), safeNormalize(m[1])), safeNormalize(m[2]));
  return volume > 0 ? 1 : volume < 0 ? -1 : 0;
}

// Transforms of nodes that the scene doesn't reach, by their chain of parents; `known` are those that have theirs.
const glm::dmat4& placeByParents(const Model& model, const Pose& pose, int node, std::vector<bool>& known,
                                 std::vector<glm::dmat4>& worldFromNode) {
  std::vector<int> chain;
  int n = node;
  for (; isIndex(n, known.size()) && !known[size_t(n)]; n = pose.nodes.of(model.nodes, n).parent) {
    known[size_t(n)] = true;
    chain.push_back(n);
  }
  glm::dmat4 world = isIndex(n, known.size()) ? worldFromNode[size_t(n)] : pose.worldFromModel.value_or(glm::dmat4(1));
  for (auto it = chain.rbegin(); it != chain.rend(); ++it)
    worldFromNode[size_t(*it)] = world = world * localTransform(pose.nodes.of(model.nodes, *it));
  return worldFromNode[size_t(node)];
}

// What a skin does to meshes; empty without a joint whose matrix is finite.
struct PlacedSkin {
  bool made = false, mirrored = false;
  std::vector<glm::dmat4> joints;
  int replaced = 0;
};

PlacedSkin placeSkin(const Model& model, const Pose& pose, const Skin& skin, std::vector<bool>& known,
                     std::vector<glm::dmat4>& worldFromNode) {
  PlacedSkin placed{true, false, {}, 0};
  std::vector<size_t> bad;
  const glm::dmat4* good = nullptr;
  int votes = 0, firstVote = 0;
  placed.joints.reserve(skin.joints.size());
  for (size_t j = 0; j < skin.joints.size(); ++j) {
    const glm::dmat4& world = placeByParents(model, pose, skin.joints[j], known, worldFromNode);
    const glm::dmat4& m =
        placed.joints.emplace_back(j < skin.inverseBindMatrices.size() ? world * skin.inverseBindMatrices[j] : world);
    if (!isFinite(m)) {
      bad.push_back(j);
      continue;
    }
    if (good == nullptr) good = &m;
    votes += handedness(m);
    if (firstVote == 0) firstVote = handedness(m);
  }
  placed.mirrored = votes < 0 || (votes == 0 && firstVote < 0);
  placed.replaced = int(bad.size());
  if (good == nullptr) placed.joints.clear();
  for (const size_t j : bad)
    if (good != nullptr) placed.joints[j] = *good;
  return placed;
}

bool hasInfluences(const Mesh& mesh) {
  return std::ranges::any_of(mesh.primitives, [](const Primitive& p) { return !p.influences.empty(); });
}

void addInstances(const Node& node, int n, const glm::dmat4& world, FlatScene& flat) {
  const auto add = [&](const glm::dmat4& m) {
    if (isFinite(m))
      flat.instances.push_back({n, node.mesh, m, isMirrored(m)});
    else
      ++flat.overflowed;
  };
  if (node.instances.empty()) add(world);
  for (const glm::dmat4& instance : node.instances) add(world * instance);
}

void addLight(int light, int n, const glm::dmat4& world, FlatScene& flat) {
  PlacedLight placed{n, light, glm::dvec3(world[3])};
  const glm::dvec3 direction = safeNormalize(-glm::dvec3(world[2])), x = safeNormalize(glm::dvec3(world[0]));
  if (direction != glm::dvec3(0)) placed.direction = direction;
  // What a flat matrix leaves open is any direction.
  glm::dvec3 side = x - placed.direction * glm::dot(placed.direction, x);
  if (!(glm::length(side) > 1e-9))
    side = glm::cross(placed.direction, std::abs(placed.direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0));
  placed.side = glm::normalize(side);
  placed.mirrored = isMirrored(world);
  flat.lights.push_back(placed);
}

}  // namespace

glm::dmat4 localTransform(const Node& node) {
  if (node.matrix) return *node.matrix;
  glm::dmat4 m = glm::mat4_cast(node.rotation);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= node.scale[axis];
  m[3] = glm::dvec4(node.translation, 1);
  return m;
}

void decompose(Node& node) {
  if (!node.matrix) return;
  const glm::dmat4 m = *node.matrix;
  node.matrix.reset();
  node.translation = glm::dvec3(m[3]);
  glm::dmat3 axes(0);
  int first = -1, missing = -1, count = 0;
  for (int c = 0; c < 3; ++c) {
    const glm::dvec3 column(m[c]);
    const glm::dvec3 unit = safeNormalize(column);
    node.scale[c] = glm::dot(unit, column);
    glm::dvec3 rest = unit;
    for (int before = 0; before < c; ++before) rest -= axes[before] * glm::dot(axes[before], unit);
    if (glm::length(rest) > 1e-9) {
      axes[c] = glm::normalize(rest);
      if (first < 0) first = c;
      ++count;
    } else {
      missing = c;
    }
  }
  if (count == 0) axes = glm::dmat3(1);
  if (count == 1) {  // any axis that is far from the given one
    const glm::dvec3 other = std::abs(axes[first].x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    axes[(first + 1) % 3] = glm::normalize(other - axes[first] * glm::dot(axes[first], other));
    missing = (first + 2) % 3;
  }
  if (count == 1 || count == 2) axes[missing] = glm::cross(axes[(missing + 1) % 3], axes[(missing + 2) % 3]);
  if (glm::dot(glm::cross(axes[0], axes[1]), axes[2]) < 0) axes[0] = -axes[0], node.scale.x = -node.scale.x;
  node.rotation = glm::normalize(glm::quat_cast(axes));
}

NodeTransforms worldTransforms(const Model& model, int scene, const Pose& pose) {
  NodeTransforms out;
  out.worldFromNode.assign(model.nodes.size(), glm::dmat4(1));
  out.reached.assign(model.nodes.size(), false);
  out.hidden.assign(model.nodes.size(), false);
  out.wanted.assign(model.nodes.size(), false);
  if (!isIndex(scene, model.scenes.size())) return out;

  struct Visit {
    int node, parent;
  };
  std::vector<Visit> open;
  const auto push = [&](const std::vector<int>& nodes, int parent) {
    for (auto it = nodes.rbegin(); it != nodes.rend(); ++it)
      if (isIndex(*it, model.nodes.size())) open.push_back({*it, parent});
  };
  push(model.scenes[size_t(scene)].nodes, -1);
  std::vector<bool> only(model.nodes.size(), false);
  for (const int node : pose.only)
    if (isIndex(node, only.size())) only[size_t(node)] = true;
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const auto n = size_t(visit.node);
    if (out.reached[n]) continue;  // a node listed twice is drawn once
    out.reached[n] = true;
    out.order.push_back(visit.node);
    const Node& node = pose.nodes.of(model.nodes, visit.node);
    const glm::dmat4 local = localTransform(node);
    const bool root = visit.parent < 0;
    if (!root)
      out.worldFromNode[n] = out.worldFromNode[size_t(visit.parent)] * local;
    else
      out.worldFromNode[n] = pose.worldFromModel ? *pose.worldFromModel * local : local;
    out.hidden[n] = !node.visible || (!root && out.hidden[size_t(visit.parent)]);
    out.wanted[n] = only[n] || (root ? pose.only.empty() : out.wanted[size_t(visit.parent)]);
    push(node.children, visit.node);
  }
  return out;
}

FlatScene flatten(const Model& model, int scene, const Pose& pose) {
  FlatScene flat;
  flat.joints.resize(model.skins.size());
  NodeTransforms transforms = worldTransforms(model, scene, pose);
  std::vector<bool> known = transforms.reached;
  std::vector<PlacedSkin> skins(model.skins.size());
  std::vector<bool> skinned(model.meshes.size());
  for (size_t m = 0; m < skinned.size() && !skins.empty(); ++m) skinned[m] = hasInfluences(model.meshes[m]);

  const auto addSkinned = [&](const Node& node, int n) {
    PlacedSkin& skin = skins[size_t(node.skin)];
    if (!skin.made) {
      skin = placeSkin(model, pose, model.skins[size_t(node.skin)], known, transforms.worldFromNode);
      flat.overflowed += skin.replaced;
    }
    if (skin.joints.empty()) return;
    flat.instances.push_back({n, node.mesh, glm::dmat4(1), skin.mirrored, node.skin});
  };
  for (const int n : transforms.order) {
    const Node& node = pose.nodes.of(model.nodes, n);
    const glm::dmat4& world = transforms.worldFromNode[size_t(n)];
    const bool hidden = transforms.hidden[size_t(n)];
    const bool drawn = !hidden && transforms.wanted[size_t(n)] && isIndex(node.mesh, model.meshes.size()) &&
                       !model.meshes[size_t(node.mesh)].primitives.empty();
    const bool bySkin = drawn && isIndex(node.skin, skins.size()) && skinned[size_t(node.mesh)];
    const bool shines = !hidden && isIndex(node.light, model.lights.size());
    const bool profiled = !hidden && isIndex(node.profiledLight, model.lights.size());
    const bool looks = isIndex(node.camera, model.cameras.size());
    if (bySkin) addSkinned(node, n);
    if (drawn && !bySkin) addInstances(node, n, world, flat);
    if (!shines && !profiled && !looks) continue;
    if (!isFinite(world)) {
      ++flat.overflowed;
      continue;
    }
    if (shines) addLight(node.light, n, world, flat);
    if (profiled) addLight(node.profiledLight, n, world, flat);
    if (looks) flat.cameras.push_back({n, node.camera, world});
  }
  for (size_t s = 0; s < skins.size(); ++s) flat.joints[s] = std::move(skins[s].joints);
  return flat;
}

Bounds transformed(const Bounds& bounds, const glm::dmat4& matrix) {
  if (bounds.empty()) return {};
  const glm::dvec3 center = glm::dvec3(matrix * glm::dvec4(bounds.center(), 1));
  const glm::dvec3 half = bounds.max * 0.5 - bounds.min * 0.5;
  glm::dvec3 reach(0);
  for (int axis = 0; axis < 3; ++axis) reach += glm::abs(glm::dvec3(matrix[axis])) * half[axis];
  return {center - reach, center + reach};
}

Bounds sceneBounds(const Model& model, const FlatScene& flat, const Pose& pose) {
  Bounds all;
  std::vector<float> weights;
  MorphedBounds morphed;
  for (const Instance& instance : flat.instances) {
    const Mesh& mesh = model.meshes[size_t(instance.mesh)];
    std::span<const glm::dmat4> joints;
    if (instance.skin >= 0) joints = flat.joints[size_t(instance.skin)];
    weights = morphWeights(mesh, pose.nodes.of(model.nodes, instance.node));
    for (const Primitive& primitive : mesh.primitives) {
      const Bounds placed = deformedBounds(primitive, weights, joints, instance.worldFromNode, morphed);
      if (placed.empty()) continue;
      all.add(placed.min);
      all.add(placed.max);
    }
  }
  return all;
}

Bounds sceneBounds(const Model& model, int scene, const Pose& pose) {
  return sceneBounds(model, flatten(model, scene, pose), pose);
}

bool isMirrored(const glm::dmat4& matrix) { return handedness(matrix) < 0; }

glm::dmat3 normalTransform(const glm::dmat4& matrix) {
  // Columns are scaled to at most 1 before the products and back after them, as ratios only.
  const glm::dmat3 m(matrix);
  double largest = 0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(m[c][r]));
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dmat3(1);
  const glm::dmat3 a = m / largest;
  glm::dmat3 cofactor(glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1]));
  const double longest = std::max({glm::length(cofactor[0]), glm::length(cofactor[1]), glm::length(cofactor[2])});
  if (!(longest > 0)) return glm::dmat3(1);
  return cofactor * ((isMirrored(matrix) ? -1.0 : 1.0) / longest);
}

}  // namespace facet::scene
