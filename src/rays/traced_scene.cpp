#include "rays/traced_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"

namespace facet::rays {

namespace {

Box boxOf(const Triangle& t) {
  Box box;
  box.add(t.corner), box.add(t.corner + t.edge1), box.add(t.corner + t.edge2);
  return box;
}

bool hasArea(const Triangle& t) {
  const glm::dvec3 normal = glm::cross(glm::dvec3(t.edge1), glm::dvec3(t.edge2));
  const double length2 = glm::dot(normal, normal);
  return length2 > 0 && std::isfinite(length2) && std::isfinite(t.corner.x + t.corner.y + t.corner.z);
}

// A tree's nodes and triangles behind those that are there; its root.
uint32_t append(TracedScene& scene, Tree&& tree, const std::vector<Triangle>& triangles) {
  const auto firstNode = static_cast<uint32_t>(scene.nodes.size());
  const auto firstTriangle = static_cast<uint32_t>(scene.triangles.size());
  for (Node& node : tree.nodes) {
    for (uint32_t& child : node.children)
      if (child != layout::rayNone) child += child & layout::rayLeaf ? firstTriangle : firstNode;
    scene.nodes.push_back(node);
  }
  for (const uint32_t index : tree.order) scene.triangles.push_back(triangles[index]);
  return firstNode;
}

Tree treeOf(const std::vector<Triangle>& triangles) {
  std::vector<Box> boxes(triangles.size());
  std::ranges::transform(triangles, boxes.begin(), boxOf);
  return buildTree(boxes);
}

struct Placed {
  Placement placement;
  Box box;
};

std::optional<Placed> place(const TracedMesh::Place& place, const Tree& tree, uint32_t root) {
  const glm::dmat4 inverse = glm::inverse(place.worldFromMesh);
  Placed placed;
  for (int row = 0; row < 3; ++row) {
    const glm::dvec4 r(inverse[0][row], inverse[1][row], inverse[2][row], inverse[3][row]);
    if (!std::isfinite(r.x + r.y + r.z + r.w)) return std::nullopt;
    placed.placement.rows[row] = glm::vec4(r);
  }
  placed.placement.root = root;
  placed.placement.instance = place.instance;
  const Box local = tree.bounds();
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? local.max.x : local.min.x, corner & 2 ? local.max.y : local.min.y,
                       corner & 4 ? local.max.z : local.min.z);
    placed.box.add(glm::vec3(place.worldFromMesh * glm::dvec4(p, 1)));
  }
  // Rays are taken to the mesh's space in single precision.
  const glm::vec3 slack = 1e-6f * glm::max(glm::abs(placed.box.min), glm::abs(placed.box.max));
  placed.box.min -= slack, placed.box.max += slack;
  return placed;
}

}  // namespace

size_t TracedScene::bytes() const {
  return nodes.size() * sizeof(Node) + triangles.size() * sizeof(Triangle) + placements.size() * sizeof(Placement);
}

TracedScene tracedScene(std::vector<TracedMesh> meshes) {
  TracedScene scene;
  for (TracedMesh& mesh : meshes) std::erase_if(mesh.triangles, [](const Triangle& t) { return !hasArea(t); });
  std::erase_if(meshes, [](const TracedMesh& mesh) { return mesh.triangles.empty(); });
  for (const TracedMesh& mesh : meshes)
    scene.holed |=
        std::ranges::any_of(mesh.triangles, [](const Triangle& t) { return (t.primitive & layout::rayHoled) != 0; });
  if (meshes.empty() || (meshes.size() == 1 && meshes[0].places.empty())) {
    const std::vector<Triangle> triangles = meshes.empty() ? std::vector<Triangle>() : std::move(meshes[0].triangles);
    append(scene, treeOf(triangles), triangles);
    return scene;
  }
  std::vector<Tree> trees;
  for (const TracedMesh& mesh : meshes) trees.push_back(treeOf(mesh.triangles));
  // The upper tree comes first; its size is known once it is built over all places.
  std::vector<Placed> placed;
  std::vector<size_t> meshOf;
  for (size_t i = 0; i < meshes.size(); ++i) {
    std::vector<TracedMesh::Place> places = meshes[i].places;
    if (places.empty()) places.push_back({glm::dmat4(1), layout::rayOfPlacement});
    for (const TracedMesh::Place& where : places)
      if (const std::optional<Placed> p = place(where, trees[i], 0)) placed.push_back(*p), meshOf.push_back(i);
  }
  std::vector<Box> boxes;
  for (const Placed& p : placed) boxes.push_back(p.box);
  Tree upper = buildTree(boxes);
  // A leaf of several places becomes nodes of one each.
  for (size_t n = 0; n < upper.nodes.size(); ++n)
    for (size_t i = 0; i < 4; ++i) {
      const uint32_t child = upper.nodes[n].children[i];
      if (child == layout::rayNone || !(child & layout::rayLeaf)) continue;
      const uint32_t first = child & layout::rayFirstMask, count = (child >> layout::rayCountShift & 7u) + 1;
      if (count == 1) {
        upper.nodes[n].children[i] = layout::rayPlacementLeaf | first;
        continue;
      }
      upper.nodes[n].children[i] = static_cast<uint32_t>(upper.nodes.size());
      Node& below = upper.nodes.emplace_back();
      for (uint32_t j = 0; j < 4; ++j) {
        below.setBox(static_cast<int>(j), j < count ? boxes[upper.order[first + j]] : Box());
        below.children[j] = j < count ? layout::rayPlacementLeaf | (first + j) : layout::rayNone;
      }
    }
  scene.nodes = std::move(upper.nodes);
  std::vector<uint32_t> roots;
  for (size_t i = 0; i < meshes.size(); ++i)
    roots.push_back(append(scene, std::move(trees[i]), meshes[i].triangles)), meshes[i].triangles = {};
  for (const uint32_t index : upper.order) {
    scene.placements.push_back(placed[index].placement);
    scene.placements.back().root = roots[meshOf[index]];
  }
  return scene;
}

namespace {

// A ray in the space of a tree.
struct LocalRay {
  glm::vec3 origin, direction, inverse;

  LocalRay(const glm::vec3& o, const glm::vec3& d) : origin(o), direction(d) {
    for (int i = 0; i < 3; ++i) inverse[i] = 1 / (std::abs(d[i]) > 1e-30f ? d[i] : std::copysign(1e-30f, d[i]));
  }
};

// As the shader: where the ray enters a box, or infinity.
float entry(const Node& node, int child, const LocalRay& ray, float from, float to) {
  float near = from, far = to;
  for (int axis = 0; axis < 3; ++axis) {
    const Node::Range& range = node.axes[static_cast<size_t>(axis)];
    const auto i = static_cast<size_t>(child);
    const float low = (range.min[i] - ray.origin[axis]) * ray.inverse[axis];
    const float high = (range.max[i] - ray.origin[axis]) * ray.inverse[axis];
    near = std::max(near, std::min(low, high));
    far = std::min(far, std::max(low, high) * (1 + 4e-7f));
  }
  return near <= far ? near : std::numeric_limits<float>::infinity();
}

bool crosses(const Triangle& t, const LocalRay& ray, float from, float to, float& distance, glm::vec2& weights) {
  const glm::vec3 p = glm::cross(ray.direction, t.edge2);
  const float determinant = glm::dot(t.edge1, p);
  const float inverse = 1 / determinant;
  const glm::vec3 s = ray.origin - t.corner;
  weights.x = glm::dot(s, p) * inverse;
  const glm::vec3 q = glm::cross(s, t.edge1);
  weights.y = glm::dot(ray.direction, q) * inverse;
  distance = glm::dot(t.edge2, q) * inverse;
  return determinant != 0 && weights.x >= 0 && weights.y >= 0 && weights.x + weights.y <= 1 && distance > from &&
         distance < to;
}

template <bool any>
std::optional<Hit> walk(const TracedScene& scene, const Ray& ray) {
  std::optional<Hit> found;
  float to = ray.to;
  const LocalRay world(ray.origin, ray.direction);
  LocalRay local = world;
  std::vector<uint32_t> stack = {0};
  size_t below = 0;  // stack entries of the upper tree while a placement is walked
  uint32_t instance = 0;
  bool inside = false;
  while (!stack.empty()) {
    if (inside && stack.size() == below) local = world, inside = false;
    const uint32_t at = stack.back();
    stack.pop_back();
    if (!(at & layout::rayLeaf)) {
      const Node& node = scene.nodes[at];
      std::array<std::pair<float, uint32_t>, 4> children;
      for (int i = 0; i < 4; ++i)
        children[static_cast<size_t>(i)] = {entry(node, i, local, ray.from, to), node.children[static_cast<size_t>(i)]};
      std::ranges::stable_sort(children, {}, &std::pair<float, uint32_t>::first);
      for (int i = 4; i-- > 0;)
        if (children[static_cast<size_t>(i)].first < std::numeric_limits<float>::infinity() &&
            children[static_cast<size_t>(i)].second != layout::rayNone)
          stack.push_back(children[static_cast<size_t>(i)].second);
      continue;
    }
    if ((at & layout::rayPlacementLeaf) == layout::rayPlacementLeaf) {
      const Placement& p = scene.placements[at & layout::rayFirstMask];
      const auto moved = [&](const glm::vec3& v, float w) {
        const glm::vec4 h(v, w);
        return glm::vec3(glm::dot(p.rows[0], h), glm::dot(p.rows[1], h), glm::dot(p.rows[2], h));
      };
      local = LocalRay(moved(ray.origin, 1), moved(ray.direction, 0));
      instance = p.instance;
      inside = true;
      below = stack.size();
      stack.push_back(p.root);
      continue;
    }
    const uint32_t first = at & layout::rayFirstMask, count = (at >> layout::rayCountShift & 7u) + 1;
    for (uint32_t i = first; i < first + count; ++i) {
      const Triangle& t = scene.triangles[i];
      float distance;
      glm::vec2 weights;
      if (!crosses(t, local, ray.from, to, distance, weights)) continue;
      to = distance;
      found = Hit{t.primitive & layout::rayPrimitiveMask, t.triangle,
                  t.instance == layout::rayOfPlacement ? instance : t.instance, distance, weights};
      if (any) return found;
    }
  }
  return found;
}

}  // namespace

std::optional<Hit> meet(const TracedScene& scene, const Ray& ray) { return walk<false>(scene, ray); }
bool isBlocked(const TracedScene& scene, const Ray& ray) { return walk<true>(scene, ray).has_value(); }

}  // namespace facet::rays
