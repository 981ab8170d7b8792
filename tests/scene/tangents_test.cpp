#include "scene/tangents.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <random>

#include "base/angle.hpp"
#include "scene/shapes.hpp"
#include "support/skip.hpp"

using facet::pi;
using namespace facet::scene;

namespace {

// Unit square in the plane z = 0 seen from +Z, u to the right and v down as an image has it.
Primitive texturedQuad() {
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  p.normals.assign(4, {0, 0, 1});
  p.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  p.indices = {0, 1, 2, 0, 2, 3};
  p.material = 3;
  return p;
}

Primitive fromShape(const Shape& shape) {
  Primitive p;
  p.positions = shape.positions, p.normals = shape.normals, p.indices = shape.indices;
  p.texCoords[0] = shape.texCoords;
  return p;
}

// Unit, perpendicular to the normal, w = +-1 and finite at every vertex; indices in range.
void checkDefined(const Primitive& p) {
  REQUIRE(p.tangents.size() == p.positions.size());
  double worstLength = 0, worstAngle = 0;
  for (size_t i = 0; i < p.tangents.size(); ++i) {
    const glm::dvec3 t = p.tangents[i];
    REQUIRE(std::isfinite(t.x + t.y + t.z));
    REQUIRE(std::abs(p.tangents[i].w) == 1);
    worstLength = std::max(worstLength, std::abs(glm::length(t) - 1));
    worstAngle = std::max(worstAngle, std::abs(glm::dot(t, glm::dvec3(p.normals[i]))));
  }
  CHECK(worstLength < 1e-6);
  CHECK(worstAngle < 1e-6);
  for (const uint32_t i : p.indices) REQUIRE(i < p.positions.size());
}

glm::vec4 tangentAt(const Primitive& p, size_t corner) { return p.tangents[p.indices[corner]]; }

}  // namespace

TEST_CASE("On a plane the tangent follows u, the bitangent points to smaller v") {
  const Primitive p = withTangents(texturedQuad(), 0);
  CHECK(p.positions.size() == 4);
  CHECK(p.indices == texturedQuad().indices);
  CHECK(p.material == 3);
  for (const glm::vec4& t : p.tangents) {
    CHECK(t == glm::vec4(1, 0, 0, 1));
    CHECK(glm::cross(glm::vec3(0, 0, 1), glm::vec3(t)) * t.w == glm::vec3(0, 1, 0));  // up, as the image's +y
  }
}

TEST_CASE("Turned, stretched and mirrored texture coordinates") {
  struct Row {
    glm::mat2 uvFromXy;  // columns: change of uv along x and y
    glm::vec4 tangent;
  };
  const float s = std::sqrt(0.5f);
  const Row rows[] = {
      {{{1, 0}, {0, -1}}, {1, 0, 0, 1}},            // as the image
      {{{-1, 0}, {0, -1}}, {-1, 0, 0, -1}},         // mirrored in u
      {{{1, 0}, {0, 1}}, {1, 0, 0, -1}},            // mirrored in v
      {{{0, 1}, {1, 0}}, {0, 1, 0, 1}},             // u up, v to the right: turned by 90 degrees
      {{{1e-6f, 0}, {0, -1e6f}}, {1, 0, 0, 1}},     // stretched beyond all measure
      {{{1, 1}, {1, -1}}, {s, s, 0, 1}},            // turned by 45 degrees
      {{{1e-12f, 0}, {0, -1e-12f}}, {1, 0, 0, 1}},  // tiny, but with area
  };
  for (const Row& row : rows) {
    Primitive p = texturedQuad();
    for (size_t i = 0; i < 4; ++i) p.texCoords[0][i] = row.uvFromXy * glm::vec2(p.positions[i]);
    for (const glm::vec4& t : withTangents(p, 0).tangents) CHECK(glm::distance(t, row.tangent) < 1e-6f);
  }
}

TEST_CASE("A mirrored half doesn't share its seam's vertices") {
  // Two squares side by side; the texture of the right one mirrors the left one's at x = 1.
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  p.normals.assign(6, {0, 0, 1});
  p.texCoords[0] = {{0, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {0, 0}};
  p.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  const Primitive out = withTangents(p, 0);
  CHECK(out.positions.size() == 8);
  for (size_t c = 0; c < 6; ++c) CHECK(tangentAt(out, c) == glm::vec4(1, 0, 0, 1));
  for (size_t c = 6; c < 12; ++c) CHECK(tangentAt(out, c) == glm::vec4(-1, 0, 0, -1));
  for (size_t c = 0; c < 12; ++c) CHECK(out.positions[out.indices[c]] == p.positions[p.indices[c]]);
}

TEST_CASE("Corners are welded by what they are, not by their indices") {
  Primitive soup;
  const Primitive indexed = texturedQuad();
  for (const uint32_t i : indexed.indices) {
    soup.positions.push_back(indexed.positions[i]);
    soup.normals.push_back(indexed.normals[i]);
    soup.texCoords[0].push_back(indexed.texCoords[0][i]);
    soup.texCoords[1].push_back(indexed.texCoords[0][i] * 2.0f);
    soup.colors.push_back({float(i), 0, 0, 1});
  }
  soup.positions[3] = {-0.0f, 0, -0.0f};  // the same place
  Primitive out = withTangents(soup, 0);
  CHECK(out.positions.size() == 4);
  CHECK(out.colors[out.indices[5]] == glm::vec4(3, 0, 0, 1));
  CHECK(out.texCoords[1][out.indices[5]] == indexed.texCoords[0][3] * 2.0f);

  soup.colors[3] = {9, 9, 9, 1};  // the other attributes keep corners apart
  out = withTangents(soup, 0);
  CHECK(out.positions.size() == 5);
}

TEST_CASE("Corners with other influences or morph targets stay apart and keep them, all coordinate sets do") {
  Primitive soup;
  const Primitive indexed = texturedQuad();
  soup.influencesPerVertex = 2;
  soup.targets.resize(2);
  soup.variantMaterials = {7};
  for (const uint32_t i : indexed.indices) {
    soup.positions.push_back(indexed.positions[i]);
    soup.normals.push_back(indexed.normals[i]);
    for (std::vector<glm::vec2>& set : soup.texCoords) set.push_back(indexed.texCoords[0][i]);
    soup.colors.push_back({1, 1, 1, 1});
    soup.influences.insert(soup.influences.end(), {{i, 0.5f}, {9, 0.5f}});
    soup.targets[0].positions.push_back({float(i), 0, 0});
    soup.targets[1].colors.push_back({1, 1, float(i), 1});
  }
  Primitive out = withTangents(soup, 3);
  REQUIRE(out.positions.size() == 4);
  CHECK(out.variantMaterials == std::vector<int>{7});
  for (size_t c = 0; c < 6; ++c) {
    const size_t v = out.indices[c];
    CHECK(out.influences.at(2 * v).joint == indexed.indices[c]);
    CHECK(out.influences.at(2 * v + 1).joint == 9);
    CHECK(out.targets[0].positions.at(v).x == float(indexed.indices[c]));
    CHECK(out.targets[1].colors.at(v).z == float(indexed.indices[c]));
    CHECK(out.texCoords[7].at(v) == soup.texCoords[7][c]);
  }
  CHECK(out.targets[0].normals.empty());

  Primitive other = soup;
  other.influences[2 * 3 + 1].joint = 8;
  CHECK(withTangents(other, 0).positions.size() == 5);
  other = soup;
  other.targets[0].positions[3] = {0, 1e-30f, 0};
  CHECK(withTangents(other, 0).positions.size() == 5);
  other = soup;
  other.targets[1].colors[3].a = 0;
  CHECK(withTangents(other, 0).positions.size() == 5);
  other = soup;
  other.texCoords[7][3].x += 1;
  CHECK(withTangents(other, 0).positions.size() == 5);
}

namespace {

// A target that moves each position to matrix * position and turns normals along, if said.
MorphTarget targetOf(const Primitive& p, const glm::dmat3& matrix, bool normals) {
  MorphTarget target;
  const glm::dmat3 forNormals = glm::transpose(glm::inverse(matrix));
  for (const glm::vec3& x : p.positions) target.positions.push_back(glm::vec3(matrix * glm::dvec3(x)) - x);
  for (const glm::vec3& n : p.normals)
    if (normals) target.normals.push_back(glm::vec3(glm::normalize(forNormals * glm::dvec3(n))) - n);
  return target;
}

glm::dmat3 turned(double degrees, const glm::dvec3& axis) {
  return glm::mat3_cast(glm::angleAxis(degrees * pi / 180, glm::normalize(axis)));
}

// The shape itself with the targets' weights.
Primitive morphed(const Primitive& p, const std::vector<float>& weights) {
  Primitive out = p;
  for (size_t t = 0; t < weights.size(); ++t)
    for (size_t v = 0; v < p.positions.size(); ++v) {
      if (!p.targets[t].positions.empty()) out.positions[v] += weights[t] * p.targets[t].positions[v];
      if (!p.targets[t].normals.empty()) out.normals[v] += weights[t] * p.targets[t].normals[v];
    }
  for (glm::vec3& n : out.normals) n = glm::normalize(n);
  out.targets.clear();
  return out;
}

// The largest angle in degrees between tangents as the vertex stage adds them up and those of the morphed shape.
double worstAngle(const Primitive& rest, const std::vector<float>& weights) {
  const Primitive out = withTangents(rest, 0), baked = withTangents(morphed(rest, weights), 0);
  REQUIRE(out.indices.size() == baked.indices.size());
  double worst = 0;
  for (size_t c = 0; c < out.indices.size(); ++c) {
    const size_t v = out.indices[c];
    glm::dvec3 t = glm::vec3(out.tangents[v]);
    for (size_t i = 0; i < weights.size(); ++i)
      if (!out.targets[i].tangents.empty()) t += double(weights[i]) * glm::dvec3(out.targets[i].tangents[v]);
    const glm::dvec3 wanted = glm::vec3(tangentAt(baked, c));
    CHECK(out.tangents[v].w == tangentAt(baked, c).w);
    worst = std::max(worst, std::acos(std::clamp(glm::dot(glm::normalize(t), wanted), -1.0, 1.0)) * 180 / pi);
  }
  return worst;
}

}  // namespace

TEST_CASE("Tangents follow morph targets") {
  const glm::dmat3 stretched(3, 0, 0, 0, 0.5, 0, 0, 0, 1), sheared(1, 0, 0, 1, 1, 0, 0, 0, 1);
  for (const Primitive& base : {texturedQuad(), fromShape(sphereShape(8, 16))}) {
    for (const glm::dmat3& matrix : {turned(180, {0, 0, 1}), turned(90, {1, 2, 3}), turned(50, {0, 1, 0}) * stretched,
                                     sheared * turned(20, {1, 0, 0})}) {
      Primitive p = base;
      p.targets = {targetOf(p, matrix, true)};
      CHECK(worstAngle(p, {1}) < 0.05);
      CHECK(worstAngle(p, {0}) < 0.05);
    }
  }
  // In between: exact where the surface is flat, for several targets, too; half of a half turn is a point.
  for (const float w : {0.2f, 0.6f, 0.9f, 1.5f, -0.4f}) {
    Primitive p = texturedQuad();
    p.targets = {targetOf(p, turned(180, {0, 0, 1}), true)};
    CHECK(worstAngle(p, {w}) < 0.05);
    p.targets = {targetOf(p, turned(90, {0, 0, 1}) * stretched, true), targetOf(p, sheared, true)};
    CHECK(worstAngle(p, {w, 0.3f}) < 0.05);
  }
}

TEST_CASE("What turns no tangent adds none, and what a target had is replaced") {
  Primitive p = texturedQuad();
  p.targets.resize(3);
  p.targets[0].positions.assign(4, {0, 0, 7});  // moved as a whole
  p.targets[1].colors.assign(4, {1, 0, 0, 0});
  p.targets[2] = targetOf(p, turned(90, {0, 0, 1}), false);
  p.targets[2].tangents.assign(4, {9, 9, 9});
  const Primitive out = withTangents(p, 0);
  CHECK(out.targets[0].tangents.empty());
  CHECK(out.targets[1].tangents.empty());
  REQUIRE(out.targets[2].tangents.size() == out.positions.size());
  for (const glm::vec3& t : out.targets[2].tangents) CHECK(glm::distance(t, glm::vec3(-1, 1, 0)) < 1e-6f);
  CHECK(out.positions.size() == 4);
}

TEST_CASE("A target that collapses a shape, or brings it out of a point, gives finite tangents") {
  Primitive p = texturedQuad();
  p.targets = {targetOf(p, glm::dmat3(0), false)};
  Primitive out = withTangents(p, 0);
  checkDefined(out);
  for (const glm::vec3& t : out.targets[0].tangents) CHECK(std::isfinite(t.x + t.y + t.z));
  // The tangent keeps its direction all the way to the point.
  for (size_t v = 0; v < out.positions.size(); ++v) {
    const glm::vec3 t = glm::vec3(out.tangents[v]) + 0.9f * out.targets[0].tangents[v];
    CHECK(glm::distance(glm::normalize(t), glm::vec3(out.tangents[v])) < 1e-5f);
  }
  p = texturedQuad();
  p.targets.resize(1);
  p.targets[0].positions = p.positions;
  p.positions.assign(4, glm::vec3(0));
  out = withTangents(p, 0);
  checkDefined(out);
  for (const glm::vec3& t : out.targets[0].tangents) CHECK(std::isfinite(t.x + t.y + t.z));
}

TEST_CASE("Flat triangles' tangents follow their morphed normals") {
  Primitive p = texturedQuad();
  p.indices.clear();
  p.positions.resize(3), p.normals.resize(3), p.texCoords[0].resize(3);
  p.flatNormals = true;
  p.targets = {targetOf(p, turned(90, {0, 1, 0}), false)};
  const Primitive out = withTangents(p, 0);
  for (size_t v = 0; v < 3; ++v)
    CHECK(glm::distance(glm::vec3(out.tangents[v]) + out.targets[0].tangents[v], glm::vec3(0, 0, -1)) < 1e-6f);
}

TEST_CASE("Tangents follow KHR_texture_transform as baked coordinates do") {
  const TextureTransform transforms[] = {
      {{}, float(pi), {1, 1}}, {{0.3f, 0.7f}, float(pi / 4), {1, 1}}, {{}, 0, {-1, 1}},
      {{1, 0}, 0, {1, -1}},    {{0, 0.2f}, -0.7f, {2, -0.5f}},        {{}, float(pi / 2), {-3, 1}}};
  const Primitive p = texturedQuad();
  for (const TextureTransform& t : transforms) {
    Primitive baked = p;
    // The extension's text: translation * rotation * scale, rotation [c s; -s c].
    const double c = std::cos(double(t.rotation)), s = std::sin(double(t.rotation));
    for (glm::vec2& uv : baked.texCoords[0]) {
      const glm::dvec2 scaled = glm::dvec2(uv) * glm::dvec2(t.scale);
      uv = glm::vec2(c * scaled.x + s * scaled.y + t.offset.x, -s * scaled.x + c * scaled.y + t.offset.y);
    }
    const Primitive got = withTangents(p, 0, t), wanted = withTangents(baked, 0);
    CAPTURE(t.rotation, t.scale.x, t.scale.y);
    for (size_t i = 0; i < 6; ++i) CHECK(glm::distance(tangentAt(got, i), tangentAt(wanted, i)) < 1e-6f);
    CHECK(got.texCoords[0] == p.texCoords[0]);
  }
  // By hand: half a turn, and u mirrored.
  CHECK(glm::distance(withTangents(p, 0, transforms[0]).tangents[0], glm::vec4(-1, 0, 0, 1)) < 1e-6f);
  CHECK(glm::distance(withTangents(p, 0, transforms[2]).tangents[0], glm::vec4(-1, 0, 0, -1)) < 1e-6f);
  CHECK(withTangents(p, 0, {{5, 5}, 0, {2, 3}}).tangents == withTangents(p, 0).tangents);
}

TEST_CASE("On a sphere the tangent is the parallel's direction, better with finer meshes") {
  double before = 0;
  for (const int stacks : {16, 32, 64}) {
    const Primitive p = withTangents(fromShape(sphereShape(stacks, 2 * stacks)), 0);
    checkDefined(p);
    double worst = 0;
    for (size_t i = 0; i < p.positions.size(); ++i) {
      const glm::dvec3 n = p.normals[i];
      if (std::abs(n.y) > 0.9) continue;  // towards the poles the parallels curl within one triangle
      const glm::dvec3 parallel = glm::normalize(glm::dvec3(n.z, 0, -n.x));
      worst = std::max(worst, std::acos(std::min(1.0, glm::dot(glm::dvec3(p.tangents[i]), parallel))) * 180 / pi);
      CHECK(p.tangents[i].w == 1);
    }
    CAPTURE(stacks, worst);
    CHECK(worst < 10.0 * 16 / stacks);
    if (before > 0) CHECK(worst < 0.6 * before);
    before = worst;
  }
}

TEST_CASE("Weights are the corners' angles, as the algorithm says") {
  // Two triangles at the origin that share the edge to (0, 1, 0) and its texture, one of 90 and one of 45 degrees,
  // whose u directions differ: +x for the first, (1, 0.5) for the second.
  Primitive p;
  p.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {-1, 1, 0}};
  p.normals.assign(4, {0, 0, 1});
  // Second: uv(x, y) with uv(0, 1) = (0, 1) as in the first, but u = x - y... chosen through its corner alone.
  p.texCoords[0] = {{0, 0}, {0, 1}, {1, 0}, {-1, 0.5f}};
  p.indices = {0, 2, 1, 0, 1, 3};
  // Second triangle: solves s for d u = 1, d v = 0: with e1 = (0, 1) -> (0, 1), e2 = (-1, 1) -> (-1, 0.5):
  // s = -(e2 - 0.5 e1) = (1, -0.5).
  const glm::dvec2 s = glm::normalize(glm::dvec2(1, -0.5));
  const glm::dvec2 expected = glm::normalize(glm::dvec2(1, 0) * (pi / 2) + s * (pi / 4));
  const Primitive out = withTangents(p, 0);
  const glm::vec4 t = tangentAt(out, 0);
  CHECK(t.x == Approx(expected.x));
  CHECK(t.y == Approx(expected.y));
  CHECK(tangentAt(out, 5).y == Approx(s.y));  // a corner of one triangle
  CHECK(out.positions.size() == 4);
}

TEST_CASE("Triangles without area inherit from good ones at the same vertices") {
  Primitive p = texturedQuad();
  p.texCoords[0] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};  // u up
  p.indices = {0, 0, 1, 0, 1, 2, 0, 2, 3, 2, 2, 2};
  const Primitive out = withTangents(p, 0);
  checkDefined(out);
  CHECK(out.positions.size() == 4);
  REQUIRE(out.indices.size() == 12);
  for (size_t c = 0; c < 12; ++c) CHECK(tangentAt(out, c) == glm::vec4(0, 1, 0, tangentAt(out, 3).w));
}

TEST_CASE("Triangles without texture area join their neighbours, or get any perpendicular") {
  // A square and, over its right edge, a triangle whose texture has collapsed to that edge.
  Primitive p = texturedQuad();
  p.positions.push_back({2, 0.5f, 0});
  p.normals.push_back({0, 0, 1});
  p.texCoords[0].push_back({1, 0.5f});
  p.indices.insert(p.indices.end(), {2, 1, 4});
  Primitive out = withTangents(p, 0);
  checkDefined(out);
  CHECK(tangentAt(out, 6) == glm::vec4(1, 0, 0, 1));
  CHECK(tangentAt(out, 7) == glm::vec4(1, 0, 0, 1));
  CHECK(tangentAt(out, 8) == glm::vec4(1, 0, 0, 1));

  for (const glm::vec3& n : {glm::vec3(1, 0, 0), glm::vec3(0, -1, 0), glm::vec3(0.6f, 0, 0.8f)}) {
    Primitive collapsed = texturedQuad();
    collapsed.normals.assign(4, n);
    collapsed.texCoords[0].assign(4, {0.5f, 0.5f});
    out = withTangents(collapsed, 0);
    checkDefined(out);
    CHECK(out.tangents[0].w == 1);
  }
}

TEST_CASE("Scale and place don't matter") {
  const float scale = GENERATE(1e-25f, 1e-6f, 1e6f, 1e15f);
  Primitive p = fromShape(sphereShape(12, 24));
  const Primitive unscaled = withTangents(p, 0);
  for (glm::vec3& x : p.positions) x *= scale;
  const Primitive out = withTangents(p, 0);
  REQUIRE(out.tangents.size() == unscaled.tangents.size());
  double worst = 0;
  for (size_t i = 0; i < out.tangents.size(); ++i)
    worst = std::max(worst, double(glm::distance(out.tangents[i], unscaled.tangents[i])));
  CHECK(worst < 1e-5);
}

TEST_CASE("Nothing to do: no normals, no such coordinates, no triangles") {
  Primitive p = texturedQuad();
  CHECK(withTangents(p, 1).tangents.empty());
  CHECK(withTangents(p, -1).tangents.empty());
  CHECK(withTangents(p, 2).tangents.empty());
  p.topology = Topology::lines;
  CHECK(withTangents(p, 0).tangents.empty());
  p = texturedQuad();
  p.normals.clear();
  CHECK(withTangents(p, 0).tangents.empty());
}

TEST_CASE("Strips and fans are expanded first") {
  Primitive strip = texturedQuad();
  strip.topology = Topology::triangleStrip;
  strip.indices = {0, 1, 3, 2};
  Primitive fan = texturedQuad();
  fan.topology = Topology::triangleFan;
  fan.indices.clear();
  for (const Primitive& p : {withTangents(strip, 0), withTangents(fan, 0)}) {
    CHECK(p.topology == Topology::triangles);
    CHECK(p.indices.size() == 6);
    for (const glm::vec4& t : p.tangents) CHECK(t == glm::vec4(1, 0, 0, 1));
  }
}

TEST_CASE("Random soup, with all that can be degenerate, has defined tangents") {
  std::mt19937 random(7);
  const auto pick = [&](int count) { return int(random() % unsigned(count)); };
  Primitive p;
  for (int i = 0; i < 400; ++i) {  // few places, normals and coordinates: coincidences of every kind
    p.positions.push_back(glm::vec3(pick(4), pick(4), pick(3)) * (pick(50) == 0 ? 1e-30f : 1.0f));
    p.normals.push_back(glm::normalize(glm::vec3(pick(3) - 1, pick(3) - 1, 0.5f)));
    p.texCoords[0].push_back(glm::vec2(pick(3), pick(3)) * (pick(50) == 0 ? 1e-25f : 0.5f));
  }
  for (int i = 0; i < 30000; ++i) p.indices.push_back(uint32_t(pick(400)));
  const Primitive out = withTangents(p, 0);
  checkDefined(out);
  CHECK(out.indices.size() == p.indices.size());
}

TEST_CASE("Work stays near linear where everything meets in one place") {
  // 200 000 triangles over one edge, all the same way round, and as many around one vertex in a fan.
  constexpr uint32_t count = 200000;
  Primitive p;
  for (uint32_t i = 0; i < count + 3; ++i) {
    const double angle = 6.0 * i / count;
    p.positions.push_back(i < 2 ? glm::vec3(0, 0, float(i)) : glm::vec3(std::cos(angle), std::sin(angle), 0));
    p.normals.push_back({0, 0, 1});
    p.texCoords[0].push_back(glm::vec2(p.positions.back()) + glm::vec2(0, float(i == 1)));
  }
  for (uint32_t i = 0; i < count; ++i) {
    p.indices.insert(p.indices.end(), {0, 1, i + 2});
    p.indices.insert(p.indices.end(), {0, i + 2, i + 3});
  }
  checkDefined(withTangents(p, 0));
}

TEST_CASE("The tangents of NormalTangentMirrorTest are those that its file holds") {
  const std::string path =
      facet::test::sharedFile("assets/models/NormalTangentMirrorTest/glTF-Binary/NormalTangentMirrorTest.glb");
  if (path.empty()) return;
  std::ifstream file(path, std::ios::binary);
  const std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
  uint32_t jsonLength = 0;
  std::memcpy(&jsonLength, bytes.data() + 12, 4);
  const auto gltf = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + long(jsonLength));
  const auto& given = gltf["meshes"][0]["primitives"][0];
  const auto read = [&](int index, auto& values) {
    const auto& accessor = gltf["accessors"][size_t(index)];
    const auto& view = gltf["bufferViews"][accessor["bufferView"].get<size_t>()];
    REQUIRE_FALSE(view.contains("byteStride"));
    values.resize(accessor["count"]);
    const size_t start =
        28 + jsonLength + view.value("byteOffset", size_t{0}) + accessor.value("byteOffset", size_t{0});
    std::memcpy(values.data(), bytes.data() + start, values.size() * sizeof(values[0]));
  };
  Primitive p;
  std::vector<glm::vec4> tangents;
  std::vector<uint16_t> indices;
  read(given["attributes"]["POSITION"], p.positions);
  read(given["attributes"]["NORMAL"], p.normals);
  read(given["attributes"]["TEXCOORD_0"], p.texCoords[0]);
  read(given["attributes"]["TANGENT"], tangents);
  REQUIRE(gltf["accessors"][given["indices"].get<size_t>()]["componentType"] == 5123);
  read(given["indices"], indices);
  p.indices.assign(indices.begin(), indices.end());

  const Primitive out = withTangents(p, 0);
  CHECK(out.positions.size() == p.positions.size());
  REQUIRE(out.indices.size() == p.indices.size());
  size_t different = 0;
  for (size_t c = 0; c < p.indices.size(); ++c) {
    const glm::vec4 ours = tangentAt(out, c), theirs = tangents[p.indices[c]];
    different += glm::distance(glm::vec3(ours), glm::vec3(theirs)) > 1e-4f || ours.w != theirs.w;
  }
  CHECK(different <= p.indices.size() / 1000);
}
