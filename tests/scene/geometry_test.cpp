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
    CHECK(notes[0].text == "the normalTexture needs TEXCOORD_1, which is missing; the texture is not used");
  }
  SECTION("missing coordinates are noted once for each texture that can be seen") {
    mapped.baseColor = mapped.occlusion = mapped.clearcoat = mapped.emissive = {0, 2, {}};
    mapped.baseColorFactor = {0, 0, 0, 1};
    mapped.clearcoatFactor = 1;
    Model model = modelWith(quad(), mapped);
    model.materials.push_back(mapped);
    model.materials[1].occlusion.texCoord = 3;
    model.meshes[0].primitives[0].variantMaterials = {1, 0, 1};
    completeGeometry(model, notes);
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].text == "the occlusionTexture needs TEXCOORD_2, which is missing; the texture is not used");
    CHECK(notes[1].text == "the clearcoatTexture needs TEXCOORD_2, which is missing; the texture is not used");
  }
  SECTION("anisotropy and a clearcoat's normals get tangents") {
    Material m;
    m.anisotropyStrength = 0.5f;
    Model model = modelWith(quad(), m);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].tangents.size() == 4);
    m.anisotropyStrength = 0;
    m.clearcoatNormal.texture = 0;
    model = modelWith(quad(), m);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].tangents.empty());
    m.clearcoatFactor = 1;
    model = modelWith(quad(), m);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].tangents.size() == 4);
    CHECK(notes.empty());
  }
  SECTION("anisotropy without coordinates is noted") {
    Material m;
    m.anisotropyStrength = 0.5f;
    Primitive plain = quad();
    plain.texCoords = {};
    Model model = modelWith(plain, m);
    completeGeometry(model, notes);
    CHECK(model.meshes[0].primitives[0].tangents.empty());
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].text == "an anisotropic material needs tangents or texture coordinates; it is shown isotropic");
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
    model.materials[0].baseColor.texture = 0;
    completeGeometry(model, notes);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].text == "the baseColorTexture needs TEXCOORD_0, which is missing; the texture is not used");
  }
}

namespace {

// The quad with a joint, a morph target and a colour for each vertex that tell which one it was.
Primitive labelled() {
  Primitive p = quad();
  p.influencesPerVertex = 2;
  p.targets.resize(2);
  for (uint32_t v = 0; v < 4; ++v) {
    const float f = float(v);
    p.influences.insert(p.influences.end(), {{v, 0.75f}, {v + 4, 0.25f}});
    p.targets[0].positions.push_back({f, 0, 0});
    p.targets[0].normals.push_back({0, f, 0});
    p.targets[0].tangents.push_back({0, 0, f});
    p.targets[1].colors.push_back({f, f, f, f});
    p.texCoords[7].push_back({f, -f});
  }
  return p;
}

void checkLabels(const Primitive& p, const std::vector<uint32_t>& was) {
  REQUIRE(p.positions.size() == was.size());
  REQUIRE(p.influences.size() == 2 * was.size());
  for (size_t v = 0; v < was.size(); ++v) {
    const float f = float(was[v]);
    CHECK(p.positions[v] == quad().positions[was[v]]);
    CHECK(p.influences[2 * v].joint == was[v]);
    CHECK(p.influences[2 * v + 1].joint == was[v] + 4);
    CHECK(p.influences[2 * v + 1].weight == 0.25f);
    CHECK(p.targets.at(0).positions.at(v) == glm::vec3(f, 0, 0));
    CHECK(p.targets.at(1).colors.at(v) == glm::vec4(f));
    CHECK(p.texCoords[7].at(v) == glm::vec2(f, -f));
  }
}

}  // namespace

TEST_CASE("Influences and morph targets go along where vertices are copied") {
  const std::vector<uint32_t> corners = quad().indices;
  checkLabels(unwelded(labelled()), corners);
  CHECK(unwelded(labelled()).targets[0].tangents.at(5) == glm::vec3(0, 0, 3));
  CHECK(unwelded(labelled()).targets[1].positions.empty());
  checkLabels(asList(labelled()), {0, 1, 2, 3});

  const Primitive flat = withFlatNormals(labelled());
  checkLabels(flat, corners);
  CHECK(flat.flatNormals);
  CHECK(flat.targets[0].normals.empty());  // there are no normals that they could change
  CHECK(flat.targets[0].tangents.empty());

  Primitive strip = labelled();
  strip.topology = Topology::triangleStrip;
  strip.indices = {0, 1, 3, 2};
  strip.variantMaterials = {4};
  checkLabels(unwelded(strip), {0, 1, 3, 1, 2, 3});
  strip.indices = {0, 1};
  CHECK(asList(strip).variantMaterials == std::vector<int>{4});
}

TEST_CASE("Only normals that were missing are flat") {
  Notes notes;
  Model model = modelWith(labelled(), {});
  completeGeometry(model, notes);
  CHECK(model.meshes[0].primitives[0].flatNormals);
  Primitive given = labelled();
  given.normals.resize(4, {0, 0, 1});
  model = modelWith(given, {});
  completeGeometry(model, notes);
  CHECK_FALSE(model.meshes[0].primitives[0].flatNormals);
  CHECK(model.meshes[0].primitives[0].targets[0].normals.size() == 4);
}

TEST_CASE("Bounds of joints and morph targets hold the vertices that are drawn") {
  Primitive p = labelled();
  p.normals.resize(4, {0, 0, 1});
  p.indices = {0, 1, 2};
  p.influences[1].weight = 0;  // joint 4 has no other share
  Model model = modelWith(p, {});
  Notes notes;
  completeGeometry(model, notes);
  const Primitive& done = model.meshes[0].primitives[0];
  REQUIRE(done.jointBounds.size() == 7);  // vertex 3 is not drawn, so joints 3 and 7 have none
  CHECK(done.jointBounds.capacity() == 7);
  CHECK(done.jointBounds[2].min == glm::dvec3(1, 1, 0));
  CHECK(done.jointBounds[6].max == glm::dvec3(1, 1, 0));
  CHECK(done.jointBounds[3].empty());
  CHECK(done.jointBounds[4].empty());
  CHECK(done.targets[0].bounds.min == glm::dvec3(0));
  CHECK(done.targets[0].bounds.max == glm::dvec3(2, 0, 0));
  CHECK(done.targets[1].bounds.empty());
}

TEST_CASE("The materials of variants get what they need as well") {
  Material plain, mapped, unlit;
  mapped.normal.texture = 0;
  unlit.unlit = true;
  Notes notes;
  Model model = modelWith(quad(), unlit);
  model.materials.push_back(plain);
  model.materials.push_back(mapped);
  Primitive& p = model.meshes[0].primitives[0];
  SECTION("none: the primitive is unlit") {
    p.variantMaterials = {-1, 0};
    completeGeometry(model, notes);
    CHECK(p.normals.empty());
  }
  SECTION("a lit one gets normals") {
    p.variantMaterials = {-1, 1};
    completeGeometry(model, notes);
    CHECK(p.normals.size() == 6);
    CHECK(p.tangents.empty());
  }
  SECTION("one with a normal texture gets tangents") {
    p.variantMaterials = {1, 2};
    completeGeometry(model, notes);
    CHECK(p.tangents.size() == p.positions.size());
    CHECK(notes.empty());
  }
  SECTION("tangents are those of the texture's transform, and others are noted") {
    model.materials.push_back(mapped);
    model.materials[3].normal.transform.rotation = 3.14159265f;
    model.materials.push_back(model.materials[3]);
    model.materials[4].normal.transform.scale = {2, 3};  // leaves the directions
    model.materials[4].normal.transform.offset = {0.5f, 0.5f};
    p.variantMaterials = {3, 4};
    completeGeometry(model, notes);
    REQUIRE(p.tangents.size() == p.positions.size());
    CHECK(notes.empty());
    const glm::vec4 turned = p.tangents[0];
    p.tangents.clear();
    p.variantMaterials = {2, 3, 4};
    completeGeometry(model, notes);
    CHECK(glm::distance(glm::vec3(p.tangents[0]), -glm::vec3(turned)) < 1e-6f);
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].text ==
          "the variants' materials have such a texture in different coordinates: the tangents of all are those of "
          "TEXCOORD_0");
  }
  SECTION("other coordinates are noted, once each") {
    model.materials.push_back(mapped);
    model.materials[3].normal.texCoord = 1;
    model.materials.push_back(mapped);
    model.materials[4].normal.texCoord = 5;
    p.texCoords[1] = p.texCoords[0];
    p.variantMaterials = {4, 2, 3, 3, 2, 4};
    completeGeometry(model, notes);
    CHECK(p.tangents.size() == p.positions.size());
    REQUIRE(notes.size() == 2);
    CHECK(notes[0].text == "the normalTexture needs TEXCOORD_5, which is missing; the texture is not used");
    CHECK(notes[1].text ==
          "the variants' materials have such a texture in different coordinates: the tangents of all are those of "
          "TEXCOORD_0");
  }
  SECTION("a coat's normal texture and a grain have tangents of their own where their coordinates are others") {
    Material& all = model.materials[2];
    all.clearcoatFactor = 1, all.clearcoatNormal.texture = 0, all.clearcoatNormal.texCoord = 1;
    all.anisotropyStrength = 1, all.anisotropy.texture = 0, all.anisotropy.transform.rotation = -1.57079633f;
    for (const glm::vec2& uv : p.texCoords[0]) p.texCoords[1].emplace_back(-uv.x, uv.y);
    p.material = 2;
    p.targets.resize(1);  // turned by a right angle about z: x to y
    for (const glm::vec3& x : p.positions) p.targets[0].positions.push_back(glm::vec3(-x.y, x.x, x.z) - x);
    completeGeometry(model, notes);
    CHECK(notes.empty());
    REQUIRE(p.tangents.size() == p.positions.size());
    REQUIRE(p.coatTangents.size() == p.positions.size());
    REQUIRE(p.grainTangents.size() == p.positions.size());
    for (size_t v = 0; v < p.positions.size(); ++v) {
      const glm::vec3 t(p.tangents[v]), bitangent = p.tangents[v].w * glm::cross(p.normals[v], t);
      CHECK(glm::distance(glm::vec3(p.coatTangents[v]), -t) < 1e-6f);
      CHECK(p.coatTangents[v].w == -p.tangents[v].w);
      // uv' = R(-90 degrees) uv: u' grows along one of the bitangent's two ways, w stays.
      CHECK(std::abs(glm::dot(glm::vec3(p.grainTangents[v]), bitangent)) == Approx(1));
      CHECK(p.grainTangents[v].w == p.tangents[v].w);
      for (const auto& [tangents, differences] :
           {std::pair(&p.tangents, &p.targets[0].tangents), std::pair(&p.coatTangents, &p.targets[0].coatTangents),
            std::pair(&p.grainTangents, &p.targets[0].grainTangents)}) {
        REQUIRE(differences->size() == p.positions.size());
        const glm::vec3 rest((*tangents)[v]);
        CHECK(glm::distance(rest + (*differences)[v], glm::vec3(-rest.y, rest.x, rest.z)) < 1e-5f);
      }
    }
  }
}

TEST_CASE("A normal texture that an animation brings out gets tangents") {
  Material mapped;
  mapped.normal.texture = 0;
  mapped.normalScale = 0;
  Notes notes;
  Model model = modelWith(quad(), mapped);
  completeGeometry(model, notes);
  CHECK(model.meshes[0].primitives[0].tangents.empty());
  model = modelWith(quad(), mapped);
  model.animations = {{"", {{Interpolation::linear, {0}, {1}, 1}}, {{0, AnimatedProperty::normalScale, 0}}}};
  completeGeometry(model, notes);
  CHECK_FALSE(model.meshes[0].primitives[0].tangents.empty());
}

TEST_CASE("What is hidden is completed, because an animation may show it") {
  Model model = modelWith(quad(), {});
  model.nodes[0].visible = false;
  Notes notes;
  completeGeometry(model, notes, 0);
  CHECK_FALSE(model.meshes[0].primitives[0].normals.empty());
}
