#include "scene/geometry.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace facet;
using namespace facet::scene;

namespace {

// Five vertices; what they are doesn't matter.
Primitive five(Topology topology) {
  Primitive p;
  p.topology = topology;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 2, 0}};
  return p;
}

Primitive quad() {
  Primitive p;
  p.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  p.texCoords[0] = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  p.indices = {0, 1, 2, 0, 2, 3};
  p.material = 0;
  return p;
}

Model modelWith(const Primitive& primitive, const Material& material) {
  Model model;
  model.materials = {material};
  model.meshes = {{"", {primitive}}};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.scenes = {{"", {0}}, {"empty", {}}};
  return model;
}

}  // namespace

TEST_CASE("Strips, fans and loops become lists in the order that glTF gives") {
  using Indices = std::vector<uint32_t>;
  CHECK(asList(five(Topology::triangleStrip)).indices == Indices{0, 1, 2, 1, 3, 2, 2, 3, 4});
  CHECK(asList(five(Topology::triangleFan)).indices == Indices{1, 2, 0, 2, 3, 0, 3, 4, 0});
  CHECK(asList(five(Topology::lineStrip)).indices == Indices{0, 1, 1, 2, 2, 3, 3, 4});
  CHECK(asList(five(Topology::lineLoop)).indices == Indices{0, 1, 1, 2, 2, 3, 3, 4, 4, 0});
  CHECK(asList(five(Topology::lineLoop)).topology == Topology::lines);
  CHECK(asList(five(Topology::points)).indices.empty());

  Primitive strip = five(Topology::triangleStrip);
  strip.indices = {4, 3, 2, 1};
  CHECK(asList(strip).indices == Indices{4, 3, 2, 3, 1, 2});
  CHECK(asList(strip).topology == Topology::triangles);

  CHECK(asList(five(Topology::triangles)).indices == Indices{0, 1, 2});  // the incomplete one is cut off
  CHECK(asList(five(Topology::lines)).indices == Indices{0, 1, 2, 3});
}

TEST_CASE("Too few corners draw nothing") {
  for (const Topology topology : {Topology::triangles, Topology::triangleStrip, Topology::triangleFan}) {
    Primitive p = five(topology);
    p.positions.resize(2);
    CHECK(asList(p).positions.empty());
    CHECK(withFlatNormals(p).positions.empty());
  }
  Primitive p = five(Topology::lineStrip);
  p.positions.resize(1);
  CHECK(asList(p).positions.empty());
}

TEST_CASE("Bounds hold what is drawn") {
  Primitive p = five(Topology::triangles);
  CHECK(bounds(p).max == glm::dvec3(1, 2, 0));
  p.indices = {0, 1, 2};
  CHECK(bounds(p).max == glm::dvec3(1, 1, 0));
  CHECK(bounds(Primitive{}).empty());
}

TEST_CASE("Flat normals: counter-clockwise is the front, at any scale, no area gives +Z") {
  const float scale = GENERATE(1e-30f, 1.0f, 1e18f);
  Primitive p;
  p.positions = {{0, 0, 0}, {0, 0, scale}, {scale, 0, 0}, {scale, 0, 0}, {0, scale, 0}};
  p.colors = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}, {1, 1, 0, 1}, {0, 1, 1, 1}};
  p.tangents.resize(5, {1, 0, 0, 1});
  p.indices = {0, 1, 2, 2, 3, 4, 0, 2, 4};
  const Primitive flat = withFlatNormals(p);
  REQUIRE(flat.positions.size() == 9);
  CHECK(flat.indices.empty());
  CHECK(flat.tangents.empty());
  CHECK(flat.normals[0] == glm::vec3(0, 1, 0));
  CHECK(flat.normals[2] == glm::vec3(0, 1, 0));
  CHECK(flat.normals[3] == glm::vec3(0, 0, 1));
  CHECK(flat.normals[8] == glm::vec3(0, 0, 1));
  CHECK(flat.colors[5] == p.colors[4]);
}

TEST_CASE("A strip's flat normals all look the same way") {
  const Primitive flat = withFlatNormals(five(Topology::triangleStrip));
  REQUIRE(flat.normals.size() == 9);
  for (const glm::vec3& n : flat.normals) CHECK(n == glm::vec3(0, 0, 1));
}

TEST_CASE("Geometry is completed as the materials need it") {
  Material mapped;
  mapped.normal.texture = 0;
  Notes notes;

  SECTION("a lit material without maps gets normals only") {
    Model model = modelWith(quad(), {});
    completeGeometry(model, notes);
    const Primitive& p = model.meshes[0].primitives[0];
    CHECK(p.normals.size() == 6);
    CHECK(p.tangents.empty());
    CHECK(p.bounds.max == glm::dvec3(1, 1, 0));
  }
  SECTION("a normal map gets tangents, and given ones are ignored when normals are missing") {
    Primitive given = quad();
    given.tangents.resize(4, {0, 0, 1, -1});
    Model model = modelWith(given, mapped);
    completeGeometry(model, notes);
    const Primitive& p = model.meshes[0].primitives[0];
    REQUIRE(p.tangents.size() == 4);
    CHECK(p.indices.size() == 6);
    for (const glm::vec4& t : p.tangents) CHECK(t == glm::vec4(1, 0, 0, 1));
  }
  SECTION("given tangents stay where normals are given") {
    Primitive given = quad();
    given.normals.resize(4, {0, 0, 1});
    given.tangents.resize(4, {0, 1, 0, -1});
    Model model = modelWith(given, mapped);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].tangents == given.tangents);
  }
  SECTION("unlit needs nothing") {
    mapped.unlit = true;
    Model model = modelWith(quad(), mapped);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].normals.empty());
    CHECK(model.meshes[0].primitives[0].tangents.empty());
    CHECK_FALSE(model.meshes[0].primitives[0].bounds.empty());
  }
  SECTION("missing coordinates are noted") {
    mapped.normal.texCoord = 1;
    Model model = modelWith(quad(), mapped);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].tangents.empty());
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].place == "/meshes/0/primitives/0");
    CHECK(notes[0].text == "the normal texture needs TEXCOORD_1, which is missing; the texture is not used");
  }
  SECTION("what the scene doesn't draw stays") {
    Model model = modelWith(quad(), mapped);
    completeGeometry(model, notes, 1);
    CHECK(model.meshes[0].primitives[0].normals.empty());
    completeGeometry(model, notes, 0);
    CHECK_FALSE(model.meshes[0].primitives[0].normals.empty());
  }
  SECTION("lines and points need no normals") {
    Primitive lines = five(Topology::lineStrip);
    lines.material = 0;
    Model model = modelWith(lines, mapped);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].normals.empty());
    CHECK(model.meshes[0].primitives[0].topology == Topology::lineStrip);
    CHECK(notes.empty());
  }
}
