#include "scene/nodes.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace facet::scene {

namespace {

bool isIndex(int i, size_t count) { return i >= 0 && size_t(i) < count; }

bool isFinite(const glm::dmat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!std::isfinite(m[c][r])) return false;
  return true;
}

// Reached nodes that are not hidden, each once and parents first; transforms are filled on the way.
std::vector<int> traverse(const Model& model, int scene, const Pose& pose, NodeTransforms& out) {
  std::vector<int> order;
  out.worldFromNode.assign(model.nodes.size(), glm::dmat4(1));
  out.reached.assign(model.nodes.size(), false);
  if (!isIndex(scene, model.scenes.size())) return order;

  struct Visit {
    int node, parent;
  };
  std::vector<Visit> open;
  const auto push = [&](const std::vector<int>& nodes, int parent) {
    for (auto it = nodes.rbegin(); it != nodes.rend(); ++it)
      if (isIndex(*it, model.nodes.size())) open.push_back({*it, parent});
  };
  push(model.scenes[size_t(scene)].nodes, -1);
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const auto n = size_t(visit.node);
    if (out.reached[n]) continue;  // a node listed twice is drawn once
    out.reached[n] = true;
    const Node& node = pose.nodes.of(model.nodes, visit.node);
    if (!node.visible) continue;
    order.push_back(visit.node);
    const glm::dmat4 local = localTransform(node);
    out.worldFromNode[n] = visit.parent < 0 ? local : out.worldFromNode[size_t(visit.parent)] * local;
    push(node.children, visit.node);
  }
  return order;
}

// Divides a column by its largest component first, so that neither tiny nor huge scales under- or overflow.
glm::dvec3 safeNormalize(const glm::dvec3& v) {
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0) || !std::isfinite(largest)) return glm::dvec3(0);
  return glm::normalize(v / largest);
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

NodeTransforms worldTransforms(const Model& model, int scene) {
  NodeTransforms out;
  traverse(model, scene, {}, out);
  return out;
}

FlatScene flatten(const Model& model, int scene, const Pose& pose) {
  FlatScene flat;
  NodeTransforms transforms;
  for (const int n : traverse(model, scene, pose, transforms)) {
    const Node& node = pose.nodes.of(model.nodes, n);
    const glm::dmat4& world = transforms.worldFromNode[size_t(n)];
    const bool drawn = isIndex(node.mesh, model.meshes.size()) && !model.meshes[size_t(node.mesh)].primitives.empty();
    const bool shines = isIndex(node.light, model.lights.size());
    const bool looks = isIndex(node.camera, model.cameras.size());
    if (!drawn && !shines && !looks) continue;
    if (!isFinite(world)) {
      ++flat.overflowed;
      continue;
    }
    if (drawn) flat.instances.push_back({n, node.mesh, world, isMirrored(world)});
    if (shines) {
      PlacedLight placed{n, node.light, glm::dvec3(world[3])};
      const glm::dvec3 direction = safeNormalize(-glm::dvec3(world[2]));
      if (direction != glm::dvec3(0)) placed.direction = direction;
      flat.lights.push_back(placed);
    }
    if (looks) flat.cameras.push_back({n, node.camera, world});
  }
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

Bounds sceneBounds(const Model& model, const FlatScene& flat, const Pose&) {
  Bounds all;
  for (const Instance& instance : flat.instances)
    for (const Primitive& primitive : model.meshes[size_t(instance.mesh)].primitives) {
      const Bounds placed = transformed(primitive.bounds, instance.worldFromNode);
      if (placed.empty()) continue;
      all.add(placed.min);
      all.add(placed.max);
    }
  return all;
}

Bounds sceneBounds(const Model& model, int scene, const Pose& pose) {
  return sceneBounds(model, flatten(model, scene, pose), pose);
}

bool isMirrored(const glm::dmat4& matrix) {
  return glm::dot(glm::cross(safeNormalize(matrix[0]), safeNormalize(matrix[1])), safeNormalize(matrix[2])) < 0;
}

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
