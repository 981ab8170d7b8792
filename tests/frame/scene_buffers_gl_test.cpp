#include <catch2/catch.hpp>
#include <random>

#include "frame/scene_buffers.hpp"
#include "frame/traced.hpp"
#include "optics/bsdf_sampling.hpp"
#include "scene/pick.hpp"
#include "scene/shapes.hpp"
#include "scene_by_index.h"
#include "support/gpu.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

// A hit as the shader below reads it, two vec4 and what is known of V and L.
struct HitIn {
  uint32_t primitive, triangle, padding[2];
  glm::vec4 weights;
  glm::vec4 V, L;  // V.w, L.w: the base's A and B
};

struct ShadedOut {
  glm::vec4 f;         // evaluateBsdf
  glm::vec4 normal;    // w: the density of L
  glm::vec4 position;  // w: of the sample that is drawn, its density
  glm::vec4 texCoord;  // of sets 0 and 1
  glm::vec4 color;
};

constexpr const char* shader = R"(#define MATERIAL_BY_INDEX
#include "scene_by_index.glsl"
#define ABSENT(slot, texel) vec4 slot##Texel(Varyings v) { return texel; }
#define TEXTURE_SLOT(name, DEFINE, words, texel) ABSENT(name, texel)
#include "texture_slots.inc"
#undef TEXTURE_SLOT
#include "material.glsl"
#include "bsdf_sampling.glsl"
layout(local_size_x = 64) in;
struct HitIn { uvec4 where; vec4 weights, V, L; };
struct ShadedOut { vec4 f, normal, position, texCoord, color; };
layout(std430, binding = computeInputBinding) readonly buffer HitsBlock { HitIn hits[]; };
layout(std430, binding = computeOutputBinding) writeonly buffer ShadedBlock { ShadedOut shaded[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(hits.length())) return;
  HitIn hit = hits[i];
  Varyings v = varyingsAt(SceneHit(hit.where.x, hit.where.y, hit.weights.xyz));
  selectMaterial(scenePrimitives[hit.where.x].material);
  vec2 metallicRoughness = materialMetallicRoughness(v);
  vec3 N = materialNormal(v, hit.V.xyz);
  Surface s = makeSurface(N, hit.V.xyz, materialBaseColor(v).rgb, metallicRoughness.x, metallicRoughness.y, 1.0);
  s.dfg = vec3(hit.V.w, hit.L.w, 0.0);
  Through t = opaque();
  LobeChances chances = lobeChances(s, t);
  shaded[i].f = vec4(evaluateBsdf(s, t, hit.L.xyz), 1.0);
  shaded[i].normal = vec4(N, bsdfDensity(s, t, chances, hit.L.xyz));
  BsdfSample drawn = sampleBsdf(s, t, vec3(0.3, 0.6, 0.2));
  shaded[i].position = vec4(v.position, drawn.density);
  shaded[i].texCoord = vec4(v.texCoord[0], v.texCoord[1]);
  shaded[i].color = v.color;
}
)";

// A sphere, and a strip with colours and two sets of texture coordinates; a material each.
scene::Model twoPrimitives() {
  scene::Model model;
  const scene::Shape sphere = scene::sphereShape(6, 9);
  scene::Primitive ball;
  ball.positions = sphere.positions, ball.normals = sphere.normals, ball.indices = sphere.indices;
  ball.material = 1;
  scene::Primitive strip;
  strip.topology = scene::Topology::triangleStrip;
  strip.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0.5f}, {0, 2, 1}};
  strip.normals.assign(5, glm::normalize(glm::vec3(0.2f, -0.3f, 1)));
  for (int i = 0; i < 5; ++i) {
    const float x = float(i) / 5;
    strip.colors.emplace_back(1 - x, x, 0.5f, 1);
    strip.texCoords[0].emplace_back(x, -x);
    strip.texCoords[1].emplace_back(3 * x, 7 - x);
  }
  strip.material = 0;
  model.materials.resize(2);
  model.materials[0].baseColorFactor = {0.8f, 0.7f, 0.6f, 1};
  model.materials[0].metallicFactor = 0, model.materials[0].perceptualRoughnessFactor = 0.5f;
  model.materials[1].baseColorFactor = {0.9f, 0.4f, 0.2f, 1};
  model.materials[1].metallicFactor = 0.75f, model.materials[1].perceptualRoughnessFactor = 0.35f;
  model.meshes.resize(1);
  model.meshes[0].primitives = {ball, strip};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.scenes.resize(1);
  model.scenes[0].nodes = {0};
  return model;
}

glm::dvec3 above(const glm::dvec3& N, double a, double b) {
  const glm::dvec3 side =
      glm::normalize(glm::cross(N, std::abs(N.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  return glm::normalize(N + a * side + b * glm::cross(N, side));
}

}  // namespace

TEST_CASE("Scene by index: a compute shader shades a buffer of hits as the twins do", "[gl]") {
  const scene::Model model = twoPrimitives();
  const frame::DrawList list = frame::buildDrawList(model, 0, {});
  const frame::TracedList traced = frame::tracedList(list);
  REQUIRE(traced.parts.size() == 2);
  const frame::SceneBuffers buffers = frame::sceneBuffers(traced.parts, list.materials);

  struct Expected {
    scene::Hit hit;
    const scene::Primitive* primitive;
    optics::Surface surface;
    glm::dvec3 N, V, L;
  };
  std::vector<HitIn> hits;
  std::vector<Expected> expected;
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  for (const scene::Primitive& p : model.meshes[0].primitives)
    for (size_t i = 0; i < scene::triangleCount(p); ++i) {
      Expected e{{}, &p, {}, {}, {}, {}};
      e.hit.vertices = scene::triangleVertices(p, i);
      e.hit.weights = {uniform(random), uniform(random), uniform(random)};
      e.hit.weights = glm::dvec3(glm::vec3(e.hit.weights / (e.hit.weights.x + e.hit.weights.y + e.hit.weights.z)));
      e.N = glm::normalize(glm::dvec3(*scene::interpolated(p.normals, e.hit)));
      e.V = above(e.N, 0.4, -0.2), e.L = above(e.N, -0.5 + uniform(random), 0.3);
      const scene::Material& m = model.materials[static_cast<size_t>(p.material)];
      const glm::vec4 color = scene::interpolated(p.colors, e.hit).value_or(glm::vec4(1)) * m.baseColorFactor;
      e.surface = {glm::dvec3(color), double(m.metallicFactor), double(m.perceptualRoughnessFactor)};
      hits.push_back({traced.parts[0].primitive == &p ? 0u : 1u,
                      static_cast<uint32_t>(i),
                      {},
                      glm::vec4(glm::vec3(e.hit.weights), 0),
                      glm::vec4(glm::vec3(e.V), 0.75f),
                      glm::vec4(glm::vec3(e.L), 0.125f)});
      expected.push_back(e);
    }

  const std::string entry = "hits.comp.glsl";
  const auto reader = [&, embedded = shading::shaderReader()](const std::string& path) {
    return path == entry ? std::optional<std::string>(shader) : embedded(path);
  };
  shading::ProgramStore store(reader, {}, "");
  const auto program = store.compute(entry);
  if (!program) FAIL(describe(program.error()));
  const gl::Buffer in = gl::Buffer::of(hits, "hits");
  const gl::Buffer out(hits.size() * sizeof(ShadedOut), "shaded");
  frame::bindSceneBuffers(buffers);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, in.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.id());
  glUseProgram((*program)->id());
  glDispatchCompute(static_cast<GLuint>((hits.size() + 63) / 64), 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  const std::vector<ShadedOut> shaded = out.read<ShadedOut>(hits.size());

  int lit = 0;
  for (size_t i = 0; i < hits.size(); ++i) {
    const Expected& e = expected[i];
    const ShadedOut& got = shaded[i];
    INFO("hit " << i << " of primitive " << hits[i].primitive);
    const optics::Albedos albedos{{0.75, 0.125}, {}};
    const glm::dvec3 f = optics::evaluate(e.surface, albedos, e.N, e.V, e.L);
    for (int c = 0; c < 3; ++c) CHECK(double(got.f[c]) == Approx(f[c]).epsilon(2e-4).margin(1e-6));
    const optics::LobeChances chances = optics::lobeChances(e.surface, albedos, {}, glm::dot(e.N, e.V));
    CHECK(double(got.normal.w) == Approx(optics::bsdfDensity(e.surface, {}, chances, e.N, e.V, e.L)).epsilon(2e-4));
    CHECK(got.position.w > 0);
    for (int c = 0; c < 3; ++c) CHECK(double(got.normal[c]) == Approx(e.N[c]).margin(1e-6));
    const auto near = [](const auto& a, const auto& b) {
      for (int c = 0; c < a.length(); ++c) CHECK(a[c] == Approx(b[c]).margin(1e-6));
    };
    near(glm::vec3(got.position), *scene::interpolated(e.primitive->positions, e.hit));
    near(got.color, scene::interpolated(e.primitive->colors, e.hit).value_or(glm::vec4(1)));
    near(glm::vec2(got.texCoord), scene::interpolated(e.primitive->texCoords[0], e.hit).value_or(glm::vec2(0)));
    near(glm::vec2(got.texCoord.z, got.texCoord.w),
         scene::interpolated(e.primitive->texCoords[1], e.hit).value_or(glm::vec2(0)));
    lit += f.x > 0.01;
  }
  CHECK(lit > int(hits.size()) / 2);
}

TEST_CASE("Scene by index: lines and points have no triangles, a primitive that is drawn twice stands once", "[gl]") {
  scene::Model model = twoPrimitives();
  model.meshes[0].primitives[1].topology = scene::Topology::lines;
  model.nodes.push_back(model.nodes[0]);
  model.nodes[1].scale = {-1, 1, 1};  // mirrored: a draw of its own
  model.scenes[0].nodes.push_back(1);
  const frame::DrawList list = frame::buildDrawList(model, 0, {});
  REQUIRE(list.opaque.size() > 2);
  const frame::TracedList traced = frame::tracedList(list);
  CHECK(traced.parts.size() == 1);
  CHECK(traced.thin == 2);
  CHECK(traced.classes.size() == 1);
  const frame::SceneBuffers buffers = frame::sceneBuffers(traced.parts, list.materials);
  const auto primitives = buffers.primitives.read<layout::ScenePrimitive>(1);
  CHECK(primitives[0].triangles == scene::triangleCount(model.meshes[0].primitives[0]));
  CHECK(primitives[0].tangent == layout::noAttribute);
  CHECK(buffers.attributes.bytes() == model.meshes[0].primitives[0].positions.size() * 6 * sizeof(float));
}
