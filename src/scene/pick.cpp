#include "scene/pick.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "scene/deformation.hpp"
#include "scene/geometry.hpp"

namespace facet::scene {

namespace {

// Slabs (Kay and Kajiya 1986), widened by rounding.
bool meets(const Ray& ray, const Bounds& box) {
  if (box.empty()) return false;
  double near = 0, far = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double slack = 1e-9 * std::max(std::abs(box.min[axis]), std::abs(box.max[axis]));
    const double low = box.min[axis] - slack - ray.origin[axis], high = box.max[axis] + slack - ray.origin[axis];
    const double along = ray.direction[axis];
    if (along == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    near = std::max(near, std::min(low / along, high / along));
    far = std::min(far, std::max(low / along, high / along));
  }
  return near <= far;
}

size_t cornerCount(const Primitive& p) { return p.indices.empty() ? p.positions.size() : p.indices.size(); }

size_t triangleCount(const Primitive& p) {
  const size_t corners = cornerCount(p);
  if (p.topology == Topology::triangles) return corners / 3;
  return hasTriangles(p.topology) && corners > 2 ? corners - 2 : 0;
}

// Counter-clockwise seen from the front, as OpenGL winds strips and fans.
std::array<uint32_t, 3> triangleVertices(const Primitive& p, size_t triangle) {
  std::array<size_t, 3> corners{};
  if (p.topology == Topology::triangleStrip)
    corners = triangle % 2 == 0 ? std::array{triangle, triangle + 1, triangle + 2}
                                : std::array{triangle + 1, triangle, triangle + 2};
  else if (p.topology == Topology::triangleFan)
    corners = {0, triangle + 1, triangle + 2};
  else
    corners = {3 * triangle, 3 * triangle + 1, 3 * triangle + 2};
  std::array<uint32_t, 3> vertices{};
  for (size_t i = 0; i < 3; ++i)
    vertices[i] = p.indices.empty() ? static_cast<uint32_t>(corners[i]) : p.indices[corners[i]];
  return vertices;
}

struct Crossing {
  double distance;
  glm::dvec3 weights;
};

std::optional<Crossing> cross(const Ray& ray, const std::array<glm::dvec3, 3>& corner) {
  const glm::dvec3 a = corner[1] - corner[0], b = corner[2] - corner[0];
  const glm::dvec3 p = glm::cross(ray.direction, b);
  const double determinant = glm::dot(a, p);
  if (determinant == 0 || !std::isfinite(determinant)) return std::nullopt;
  const glm::dvec3 t = ray.origin - corner[0], q = glm::cross(t, a);
  const double u = glm::dot(t, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  constexpr double rounding = 1e-12;
  if (u < -rounding || v < -rounding || u + v > 1 + rounding) return std::nullopt;
  const double distance = glm::dot(b, q) / determinant;
  if (!(distance >= 0)) return std::nullopt;
  return Crossing{distance, {1 - u - v, u, v}};
}

// An instance and what deforms it.
struct Shape {
  const Instance& instance;
  std::vector<float> weights;
  std::span<const glm::dmat4> joints;

  bool rigid() const {
    return joints.empty() && std::ranges::all_of(weights, [](float weight) { return weight == 0; });
  }
};

void pickPrimitive(const Primitive& p, const Shape& shape, const Ray& ray, const Hit& head, std::vector<Hit>& hits) {
  // A rigid shape is met in its own space, where no vertex has to be moved; distances stay the same.
  Ray local = ray;
  const glm::dmat4 world = shape.instance.worldFromNode;
  const bool inside = shape.rigid() && std::abs(glm::determinant(glm::dmat3(world))) > 1e-30;
  if (inside) {
    const glm::dmat4 nodeFromWorld = glm::inverse(world);
    local = {glm::dvec3(nodeFromWorld * glm::dvec4(ray.origin, 1)), glm::dmat3(nodeFromWorld) * ray.direction};
  }
  std::vector<glm::dvec3> moved;
  if (!inside)
    for (size_t v = 0; v < p.positions.size(); ++v)
      moved.push_back(deformedPosition(p, v, shape.weights, shape.joints, world));
  const auto position = [&](uint32_t v) { return inside ? glm::dvec3(p.positions[v]) : moved[v]; };
  for (size_t triangle = 0; triangle < triangleCount(p); ++triangle) {
    const std::array<uint32_t, 3> vertices = triangleVertices(p, triangle);
    std::array<glm::dvec3, 3> corner = {position(vertices[0]), position(vertices[1]), position(vertices[2])};
    const std::optional<Crossing> crossing = cross(local, corner);
    if (!crossing) continue;
    Hit hit = head;
    hit.triangle = static_cast<uint32_t>(triangle);
    hit.vertices = vertices;
    hit.weights = crossing->weights;
    hit.distance = crossing->distance;
    hit.position = ray.origin + ray.direction * hit.distance;
    if (inside)
      for (glm::dvec3& c : corner) c = glm::dvec3(world * glm::dvec4(c, 1));
    const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double length = glm::length(normal) * (shape.instance.mirrored ? -1 : 1);
    if (length != 0) hit.normal = normal / length;
    hit.front = glm::dot(hit.normal, ray.direction) <= 0;
    hits.push_back(hit);
  }
}

}  // namespace

std::vector<Hit> pick(const Model& model, const FlatScene& flat, const Pose& pose, const Ray& ray) {
  std::vector<Hit> hits;
  MorphedBounds morphed;
  int instance = 0;
  for (size_t i = 0; i < flat.instances.size(); ++i) {
    const Instance& placed = flat.instances[i];
    instance = i > 0 && flat.instances[i - 1].node == placed.node ? instance + 1 : 0;
    const Mesh& mesh = model.meshes[static_cast<size_t>(placed.mesh)];
    Shape shape{placed, morphWeights(mesh, pose.nodes.of(model.nodes, placed.node)), {}};
    if (placed.skin >= 0) shape.joints = flat.joints[static_cast<size_t>(placed.skin)];
    for (size_t p = 0; p < mesh.primitives.size(); ++p) {
      const Primitive& primitive = mesh.primitives[p];
      if (!meets(ray, deformedBounds(primitive, shape.weights, shape.joints, placed.worldFromNode, morphed))) continue;
      Hit head;
      head.node = placed.node, head.mesh = placed.mesh, head.primitive = static_cast<int>(p), head.instance = instance;
      pickPrimitive(primitive, shape, ray, head, hits);
    }
  }
  std::ranges::stable_sort(hits, {}, &Hit::distance);
  return hits;
}

}  // namespace facet::scene
