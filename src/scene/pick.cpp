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
struct PlacedMesh {
  const Instance& instance;
  std::vector<float> weights;
  std::span<const glm::dmat4> joints;

  bool rigid() const {
    return joints.empty() && std::ranges::all_of(weights, [](float weight) { return weight == 0; });
  }
};

void pickPrimitive(const Primitive& p, const PlacedMesh& shape, const Ray& ray, const Hit& head,
                   std::vector<Hit>& hits) {
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
    hit.element = static_cast<uint32_t>(triangle);
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

// Ends of a line, twice the same of a point.
std::array<uint32_t, 2> lineVertices(const Primitive& p, size_t element) {
  const size_t corners = cornerCount(p);
  std::array<size_t, 2> ends = {element, element};
  if (p.topology == Topology::lines) ends = {2 * element, 2 * element + 1};
  if (p.topology == Topology::lineStrip || p.topology == Topology::lineLoop) ends[1] = (element + 1) % corners;
  const auto vertex = [&](size_t corner) {
    return p.indices.empty() ? static_cast<uint32_t>(corner) : p.indices[corner];
  };
  return {vertex(ends[0]), vertex(ends[1])};
}

size_t lineCount(const Primitive& p) {
  const size_t corners = cornerCount(p);
  if (hasTriangles(p.topology)) return 0;
  if (p.topology == Topology::lines) return corners / 2;
  if (p.topology == Topology::lineStrip) return corners > 0 ? corners - 1 : 0;
  return corners;  // points, and the lines of a loop
}

// The point of a line in clip space that is seen nearest to the pixel: its share of the way to the other end, and how
// far off it is in pixels. Nothing where all of it is before the near plane.
struct Approach {
  double share, pixels;
};
std::optional<Approach> approach(const Aim& aim, glm::dvec4 a, glm::dvec4 b) {
  // Only what is behind the near plane, where w + z >= 0, is seen.
  const double nearA = a.w + a.z, nearB = b.w + b.z;
  double from = 0, to = 1;
  if (nearA < 0) from = nearB > nearA ? nearA / (nearA - nearB) : 1;
  if (nearB < 0) to = nearA > nearB ? nearA / (nearA - nearB) : 0;
  if (from > to || (nearA < 0 && nearB < 0)) return std::nullopt;
  const glm::dvec4 first = a + (b - a) * from, last = a + (b - a) * to;
  if (!(first.w > 0 && last.w > 0)) return std::nullopt;
  const auto seen = [&](const glm::dvec4& clip) { return (glm::dvec2(clip) / clip.w * 0.5 + 0.5) * aim.picture; };
  const glm::dvec2 start = seen(first), way = seen(last) - start;
  const double length2 = glm::dot(way, way);
  const double t = length2 > 0 ? std::clamp(glm::dot(aim.pixel - start, way) / length2, 0.0, 1.0) : 0.0;
  const double pixels = glm::length(start + way * t - aim.pixel);
  // Along the picture -> along the line.
  const double share = t / last.w / ((1 - t) / first.w + t / last.w);
  return Approach{from + (to - from) * share, pixels};
}

void pickThinPrimitive(const Primitive& p, const PlacedMesh& shape, const Ray& ray, const Aim& aim, const Hit& head,
                       std::vector<std::pair<double, Hit>>& hits) {
  const glm::dmat4 world = shape.instance.worldFromNode;
  const auto position = [&](uint32_t v) { return deformedPosition(p, v, shape.weights, shape.joints, world); };
  for (size_t element = 0; element < lineCount(p); ++element) {
    const std::array<uint32_t, 2> ends = lineVertices(p, element);
    const glm::dvec3 a = position(ends[0]), b = position(ends[1]);
    const std::optional<Approach> near =
        approach(aim, aim.clipFromWorld * glm::dvec4(a, 1), aim.clipFromWorld * glm::dvec4(b, 1));
    if (!near || !(near->pixels <= aim.tolerance)) continue;
    Hit hit = head;
    hit.element = static_cast<uint32_t>(element);
    hit.vertices = {ends[0], ends[1], ends[1]};
    hit.weights = {1 - near->share, near->share, 0};
    hit.position = a + (b - a) * near->share;
    hit.distance = glm::dot(hit.position - ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
    hit.normal = -glm::normalize(ray.direction);
    hits.emplace_back(near->pixels, hit);
  }
}

// Calls visit(primitive, shape, hit that names them) for each primitive of each instance.
template <class Visit>
void forEachShape(const Model& model, const FlatScene& flat, const Pose& pose, const Visit& visit) {
  int instance = 0;
  for (size_t i = 0; i < flat.instances.size(); ++i) {
    const Instance& placed = flat.instances[i];
    instance = i > 0 && flat.instances[i - 1].node == placed.node ? instance + 1 : 0;
    const Mesh& mesh = model.meshes[static_cast<size_t>(placed.mesh)];
    PlacedMesh shape{placed, morphWeights(mesh, pose.nodes.of(model.nodes, placed.node)), {}};
    if (placed.skin >= 0) shape.joints = flat.joints[static_cast<size_t>(placed.skin)];
    for (size_t p = 0; p < mesh.primitives.size(); ++p) {
      Hit head;
      head.node = placed.node, head.mesh = placed.mesh, head.primitive = static_cast<int>(p), head.instance = instance;
      visit(mesh.primitives[p], shape, head);
    }
  }
}

}  // namespace

size_t triangleCount(const Primitive& p) {
  const size_t corners = cornerCount(p);
  if (p.topology == Topology::triangles) return corners / 3;
  return hasTriangles(p.topology) && corners > 2 ? corners - 2 : 0;
}

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

std::vector<Hit> pick(const Model& model, const FlatScene& flat, const Pose& pose, const Ray& ray) {
  std::vector<Hit> hits;
  MorphedBounds morphed;
  forEachShape(model, flat, pose, [&](const Primitive& primitive, const PlacedMesh& shape, const Hit& head) {
    const glm::dmat4& world = shape.instance.worldFromNode;
    if (meets(ray, deformedBounds(primitive, shape.weights, shape.joints, world, morphed)))
      pickPrimitive(primitive, shape, ray, head, hits);
  });
  std::ranges::stable_sort(hits, {}, &Hit::distance);
  return hits;
}

std::vector<Hit> pickThin(const Model& model, const FlatScene& flat, const Pose& pose, const Ray& ray, const Aim& aim) {
  std::vector<std::pair<double, Hit>> found;
  forEachShape(model, flat, pose, [&](const Primitive& primitive, const PlacedMesh& shape, const Hit& head) {
    pickThinPrimitive(primitive, shape, ray, aim, head, found);
  });
  std::ranges::stable_sort(found, {}, &std::pair<double, Hit>::first);
  std::vector<Hit> hits;
  for (const auto& [pixels, hit] : found) hits.push_back(hit);
  return hits;
}

}  // namespace facet::scene
