#include "scene/tangents.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>

#include "scene/geometry.hpp"
#include "scene/weld.hpp"

namespace facet::scene {

namespace {

constexpr uint32_t none = 0xffffffffu;

struct Face {
  glm::dvec3 s = glm::dvec3(0), t = glm::dvec3(0);  // unit directions of growing u and v on the face (or 0)
  double length = 0;                                // of the position's derivative by u
  bool preserves = false;                           // texture not mirrored
  bool anyGroup = true;                             // no area in texture space: has no say, joins its neighbours
  bool degenerate = false;                          // no area: two corners in one place
};

// Corners of one welded vertex that share a tangent: faces connected over edges, of one orientation.
struct Group {
  uint32_t vertex = 0;
  bool preserves = false;
  size_t begin = 0, end = 0;  // in Builder::members
};

struct Builder {
  const Primitive& p;
  const std::vector<glm::vec2>& uv;
  size_t faceCount;
  std::vector<uint32_t> vertex = {};  // per corner: welded by position, normal, uv
  std::vector<Face> faces = {};
  std::vector<uint32_t> neighbour = {};  // per corner: the face behind the edge to the next corner
  std::vector<uint32_t> groupOf = {};    // per corner
  std::vector<Group> groups = {};
  std::vector<uint32_t> members = {};  // corners, group after group

  uint32_t source(size_t corner) const { return p.indices.empty() ? uint32_t(corner) : p.indices[corner]; }
  glm::dvec3 position(size_t corner) const { return p.positions[source(corner)]; }
};

uint32_t next(uint32_t corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
uint32_t previous(uint32_t corner) { return corner % 3 == 0 ? corner + 2 : corner - 1; }

void weldCorners(Builder& b) {
  const auto keyOf = [&](size_t i) {
    const glm::vec3 &x = b.p.positions[i], &n = b.p.normals[i];
    return std::array{floatBits(x.x), floatBits(x.y), floatBits(x.z),       floatBits(n.x),
                      floatBits(n.y), floatBits(n.z), floatBits(b.uv[i].x), floatBits(b.uv[i].y)};
  };
  const std::vector<uint32_t> first = weld(b.p.positions.size(), keyOf);
  b.vertex.resize(3 * b.faceCount);
  for (size_t c = 0; c < b.vertex.size(); ++c) b.vertex[c] = first[b.source(c)];
}

glm::dvec3 unitOrZero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

// First-order derivatives of the position over the texture (thesis, section 2.1): with edges d1, d2 and their texture
// edges a, b:  area ds = b.v d1 - a.v d2,  area dt = -b.u d1 + a.u d2,  area = a.u b.v - a.v b.u.
// The sign of the area is taken in single precision, as bakers do: for slivers in texture space it decides about
// groups.
Face makeFace(const Builder& b, size_t f) {
  Face face;
  const size_t c = 3 * f;
  const glm::vec3 &x0 = b.p.positions[b.source(c)], &x1 = b.p.positions[b.source(c + 1)],
                  &x2 = b.p.positions[b.source(c + 2)];
  if (x0 == x1 || x1 == x2 || x2 == x0) {
    face.degenerate = true;
    return face;
  }
  const glm::vec2 a = b.uv[b.source(c + 1)] - b.uv[b.source(c)], e = b.uv[b.source(c + 2)] - b.uv[b.source(c)];
  const glm::dvec3 d1 = glm::dvec3(x1) - glm::dvec3(x0), d2 = glm::dvec3(x2) - glm::dvec3(x0);
  const float left = a.x * e.y, right = a.y * e.x;
  const float area = left - right;
  face.preserves = area > 0;
  if (!(std::abs(area) > FLT_MIN)) return face;
  const double sign = face.preserves ? 1 : -1;
  const glm::dvec3 s = d1 * double(e.y) - d2 * double(a.y);
  face.length = glm::length(s) / std::abs(double(area));
  face.s = unitOrZero(s) * sign;
  face.t = unitOrZero(d2 * double(a.x) - d1 * double(e.x)) * sign;
  face.anyGroup = face.s == glm::dvec3(0) || face.t == glm::dvec3(0);
  return face;
}

// Pairs each edge with the next one, in the order of faces, that runs the other way between the same welded vertices.
void connectFaces(Builder& b) {
  struct Edge {
    uint32_t high, corner;
  };
  const auto forEachEdge = [&](const auto& use) {
    for (uint32_t c = 0; c < b.vertex.size(); ++c)
      if (!b.faces[c / 3].degenerate)
        use(c, std::min(b.vertex[c], b.vertex[next(c)]), std::max(b.vertex[c], b.vertex[next(c)]));
  };
  std::vector<uint32_t> end(b.p.positions.size() + 1, 0);  // counting sort by the lower vertex
  forEachEdge([&](uint32_t, uint32_t low, uint32_t) { ++end[low + 1]; });
  for (size_t i = 1; i < end.size(); ++i) end[i] += end[i - 1];
  std::vector<Edge> edges(end.back());
  forEachEdge([&](uint32_t c, uint32_t low, uint32_t high) { edges[end[low]++] = {high, c}; });

  b.neighbour.assign(b.vertex.size(), none);
  size_t begin = 0;
  for (size_t low = 0; low + 1 < end.size(); begin = end[low++]) {
    std::sort(edges.begin() + long(begin), edges.begin() + long(end[low]),
              [](const Edge& x, const Edge& y) { return x.high != y.high ? x.high < y.high : x.corner < y.corner; });
    size_t waiting = begin;  // oldest edge without partner; all between it and e that have none run the same way
    for (size_t e = begin; e < end[low]; ++e) {
      while (waiting < e && (edges[waiting].high != edges[e].high || b.neighbour[edges[waiting].corner] != none))
        ++waiting;
      const uint32_t x = edges[waiting].corner, y = edges[e].corner;
      if (waiting == e || b.vertex[x] == b.vertex[y]) continue;  // same start: same way
      b.neighbour[x] = y / 3;
      b.neighbour[y] = x / 3;
    }
  }
}

// Spreads the group from a face over its two edges at the group's vertex, depth first. A face without say takes the
// orientation of the first group that reaches it.
void growGroup(Builder& b, uint32_t start, std::vector<uint32_t>& open) {
  const auto id = uint32_t(b.groups.size());
  Group group{b.vertex[start], b.faces[start / 3].preserves, b.members.size(), 0};
  open.assign(1, start / 3);
  while (!open.empty()) {
    const uint32_t f = open.back();
    open.pop_back();
    uint32_t c = 3 * f;
    while (b.vertex[c] != group.vertex) ++c;  // two faces share an edge, so the vertex is among the three
    if (b.groupOf[c] != none) continue;
    Face& face = b.faces[f];
    const bool untouched = b.groupOf[3 * f] == none && b.groupOf[3 * f + 1] == none && b.groupOf[3 * f + 2] == none;
    if (face.anyGroup && untouched) face.preserves = group.preserves;
    if (face.preserves != group.preserves) continue;
    b.groupOf[c] = id;
    b.members.push_back(c);
    for (const uint32_t over : {b.neighbour[previous(c)], b.neighbour[c]})
      if (over != none) open.push_back(over);
  }
  group.end = b.members.size();
  b.groups.push_back(group);
}

void buildGroups(Builder& b) {
  b.groupOf.assign(b.vertex.size(), none);
  b.members.reserve(b.vertex.size());
  std::vector<uint32_t> open;
  for (uint32_t c = 0; c < b.vertex.size(); ++c)
    if (!b.faces[c / 3].degenerate && !b.faces[c / 3].anyGroup && b.groupOf[c] == none) growGroup(b, c, open);
}

// Direction of v in the plane of the unit vector n; 0 where v is perpendicular to the plane up to rounding.
glm::dvec3 inPlane(const glm::dvec3& v, const glm::dvec3& n) {
  const glm::dvec3 projected = v - n * glm::dot(n, v);
  return glm::length(projected) > 1e-12 * glm::length(v) ? glm::normalize(projected) : glm::dvec3(0);
}

// Unit, perpendicular to n; +X where that is possible.
glm::vec3 anyTangent(const glm::vec3& normal) {
  const glm::dvec3 n = unitOrZero(normal);
  const glm::dvec3 t = inPlane(std::abs(n.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), n);
  return t == glm::dvec3(0) ? glm::vec3(1, 0, 0) : glm::vec3(t);
}

struct Tangent {
  glm::vec4 tangent = glm::vec4(0);
  double length = 0;  // mean of the position's derivatives by u; 0 where no triangle has a say
};

// Mean of the faces' directions in the vertex' tangent plane, weighted by the corner's angle in that plane.
Tangent groupTangent(const Builder& b, const Group& group) {
  const glm::dvec3 n = unitOrZero(b.p.normals[group.vertex]);  // unit in double precision too
  glm::dvec3 sum(0);
  double angles = 0, lengths = 0;
  for (size_t m = group.begin; m < group.end; ++m) {
    const uint32_t c = b.members[m];
    const Face& face = b.faces[c / 3];
    if (face.anyGroup) continue;
    const glm::dvec3 here = b.position(c);
    const glm::dvec3 e1 = inPlane(b.position(previous(c)) - here, n), e2 = inPlane(b.position(next(c)) - here, n);
    const double angle = std::acos(std::clamp(glm::dot(e1, e2), -1.0, 1.0));
    sum += inPlane(face.s, n) * angle;
    angles += angle;
    lengths += face.length * angle;
  }
  // Directions that cancel leave rounding, which points anywhere.
  const glm::dvec3 tangent = glm::length(sum) > 1e-9 * angles ? inPlane(sum, n) : glm::dvec3(0);
  return {glm::vec4(tangent == glm::dvec3(0) ? anyTangent(n) : glm::vec3(tangent), group.preserves ? -1.0f : 1.0f),
          angles > 0 ? lengths / angles : 0};
}

// By corner.
std::vector<Tangent> tangentsOf(const Builder& b) {
  std::vector<Tangent> ofGroup(b.groups.size());
  for (size_t g = 0; g < ofGroup.size(); ++g) ofGroup[g] = groupTangent(b, b.groups[g]);

  // What triangles without area inherit: the first good corner of the same vertex.
  std::vector<uint32_t> firstGood(b.p.positions.size(), none);
  for (uint32_t c = 0; c < b.vertex.size(); ++c)
    if (!b.faces[c / 3].degenerate && firstGood[b.vertex[c]] == none) firstGood[b.vertex[c]] = c;

  std::vector<Tangent> tangents(b.vertex.size());
  for (uint32_t c = 0; c < tangents.size(); ++c) {
    const uint32_t from = b.faces[c / 3].degenerate ? firstGood[b.vertex[c]] : c;
    const uint32_t g = from == none ? none : b.groupOf[from];
    tangents[c] = g == none ? Tangent{glm::vec4(anyTangent(b.p.normals[b.vertex[c]]), 1)} : ofGroup[g];
  }
  return tangents;
}

// The arrays that are being made.
struct Arrays {
  std::vector<glm::vec4> Primitive::*tangents;
  std::vector<glm::vec3> MorphTarget::*differences;
};
Arrays arraysOf(TangentsOf which) {
  if (which == TangentsOf::coat) return {&Primitive::coatTangents, &MorphTarget::coatTangents};
  if (which == TangentsOf::grain) return {&Primitive::grainTangents, &MorphTarget::grainTangents};
  return {&Primitive::tangents, &MorphTarget::tangents};
}

// One attribute as words of 32 bits.
struct Column {
  const uint8_t* data;
  size_t words;  // per vertex

  uint32_t word(size_t vertex, size_t i) const {
    uint32_t w;
    std::memcpy(&w, data + 4 * (vertex * words + i), 4);
    return w == 0x80000000u ? 0 : w;  // -0 is 0
  }
};

std::vector<Column> columnsOf(const Primitive& p) {
  std::vector<Column> columns;
  const auto add = [&](const auto& values, size_t per = 1) {
    if (!values.empty())
      columns.push_back({reinterpret_cast<const uint8_t*>(values.data()), per * sizeof(values[0]) / 4});
  };
  add(p.positions);
  add(p.normals);
  for (const auto* tangents : {&p.tangents, &p.coatTangents, &p.grainTangents}) add(*tangents);
  for (const std::vector<glm::vec2>& set : p.texCoords) add(set);
  add(p.colors);
  add(p.influences, size_t(p.influencesPerVertex));
  for (const MorphTarget& target : p.targets) {
    add(target.positions);
    add(target.normals);
    for (const auto* tangents : {&target.tangents, &target.coatTangents, &target.grainTangents}) add(*tangents);
    for (const std::vector<glm::vec2>& set : target.texCoords) add(set);
    add(target.colors);
  }
  return columns;
}

// Source vertices that agree in everything.
std::vector<uint32_t> weldAll(const Primitive& p) {
  const std::vector<Column> columns = columnsOf(p);
  const auto hashOf = [&](size_t v) {
    uint64_t hash = 0;
    for (const Column& column : columns)
      for (size_t i = 0; i < column.words; ++i) hash = mixedHash(hash, column.word(v, i));
    return hash;
  };
  const auto equal = [&](size_t v, size_t w) {
    for (const Column& column : columns)
      for (size_t i = 0; i < column.words; ++i)
        if (column.word(v, i) != column.word(w, i)) return false;
    return true;
  };
  return weld(p.positions.size(), hashOf, equal);
}

std::vector<Tangent> cornerTangents(const Primitive& list, const std::vector<glm::vec2>& uv) {
  const size_t cornerCount = list.indices.empty() ? list.positions.size() : list.indices.size();
  Builder b{list, uv, cornerCount / 3};
  weldCorners(b);
  b.faces.resize(b.faceCount);
  for (size_t f = 0; f < b.faceCount; ++f) b.faces[f] = makeFace(b, f);
  connectFaces(b);
  buildGroups(b);
  return tangentsOf(b);
}

// Positions, normals and indices of the list where this target alone has a weight of 1.
Primitive posed(const Primitive& list, const MorphTarget& target) {
  Primitive p;
  p.positions = list.positions;
  p.normals = list.normals;
  p.indices = list.indices;
  for (size_t v = 0; v < target.positions.size(); ++v) p.positions[v] += target.positions[v];
  for (size_t v = 0; v < target.normals.size(); ++v) {
    const glm::dvec3 normal = unitOrZero(glm::dvec3(p.normals[v]) + glm::dvec3(target.normals[v]));
    if (normal != glm::dvec3(0)) p.normals[v] = normal;
  }
  if (!list.flatNormals) return p;
  for (size_t v = 0; v + 2 < p.positions.size(); v += 3) {  // unwelded
    const glm::dvec3 a = p.positions[v], b = p.positions[v + 1], c = p.positions[v + 2];
    const glm::dvec3 normal = unitOrZero(glm::cross(b - a, c - a));
    if (normal != glm::dvec3(0)) p.normals[v] = p.normals[v + 1] = p.normals[v + 2] = normal;
  }
  return p;
}

// By corner: what a weight of 1 adds to the tangent. The derivative of the position by u is linear in the weights, so
// tangents at rest and at the target count with the lengths that it has there: between them the sum keeps its direction
// exactly where the target turns, stretches or shears a neighbourhood as a whole. Empty where nothing turns. uv: at the
// target; where it moves, tangents are exact there and at rest, and between them nearly.
std::vector<glm::vec3> tangentDifferences(const Primitive& list, const MorphTarget& target,
                                          const std::vector<glm::vec2>& uv, bool uvMoves,
                                          const std::vector<Tangent>& atRest) {
  if (target.positions.empty() && (target.normals.empty() || list.flatNormals) && !uvMoves) return {};
  const std::vector<Tangent> there = cornerTangents(posed(list, target), uv);
  std::vector<glm::vec3> differences(atRest.size());
  bool any = false;
  for (size_t c = 0; c < differences.size(); ++c) {
    const double ratio = atRest[c].length > 0 ? there[c].length / atRest[c].length : 1;
    const glm::vec3 difference(glm::dvec3(there[c].tangent) * ratio - glm::dvec3(atRest[c].tangent));
    const float sum = difference.x * 0 + difference.y * 0 + difference.z * 0;  // NaN and Inf survive
    differences[c] = sum == 0 ? difference : glm::vec3(0);
    any = any || glm::length(differences[c]) > 1e-6f;
  }
  return any ? differences : std::vector<glm::vec3>();
}

// Corners that agree in everything become one vertex. differences: of each target, empty or by corner.
void reindex(Primitive& p, const Arrays& arrays, const std::vector<Tangent>& tangents,
             const std::vector<std::vector<glm::vec3>>& differences) {
  p.*arrays.tangents = {};
  for (MorphTarget& target : p.targets) target.*arrays.differences = {};
  const auto sourceOf = [&](size_t corner) { return p.indices.empty() ? uint32_t(corner) : p.indices[corner]; };
  std::vector<uint32_t> first;
  {
    const std::vector<uint32_t> canonical = weldAll(p);
    const auto wordsOf = [&](size_t c, const auto& use) {
      const glm::vec4& t = tangents[c].tangent;
      for (const uint32_t word :
           {canonical[sourceOf(c)], floatBits(t.x), floatBits(t.y), floatBits(t.z), floatBits(t.w)})
        use(word);
      for (const std::vector<glm::vec3>& target : differences)
        if (!target.empty())
          for (int i = 0; i < 3; ++i) use(floatBits(target[c][i]));
    };
    const auto hashOf = [&](size_t c) {
      uint64_t hash = 0;
      wordsOf(c, [&](uint32_t word) { hash = mixedHash(hash, word); });
      return hash;
    };
    const auto equal = [&](size_t c, size_t d) {
      const auto same = [&](const std::vector<glm::vec3>& target) { return target.empty() || target[c] == target[d]; };
      return canonical[sourceOf(c)] == canonical[sourceOf(d)] && tangents[c].tangent == tangents[d].tangent &&
             std::ranges::all_of(differences, same);
    };
    first = weld(tangents.size(), hashOf, equal);
  }
  std::vector<uint32_t> indices(tangents.size()), source, corners;
  for (uint32_t c = 0; c < tangents.size(); ++c) {
    if (first[c] != c) {
      indices[c] = indices[first[c]];
      continue;
    }
    indices[c] = uint32_t(source.size());
    source.push_back(sourceOf(c));
    corners.push_back(c);
  }
  gatherVertices(p, source);
  for (const uint32_t c : corners) (p.*arrays.tangents).push_back(tangents[c].tangent);
  for (size_t t = 0; t < differences.size(); ++t)
    if (!differences[t].empty())
      for (const uint32_t c : corners) (p.targets[t].*arrays.differences).push_back(differences[t][c]);
  p.indices = std::move(indices);
}

std::vector<glm::vec2> transformed(std::vector<glm::vec2> uv, const TextureTransform& transform) {
  if (transform == TextureTransform{}) return uv;
  const glm::dmat3x2 matrix = uvFromTexCoord(transform);
  for (glm::vec2& c : uv) c = matrix * glm::dvec3(c, 1);
  return uv;
}

}  // namespace

glm::dmat3x2 uvFromTexCoord(const TextureTransform& t) {
  const double c = std::cos(double(t.rotation)), s = std::sin(double(t.rotation));
  return {{c * t.scale.x, -s * t.scale.x}, {s * t.scale.y, c * t.scale.y}, glm::dvec2(t.offset)};
}

Primitive withTangents(Primitive primitive, int texCoordSet, const TextureTransform& transform, TangentsOf which) {
  if (!hasTriangles(primitive.topology) || primitive.normals.empty() || texCoordSet < 0 ||
      texCoordSet >= maxTexCoordSets || primitive.texCoords[size_t(texCoordSet)].empty())
    return primitive;
  Primitive list = asList(std::move(primitive));
  if (list.positions.empty()) return list;
  const auto set = size_t(texCoordSet);
  const std::vector<glm::vec2> uv = transformed(list.texCoords[set], transform);
  const std::vector<Tangent> tangents = cornerTangents(list, uv);
  std::vector<std::vector<glm::vec3>> differences;
  for (const MorphTarget& target : list.targets) {
    std::vector<glm::vec2> moved = list.texCoords[set];
    for (size_t v = 0; v < target.texCoords[set].size(); ++v) moved[v] += target.texCoords[set][v];
    const bool moves = !target.texCoords[set].empty();
    differences.push_back(
        tangentDifferences(list, target, moves ? transformed(std::move(moved), transform) : uv, moves, tangents));
  }
  reindex(list, arraysOf(which), tangents, differences);
  return list;
}

}  // namespace facet::scene
