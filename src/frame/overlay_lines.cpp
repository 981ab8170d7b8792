#include "frame/overlay_lines.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/angle.hpp"
#include "frame/choose.hpp"
#include "frame/settings.hpp"
#include "frame/traced.hpp"
#include "optics/color.hpp"
#include "optics/light_profile.hpp"
#include "scene/camera.hpp"
#include "scene/nodes.hpp"
#include "scene/pick.hpp"
#include "scene/weld.hpp"

namespace facet::frame {

namespace {

constexpr glm::vec4 red(0.93f, 0.26f, 0.30f, 1), green(0.42f, 0.78f, 0.22f, 1), blue(0.25f, 0.55f, 1.0f, 1);
constexpr glm::vec4 wireColor(0.02f, 0.02f, 0.03f, 0.8f), boxColor(1.0f, 0.66f, 0.20f, 1),
    partColor(1, 0.66f, 0.2f, 0.5f);
constexpr glm::vec4 boneColor(0.25f, 0.9f, 0.95f, 1), jointColor(1, 1, 1, 1), normalColor(0.30f, 0.62f, 1.0f, 1);
constexpr glm::vec4 cameraColor(0.95f, 0.45f, 0.95f, 1), sunColor(1.0f, 0.85f, 0.25f, 1);
constexpr int circleSteps = 48;

glm::vec4 faded(glm::vec4 color, float alpha) { return {glm::vec3(color), color.a * alpha}; }

// Lines in the world of one colour and kind.
class Pen {
 public:
  Pen(const DrawList& list, std::vector<OverlayLine>& out) : origin_(list.origin), out_(out) {}

  float width = 1.5f, hidden = 0.25f;
  glm::vec4 color = glm::vec4(1);

  void line(const glm::dvec3& from, const glm::dvec3& to) {
    out_.push_back({glm::vec3(from - origin_), width, glm::vec3(to - origin_), hidden, color});
  }
  void dot(const glm::dvec3& at, float pixels) {
    out_.push_back({glm::vec3(at - origin_), pixels, glm::vec3(at - origin_), hidden, color});
  }
  void path(const std::vector<glm::dvec3>& points, bool closed) {
    for (size_t i = 0; i + 1 < points.size(); ++i) line(points[i], points[i + 1]);
    if (closed) line(points.back(), points.front());
  }
  // Radii as vectors.
  void circle(const glm::dvec3& center, const glm::dvec3& u, const glm::dvec3& v) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i < circleSteps; ++i) {
      const double angle = 2 * pi * i / circleSteps;
      points.push_back(center + std::cos(angle) * u + std::sin(angle) * v);
    }
    path(points, true);
  }
  void sphere(const glm::dvec3& center, double radius) {
    const glm::dvec3 x(radius, 0, 0), y(0, radius, 0), z(0, 0, radius);
    circle(center, x, y), circle(center, y, z), circle(center, z, x);
  }
  // Its head takes a tenth of it.
  void arrow(const glm::dvec3& from, const glm::dvec3& to) {
    line(from, to);
    const glm::dvec3 back = (from - to) * 0.12;
    const auto [u, v] = across(back);
    const double wide = glm::length(back) * 0.4;
    for (const glm::dvec3& side : {u, -u, v, -v}) line(to, to + back + side * wide);
  }
  void box(const scene::Bounds& b) {
    const auto corner = [&](int i) {
      return glm::dvec3(i & 1 ? b.max.x : b.min.x, i & 2 ? b.max.y : b.min.y, i & 4 ? b.max.z : b.min.z);
    };
    for (int i = 0; i < 8; ++i)
      for (int axis = 1; axis < 8; axis *= 2)
        if (!(i & axis)) line(corner(i), corner(i | axis));
  }

  // Two unit vectors at right angles to it and to each other.
  static std::pair<glm::dvec3, glm::dvec3> across(const glm::dvec3& direction) {
    const glm::dvec3 d = glm::normalize(direction);
    const glm::dvec3 u = glm::normalize(glm::cross(d, std::abs(d.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0)));
    return {u, glm::cross(d, u)};
  }

 private:
  glm::dvec3 origin_;
  std::vector<OverlayLine>& out_;
};

// Of the scene; 1 m where it draws nothing or a point.
double sceneRadius(const DrawList& list) {
  const double radius = list.bounds.radius();
  return radius > 0 ? radius : 1;
}
glm::dvec3 sceneCenter(const DrawList& list) { return list.bounds.empty() ? list.origin : list.bounds.center(); }

// Calls with each draw and its primitive where an instance is: positions from the list's origin.
template <class See>
void forEachShape(const DrawList& list, const See& see) {
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws)
      for (uint32_t i = draw.firstInstance; i < draw.firstInstance + draw.instanceCount; ++i)
        see(draw, placedShape(list, draw, list.instances[i]));
}

using Edge = std::pair<uint32_t, uint32_t>;
// Each once: seams of normals and texture coordinates, and what has no indices, have several vertices at a place.
std::vector<Edge> edgesOf(const scene::Primitive& p) {
  const std::vector<uint32_t> first = scene::weld(p.positions.size(), [&](size_t v) {
    const glm::vec3& at = p.positions[v];
    return std::array{scene::floatBits(at.x), scene::floatBits(at.y), scene::floatBits(at.z)};
  });
  std::vector<Edge> edges;
  const size_t count = scene::triangleCount(p);
  edges.reserve(3 * count);
  for (size_t t = 0; t < count; ++t) {
    const std::array<uint32_t, 3> v = scene::triangleVertices(p, t);
    for (size_t k = 0; k < 3; ++k)
      if (const Edge edge = std::minmax(first[v[k]], first[v[(k + 1) % 3]]); edge.first != edge.second)
        edges.push_back(edge);
  }
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// Of all that is drawn: instances share them.
using EdgesOf = std::map<const scene::Primitive*, std::vector<Edge>>;
EdgesOf edgesOf(const DrawList& list) {
  EdgesOf edges;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws)
      if (const auto [found, fresh] = edges.try_emplace(draw.primitive); fresh)
        found->second = edgesOf(*draw.primitive);
  return edges;
}

// For so many lines of each instance of a primitive.
template <class LinesOf>
bool room(const std::vector<OverlayLine>& out, const DrawList& list, const LinesOf& linesOf) {
  size_t all = out.size();
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws) all += linesOf(*draw.primitive) * draw.instanceCount;
  return all <= mostOverlayLines;
}

// False: there are too many.
bool addWireframe(const DrawList& list, std::vector<OverlayLine>& out) {
  const EdgesOf edges = edgesOf(list);
  if (!room(out, list, [&](const scene::Primitive& p) { return edges.at(&p).size(); })) return false;
  forEachShape(list, [&](const Draw& draw, const scene::Primitive& shape) {
    for (const auto& [a, b] : edges.at(draw.primitive))
      out.push_back({shape.positions[a], 1.25f, shape.positions[b], 0, wireColor});
  });
  return true;
}

// Infinite where there are none.
double meanEdge(const scene::Primitive& shape, const std::vector<Edge>& edges) {
  double sum = 0;
  for (const auto& [a, b] : edges) sum += double{glm::length(shape.positions[a] - shape.positions[b])};
  return edges.empty() ? std::numeric_limits<double>::infinity() : sum / static_cast<double>(edges.size());
}

// As long as the shape's edges, so that neighbours can be told apart, and no longer than what fits the scene. False:
// there are too many.
bool addNormals(const DrawList& list, std::vector<OverlayLine>& out) {
  if (!room(out, list, [](const scene::Primitive& p) { return p.normals.size(); })) return false;
  const EdgesOf edges = edgesOf(list);
  forEachShape(list, [&](const Draw& draw, const scene::Primitive& shape) {
    if (shape.normals.empty()) return;
    const auto length =
        static_cast<float>(std::min(0.03 * sceneRadius(list), meanEdge(shape, edges.at(draw.primitive))));
    for (size_t v = 0; v < shape.normals.size(); ++v)
      out.push_back({shape.positions[v], 1.25f, shape.positions[v] + length * shape.normals[v], 0, normalColor});
  });
  return true;
}

void addBounds(Pen pen, const DrawList& list) {
  constexpr size_t mostParts = 4096;
  pen.color = partColor, pen.width = 1;
  if (list.instanceBounds.size() <= mostParts)
    for (const scene::Bounds& part : list.instanceBounds)
      if (!part.empty()) pen.box(part);
  pen.color = boxColor, pen.width = 1.5f;
  if (!list.bounds.empty()) pen.box(list.bounds);
}

// Upright, half as high as `size` on both sides of its middle; it faces who looks from +X, +Y and +Z.
void addLetter(Pen& pen, char letter, const glm::dvec3& middle, double size) {
  const glm::dvec3 front = glm::normalize(glm::dvec3(1)), right = glm::normalize(glm::cross({0, 1, 0}, front));
  const glm::dvec3 up = glm::cross(front, right);
  const auto at = [&](double x, double y) { return middle + size * (0.7 * x * right + y * up); };
  const auto stroke = [&](double x0, double y0, double x1, double y1) { pen.line(at(x0, y0), at(x1, y1)); };
  if (letter == 'X') stroke(-1, -1, 1, 1), stroke(-1, 1, 1, -1);
  if (letter == 'Y') stroke(-1, 1, 0, 0), stroke(1, 1, 0, 0), stroke(0, 0, 0, -1);
  if (letter == 'Z') stroke(-1, 1, 1, 1), stroke(1, 1, -1, -1), stroke(-1, -1, 1, -1);
}

// The world's, at its origin; at the scene's centre where that is far away.
void addAxes(Pen pen, const DrawList& list) {
  const double radius = sceneRadius(list);
  const glm::dvec3 center = sceneCenter(list);
  const glm::dvec3 at = glm::length(center) <= 4 * radius ? glm::dvec3(0) : center;
  pen.width = 2.5f, pen.hidden = 0.35f;
  const double length = 1.2 * radius;
  const std::array<glm::vec4, 3> colors = {red, green, blue};
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 tip(0);
    tip[axis] = length;
    pen.color = colors[static_cast<size_t>(axis)];
    pen.arrow(at, at + tip);
    addLetter(pen, "XYZ"[axis], at + 1.1 * tip, 0.05 * radius);
  }
}

// Below the scene, at whole multiples of its spacing; every tenth line is stronger, the world's axes have their
// colours.
double addGrid(Pen pen, const DrawList& list) {
  const double radius = sceneRadius(list), spacing = gridSpacing(4 * radius);
  const glm::dvec3 center = sceneCenter(list);
  const double y = list.bounds.empty() ? 0 : list.bounds.min.y;
  // So far away that doubles hold no whole multiples: there are none to be drawn.
  const auto whole = [](double multiple) {
    return std::abs(multiple) < 1e15 ? static_cast<int64_t>(multiple) : int64_t{0};
  };
  const auto firstOf = [&](double c) { return whole(std::floor((c - 2 * radius) / spacing)); };
  const auto lastOf = [&](double c) { return whole(std::ceil((c + 2 * radius) / spacing)); };
  const int64_t x0 = firstOf(center.x), x1 = lastOf(center.x), z0 = firstOf(center.z), z1 = lastOf(center.z);
  pen.hidden = 0;
  const auto ink = [&](int64_t i, const glm::vec4& axis) {
    pen.width = i % 10 == 0 ? 1.5f : 1;
    pen.color = i == 0 ? faded(axis, 0.9f) : glm::vec4(0.6f, 0.6f, 0.6f, i % 10 == 0 ? 0.85f : 0.45f);
  };
  const auto at = [&](int64_t x, int64_t z) {
    return glm::dvec3(static_cast<double>(x) * spacing, y, static_cast<double>(z) * spacing);
  };
  for (int64_t x = x0; x <= x1; ++x) ink(x, blue), pen.line(at(x, z0), at(x, z1));
  for (int64_t z = z0; z <= z1; ++z) ink(z, red), pen.line(at(x0, z), at(x1, z));
  return spacing;
}

// Where the joints of a skin are, from the matrices that move its vertices.
std::vector<glm::dvec3> jointPositions(const scene::Skin& skin, const std::vector<glm::dmat4>& worldFromMesh) {
  std::vector<glm::dvec3> positions;
  for (size_t j = 0; j < worldFromMesh.size(); ++j) {
    const glm::dmat4 bind = j < skin.inverseBindMatrices.size() ? skin.inverseBindMatrices[j] : glm::dmat4(1);
    const bool turnsBack = std::abs(glm::determinant(glm::dmat3(bind))) > 0;
    positions.emplace_back(worldFromMesh[j] * (turnsBack ? glm::inverse(bind)[3] : glm::dvec4(0, 0, 0, 1)));
  }
  return positions;
}

void addSkeletons(Pen pen, const OverlayScene& of, const scene::FlatScene& flat) {
  for (size_t s = 0; s < flat.joints.size(); ++s) {
    if (flat.joints[s].empty()) continue;
    const scene::Skin& skin = of.model.skins[s];
    const std::vector<glm::dvec3> at = jointPositions(skin, flat.joints[s]);
    std::map<int, size_t> joint;  // by node
    for (size_t j = 0; j < at.size(); ++j) joint.emplace(skin.joints[j], j);
    const auto parentJoint = [&](int node) {
      for (node = of.model.nodes[static_cast<size_t>(node)].parent; node >= 0;
           node = of.model.nodes[static_cast<size_t>(node)].parent)
        if (const auto found = joint.find(node); found != joint.end()) return static_cast<int>(found->second);
      return -1;
    };
    pen.hidden = 0.7f, pen.width = 3, pen.color = boneColor;
    for (size_t j = 0; j < at.size(); ++j)
      if (const int parent = parentJoint(skin.joints[j]); parent >= 0) pen.line(at[static_cast<size_t>(parent)], at[j]);
    pen.color = jointColor;
    for (const glm::dvec3& position : at) pen.dot(position, 6);
  }
}

// The edges that the joint moves, in false colours: its share of each, mean of both ends. False: there are too many.
bool addInfluence(const OverlayScene& of, std::vector<OverlayLine>& out) {
  if (of.joint < 0) return true;
  const EdgesOf edges = edgesOf(of.list);
  if (!room(out, of.list, [&](const scene::Primitive& p) { return p.influences.empty() ? 0 : edges.at(&p).size(); }))
    return false;
  for (const std::vector<Draw>* draws : of.list.classes())
    for (const Draw& draw : *draws)
      for (uint32_t i = draw.firstInstance; i < draw.firstInstance + draw.instanceCount; ++i) {
        const scene::Primitive& p = *draw.primitive;
        const int skin = of.model.nodes[static_cast<size_t>(of.list.instanceNodes[i])].skin;
        if (skin < 0 || p.influences.empty()) continue;
        const std::vector<int>& joints = of.model.skins[static_cast<size_t>(skin)].joints;
        const auto joint = static_cast<size_t>(std::ranges::find(joints, of.joint) - joints.begin());
        if (joint == joints.size()) continue;
        const scene::Primitive shape = placedShape(of.list, draw, of.list.instances[i]);
        const auto share = [&](uint32_t vertex) {
          const auto count = static_cast<size_t>(p.influencesPerVertex);
          double sum = 0;
          for (const scene::Influence& influence : std::span(p.influences).subspan(vertex * count, count))
            if (influence.joint == joint) sum += double{influence.weight};
          return sum;
        };
        for (const auto& [a, b] : edges.at(&p))
          if (const double mean = 0.5 * (share(a) + share(b)); mean > 0)
            out.push_back({shape.positions[a], 2, shape.positions[b], 0,
                           glm::vec4(glm::vec3(optics::falseColor(std::min(mean, 1.0))), 1)});
      }
  return true;
}

glm::vec4 lightColor(const glm::vec4& color) {
  const float most = std::max({color.r, color.g, color.b, 1e-30f});
  return {glm::mix(glm::vec3(0.25f), glm::vec3(1), glm::vec3(color) / most), 1};
}

// A spot's cone of that half angle, from its tip.
void addCone(Pen& pen, const glm::dvec3& tip, const glm::dvec3& axis, double angle, double length, int sides) {
  const auto [u, v] = Pen::across(axis);
  const double side = std::sin(angle) * length;
  const glm::dvec3 middle = tip + axis * (std::cos(angle) * length);
  pen.circle(middle, u * side, v * side);
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * pi * i / sides;
    pen.line(tip, middle + (std::cos(turn) * u + std::sin(turn) * v) * side);
  }
}

// Candela over the direction, in the planes through its aim that hold its +X and its +Y.
void addProfile(Pen& pen, const glm::dvec3& tip, const layout::LightUniforms& light,
                const optics::LightProfile& profile, double length) {
  constexpr int steps = 180;
  const glm::dvec3 aim(light.direction), x(light.profile);
  const glm::dvec3 y = glm::cross(x, aim) * (light.profile.w < 0 ? -1.0 : 1.0);
  const double scale = length / std::max(double{profile.mostCandela}, 1e-30);
  for (const glm::dvec3& side : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0)}) {
    glm::dvec3 before(0);
    for (int i = 0; i <= steps; ++i) {
      const double angle = 2 * pi * i / steps;
      const glm::dvec3 d = std::sin(angle) * side - glm::dvec3(0, 0, std::cos(angle));
      const glm::dvec3 at = tip + (d.x * x + d.y * y - d.z * aim) * (optics::candela(profile, d) * scale);
      if (i > 0) pen.line(before, at);
      before = at;
    }
  }
}

void addLights(Pen pen, const DrawList& list) {
  const double radius = sceneRadius(list);
  const glm::dvec3 center = sceneCenter(list);
  for (size_t i = 0; i < list.lights.size(); ++i) {
    const layout::LightUniforms& light = list.lights[i];
    const glm::dvec3 position = glm::dvec3(light.position) + list.origin, direction(light.direction);
    pen.color = lightColor(light.color), pen.width = 1.5f, pen.hidden = 0.35f;
    const double range = light.direction.w > 0 ? 1 / std::sqrt(double{light.direction.w}) : 0;
    if (light.position.w > 2.5f) continue;  // the environment's
    if (light.position.w < 0.5f) {
      const auto [u, v] = Pen::across(direction);
      const glm::dvec3 from = center - direction * (1.7 * radius);
      pen.circle(from, u * (0.12 * radius), v * (0.12 * radius));
      for (const glm::dvec3& side : {glm::dvec3(0), u, -u, v, -v})
        pen.arrow(from + side * (0.12 * radius), from + side * (0.12 * radius) + direction * (0.5 * radius));
      continue;
    }
    pen.dot(position, 9);
    if (i < list.profiles.size() && list.profiles[i]) {
      addProfile(pen, position, light, *list.profiles[i], 0.25 * radius);
      continue;
    }
    if (light.position.w < 1.5f) {
      pen.sphere(position, 0.04 * radius);
      if (range > 0) pen.color = faded(pen.color, 0.5f), pen.width = 1, pen.sphere(position, range);
      continue;
    }
    // KHR_lights_punctual: scale 1 / (cos inner - cos outer), offset - cos outer scale.
    const double scale = light.cone.x, outer = -double{light.cone.y} / scale, inner = outer + 1 / scale;
    const double length = range > 0 ? range : radius;
    addCone(pen, position, direction, std::acos(std::clamp(outer, -1.0, 1.0)), length, 8);
    pen.color = faded(pen.color, 0.5f), pen.width = 1;
    addCone(pen, position, direction, std::acos(std::clamp(inner, -1.0, 1.0)), length, 0);
  }
}

void addCameras(Pen pen, const OverlayScene& of) {
  const double radius = sceneRadius(of.list);
  pen.color = cameraColor;
  for (const FileCamera& camera : of.list.cameras) {
    const scene::Camera& lens = camera.lens;
    const double aspect = lens.aspectRatio > 0 ? lens.aspectRatio : of.aspect;
    const scene::View view = scene::cameraView(lens, camera.placed.worldFromNode, aspect, of.list.bounds);
    const double far = std::min(lens.zFar, 0.4 * radius), near = std::min(std::max(lens.zNear, 0.0), 0.5 * far);
    const auto corners = [&](double distance) {
      const double y = lens.perspective ? std::tan(lens.fovY / 2) * distance : lens.yMag;
      const double x = lens.perspective ? y * aspect : lens.xMag;
      const glm::dvec3 middle = view.eye + view.forward * distance, right = view.right * x, up = view.up * y;
      return std::vector<glm::dvec3>{middle - right - up, middle + right - up, middle + right + up,
                                     middle - right + up};
    };
    const std::vector<glm::dvec3> fars = corners(far), nears = corners(near);
    pen.path(fars, true), pen.path(nears, true);
    for (size_t i = 0; i < fars.size(); ++i) pen.line(lens.perspective ? view.eye : nears[i], fars[i]);
    const glm::dvec3 top = (fars[2] + fars[3]) * 0.5 + (fars[3] - fars[0]) * 0.25;  // which way is up
    pen.path({fars[2] * 0.75 + fars[3] * 0.25, top, fars[2] * 0.25 + fars[3] * 0.75}, false);
    pen.dot(view.eye, 7);
  }
}

void addSun(Pen pen, const OverlayScene& of) {
  if (!of.sun) return;
  const double angle = of.environmentRotationDeg * pi / 180, c = std::cos(angle), s = std::sin(angle);
  const glm::dvec3 d = of.sun->direction;
  const glm::dvec3 towards(c * d.x + s * d.z, d.y, c * d.z - s * d.x);  // worldFromEnvironment of frame.glsl
  const double radius = sceneRadius(of.list);
  const glm::dvec3 at = sceneCenter(of.list) + towards * (1.7 * radius);
  const auto [u, v] = Pen::across(towards);
  pen.color = sunColor, pen.width = 2;
  pen.circle(at, u * (0.1 * radius), v * (0.1 * radius));
  for (int i = 0; i < 8; ++i) {
    const glm::dvec3 out = std::cos(pi * i / 4) * u + std::sin(pi * i / 4) * v;
    pen.line(at + out * (0.13 * radius), at + out * (0.19 * radius));
  }
  pen.arrow(at, at - towards * (0.6 * radius));
}

}  // namespace

double gridSpacing(double length) {
  const double decade = std::pow(10, std::floor(std::log10(length / 20)));
  for (const double step : {1.0, 2.0, 5.0})
    if (length / (step * decade) <= 20 * (1 + 1e-9)) return step * decade;
  return 10 * decade;
}

Result<OverlayLines> overlayLines(const OverlayScene& of, const Placement& placement, const Overlays& overlays) {
  OverlayLines out;
  const Pen pen(of.list, out.lines);
  using enum Overlay;
  std::optional<scene::Pose> pose;
  if (overlays.has(skeleton)) {
    Result<scene::Pose> chosen = choosePose(placement, of.model);
    if (!chosen) return tl::unexpected(chosen.error());
    pose = std::move(*chosen);
  }
  std::string nothing, tooMuch;
  // add: false where there are too many lines.
  const auto draw = [&](Overlay overlay, const auto& add) {
    if (!overlays.has(overlay)) return;
    const size_t before = out.lines.size();
    const auto append = [&](std::string& to) {
      to += (to.empty() ? "" : ", ") + std::string(rowOf(overlayChoices, overlay).label);
    };
    if (!add())
      append(tooMuch);
    else if (out.lines.size() == before)
      append(nothing);
  };
  draw(grid, [&] { return out.gridSpacing = addGrid(pen, of.list), true; });
  draw(wireframe, [&] { return addWireframe(of.list, out.lines); });
  draw(normals, [&] { return addNormals(of.list, out.lines); });
  draw(bounds, [&] { return addBounds(pen, of.list), true; });
  draw(skeleton, [&] {
    const bool room = addInfluence(of, out.lines);
    addSkeletons(pen, of, scene::flatten(of.model, of.scene, *pose));
    return room;
  });
  draw(lights, [&] { return addLights(pen, of.list), true; });
  draw(cameras, [&] { return addCameras(pen, of), true; });
  draw(sun, [&] { return addSun(pen, of), true; });
  draw(axes, [&] { return addAxes(pen, of.list), true; });
  if (!nothing.empty()) out.remark = "there is nothing to show of: " + nothing;
  if (!tooMuch.empty())
    out.remark += (nothing.empty() ? "" : "; ") + ("not shown, having more than " + std::to_string(mostOverlayLines)) +
                  " lines: " + tooMuch;
  return out;
}

}  // namespace facet::frame
