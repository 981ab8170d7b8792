#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "frame/path_scenes.hpp"
#include "frame/paths.hpp"
#include "optics/microfacet.hpp"
#include "support/gpu.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using test::addBox, test::at, test::emptyScene, test::glowing, test::lambert, test::meanOf, test::tracedSettings;
using test::GltfBuilder;

namespace {

using Change = std::function<void(scene::Material&)>;
struct Surface {
  const char* name;
  Change apply;
};

constexpr const char* rayShader = R"(#include "rays.glsl"
layout(local_size_x = 64) in;
struct RayIn { vec4 origin, direction; };
struct HitOut { uvec4 met; vec4 where; };
layout(std430, binding = computeInputBinding) readonly buffer RaysBlock { RayIn raysIn[]; };
layout(std430, binding = computeOutputBinding) writeonly buffer HitsBlock { HitOut hits[]; };
void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= uint(raysIn.length())) return;
  RayHit hit = RayHit(rayNone, 0u, raysIn[i].direction.w, vec2(0.0)), any = hit;
  bool met = walkRay(raysIn[i].origin.xyz, raysIn[i].direction.xyz, raysIn[i].origin.w, false, false, hit);
  bool blocked = walkRay(raysIn[i].origin.xyz, raysIn[i].direction.xyz, raysIn[i].origin.w, true, false, any);
  uint triangle = met ? rayTriangle(hit.triangle).triangle : 0u;
  hits[i].met = uvec4(met ? 1u : 0u, blocked ? 1u : 0u, triangle, hit.instance);
  hits[i].where = vec4(hit.distance, hit.weights, 0.0);
}
)";

}  // namespace

TEST_CASE("Rays: a shader meets what the twin meets", "[gl]") {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> uniform(-1, 1);
  const auto point = [&](float size) { return size * glm::vec3(uniform(random), uniform(random), uniform(random)); };
  const auto triangles = [&](uint32_t count, uint32_t instance) {
    std::vector<rays::Triangle> out;
    for (uint32_t i = 0; i < count; ++i) out.push_back({point(1), 0, point(0.2f), i, point(0.2f), instance});
    return out;
  };
  rays::TracedMesh shared{triangles(300, layout::rayOfPlacement), {}};
  for (uint32_t i = 0; i < 30; ++i)
    shared.places.push_back(
        {glm::scale(glm::rotate(glm::translate(glm::dmat4(1), glm::dvec3(point(3))), double(i), glm::dvec3(1, 0.5, 0)),
                    glm::dvec3(0.5, i % 2 ? -0.4 : 0.4, 0.7)),
         i});
  for (const bool placements : {false, true}) {
    std::vector<rays::TracedMesh> meshes = {{triangles(4000, 7), {}}};
    if (placements) meshes.push_back(shared);
    const rays::TracedScene scene = rays::tracedScene(meshes);
    REQUIRE(scene.placements.empty() == !placements);
    std::vector<glm::vec4> in;
    std::vector<rays::Ray> rays;
    for (int i = 0; i < 20000; ++i) {
      rays::Ray ray{point(placements ? 4.0f : 1.5f), glm::normalize(point(1) + glm::vec3(0, 0, 1e-3f))};
      if (i % 9 == 0) ray.from = 0.4f, ray.to = 1.2f;
      if (i % 11 == 0) ray.direction[i % 3] = 0;
      if (!std::isfinite(ray.to)) ray.to = 1e30f;
      rays.push_back(ray);
      in.emplace_back(ray.origin, ray.from);
      in.emplace_back(ray.direction, ray.to);
    }
    const std::string entry = "rays.comp.glsl";
    const auto reader = [&, embedded = shading::shaderReader()](const std::string& path) {
      return path == entry ? std::optional<std::string>(rayShader) : embedded(path);
    };
    shading::ProgramStore store(reader, {}, "");
    std::vector<shading::Define> defines;
    if (placements) defines.push_back({"RAY_PLACEMENTS"});
    const auto program = store.compute(entry, defines);
    if (!program) FAIL(describe(program.error()));
    const gl::Buffer nodes = gl::Buffer::of(scene.nodes, "nodes"), corners = gl::Buffer::of(scene.triangles, "corners"),
                     places = gl::Buffer::of(scene.placements, "places"), rayBuffer = gl::Buffer::of(in, "rays");
    const gl::Texture textures[] = {gl::Texture::ofBuffer(nodes.id(), GL_RGBA32UI, "nodes"),
                                    gl::Texture::ofBuffer(corners.id(), GL_RGBA32UI, "corners"),
                                    gl::Texture::ofBuffer(places.id(), GL_RGBA32UI, "places")};
    textures[0].bind(layout::rayNodesUnit);
    textures[1].bind(layout::rayTrianglesUnit);
    textures[2].bind(layout::rayPlacementsUnit);
    struct HitOut {
      glm::uvec4 met;
      glm::vec4 where;
    };
    const gl::Buffer out(rays.size() * sizeof(HitOut), "hits");
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, rayBuffer.id());
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.id());
    glUseProgram((*program)->id());
    glDispatchCompute(static_cast<GLuint>(rays.size() / 64 + 1), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    const std::vector<HitOut> hits = out.read<HitOut>(rays.size());
    int met = 0, different = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
      const auto twin = rays::meet(scene, rays[i]);
      met += twin.has_value();
      CHECK((hits[i].met.x == 1) == (hits[i].met.y == 1));
      const bool same = twin.has_value() == (hits[i].met.x == 1) &&
                        (!twin || (twin->triangle == hits[i].met.z &&
                                   std::abs(twin->distance - hits[i].where.x) <= 1e-4f * twin->distance + 1e-5f &&
                                   (twin->instance == 7 || twin->instance == hits[i].met.w)));
      different += !same;
    }
    CHECK(met > 2000);
    CHECK(different <= 2);  // 99.99 %
  }
}

TEST_CASE("Paths: in a white furnace nothing is darker or brighter than its walls, whatever stands in it", "[gl]") {
  test::Studio studio;
  const Surface surfaces[] = {
      {"rough metal", [](scene::Material& m) { m.metallicFactor = 1, m.perceptualRoughnessFactor = 0.8f; }},
      {"smooth metal", [](scene::Material& m) { m.metallicFactor = 1, m.perceptualRoughnessFactor = 0.1f; }},
      {"dielectric", [](scene::Material& m) { m.metallicFactor = 0, m.perceptualRoughnessFactor = 0.4f; }},
      {"lambert", [](scene::Material& m) { lambert(m, 1); }},
      {"thin wall",
       [](scene::Material& m) { m.metallicFactor = 0, m.transmissionFactor = 1, m.perceptualRoughnessFactor = 0.3f; }},
      {"glass",
       [](scene::Material& m) {
         m.metallicFactor = 0, m.transmissionFactor = 1, m.thicknessFactor = 1, m.perceptualRoughnessFactor = 0;
       }},
      {"diffuse transmission", [](scene::Material& m) { m.metallicFactor = 0, m.diffuseTransmissionFactor = 0.6f; }},
  };
  for (const Surface& surface : surfaces) {
    // Two spheres, one in the other's way, and a bowl that holds light together: the inside of a box without a lid.
    GltfBuilder builder = emptyScene();
    const int white = builder.append("materials", test::material({1, 1, 1, 1}));
    test::addMeshNode(builder, test::addSphere(builder, 0.5, 24, 48), white, at(-0.4, 0, 0));
    test::addMeshNode(builder, test::addSphere(builder, 0.5, 24, 48), white, at(0.4, 0, -0.6));
    test::addOrthographicCamera(builder, 1, 0.6);
    io::LoadedModel model = test::loadBuilt(builder);
    surface.apply(model.model.materials[0]);
    const frame::Picture picture = studio.render(model, tracedSettings(40, 24, 256));
    const glm::dvec3 mean = meanOf(picture.radiance);
    INFO(surface.name << ": " << mean.x << " " << mean.y << " " << mean.z);
    CHECK(picture.statistics.nonFinitePixels == 0);
    const double margin = std::string(surface.name) == "lambert" ? 0.005 : 0.02;
    for (int c = 0; c < 3; ++c) CHECK(mean[c] == Approx(1).margin(margin));
  }
}

TEST_CASE("Paths: a closed room whose walls all glow has E / (1 - albedo), in any shape", "[gl]") {
  test::Studio studio;
  for (const float albedo : {0.0f, 0.5f, 0.8f}) {
    GltfBuilder builder = emptyScene();
    const int wall = builder.append("materials", test::material({1, 1, 1, 1}));
    test::addMeshNode(builder, addBox(builder, {2, 1, 3}, true), wall);
    test::addMeshNode(builder, test::addSphere(builder, 0.4, 16, 32), wall, at(0.5, 0, -1));
    builder.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.2}, {"znear", 0.01}}}});
    const int camera = builder.append("nodes", {{"camera", 0}, {"translation", {0, 0, 2}}});
    builder.json["scenes"][0]["nodes"].push_back(camera);
    io::LoadedModel model = test::loadBuilt(builder);
    lambert(model.model.materials[0], albedo);
    model.model.materials[0].emissiveFactor = {0.5f, 0.25f, 1};
    const frame::Picture picture = studio.render(model, tracedSettings(24, 24, 64, "none"));
    const glm::dvec3 mean = meanOf(picture.radiance), expected = glm::dvec3(0.5, 0.25, 1) / (1 - double(albedo));
    INFO("albedo " << albedo);
    for (int c = 0; c < 3; ++c) CHECK(mean[c] == Approx(expected[c]).epsilon(0.005));
  }
}

TEST_CASE("Paths: a single convex body looks as the sampled picture without visibility shows it", "[gl]") {
  test::Studio studio;
  const Surface surfaces[] = {
      {"metal", [](scene::Material& m) { m.metallicFactor = 1, m.perceptualRoughnessFactor = 0.3f; }},
      {"dielectric", [](scene::Material& m) { m.metallicFactor = 0, m.perceptualRoughnessFactor = 0.5f; }},
      {"clearcoat",
       [](scene::Material& m) { m.metallicFactor = 0, m.clearcoatFactor = 1, m.clearcoatRoughnessFactor = 0.2f; }},
      {"sheen",
       [](scene::Material& m) {
         m.metallicFactor = 0, m.sheenColorFactor = {1, 0.5f, 0.2f}, m.sheenRoughnessFactor = 0.5f;
       }},
      {"iridescence",
       [](scene::Material& m) { m.metallicFactor = 0, m.perceptualRoughnessFactor = 0.3f, m.iridescenceFactor = 1; }},
      {"specular",
       [](scene::Material& m) {
         m.metallicFactor = 0, m.ior = 2, m.specularColorFactor = {1, 0.4f, 0.2f}, m.perceptualRoughnessFactor = 0.3f;
       }},
  };
  for (const Surface& surface : surfaces) {
    GltfBuilder builder = emptyScene();
    test::addMeshNode(builder, test::addSphere(builder, 0.5, 96, 192),
                      builder.append("materials", test::material({0.8, 0.5, 0.3, 1})));
    test::addOrthographicCamera(builder, 0.4, 0.4);  // not its rim, where normals and faces part
    io::LoadedModel model = test::loadBuilt(builder);
    surface.apply(model.model.materials[0]);
    PictureSettings settings = tracedSettings(24, 24, 256, "builtin:studio");
    const glm::dvec3 traced = meanOf(studio.render(model, settings).radiance);
    settings.quality.transport = frame::Transport::direct;
    const glm::dvec3 sampled = meanOf(studio.render(model, settings).radiance);
    INFO(surface.name);
    // What a sheen leaves for its base hangs on the light's direction, too; distant light takes that of the view alone.
    const double margin = std::string(surface.name) == "sheen" ? 0.1 : 0.015;
    for (int c = 0; c < 3; ++c) CHECK(traced[c] == Approx(sampled[c]).epsilon(margin));
  }
}

TEST_CASE("Paths: lights cast shadows, and beside them all is as without", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  const int grey = builder.append("materials", test::material({0.5, 0.5, 0.5, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), grey);
  test::addMeshNode(builder, test::addQuad(builder, {-0.2, -0.2}, {0.2, 0.2}), grey, at(0, 0, 0.5));
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel model = test::loadBuilt(builder);
  lambert(model.model.materials[0], 0.5f);
  // Straight above lies the small square: its shadow is twice as large on the plane, from a point at twice its height.
  test::addPointLight(model.model, 4, {0, 0, 1});
  PictureSettings settings = tracedSettings(40, 40, 16, "none");
  settings.quality.bounces = 1;
  const frame::Picture traced = studio.render(model, settings);
  settings.quality.transport = frame::Transport::direct;
  const frame::Picture direct = studio.render(model, settings);
  const auto both = [&](int x, int y) {
    return glm::vec2(test::pixel(traced.radiance, x, y).x, test::pixel(direct.radiance, x, y).x);
  };
  for (const int x : {13, 14, 26}) {  // between the square (16 to 24) and its shadow's edge (12 to 28)
    CHECK(both(x, 20).x == 0);
    CHECK(both(x, 20).y > 0.1f);
  }
  for (const glm::ivec2 lit : {glm::ivec2(5, 20), glm::ivec2(34, 3), glm::ivec2(20, 20), glm::ivec2(9, 9)})
    CHECK(both(lit.x, lit.y).x == Approx(both(lit.x, lit.y).y).epsilon(0.01));
}

TEST_CASE("Paths: a glass plate as the sum over its inner reflections says, with and without absorption", "[gl]") {
  test::Studio studio;
  for (const float left : {1.0f, 0.5f, 0.1f}) {
    GltfBuilder builder = emptyScene();
    test::addMeshNode(builder, addBox(builder, {40, 40, 0.5}, false),
                      builder.append("materials", test::material({1, 1, 1, 1})));
    test::addOrthographicCamera(builder, 0.1, 0.1);
    io::LoadedModel model = test::loadBuilt(builder);
    scene::Material& glass = model.model.materials[0];
    glass.metallicFactor = 0, glass.perceptualRoughnessFactor = 0;
    glass.transmissionFactor = 1, glass.thicknessFactor = 1, glass.ior = 1.5f;
    glass.attenuationColor = {left, 1, left}, glass.attenuationDistance = 1;
    const glm::dvec3 got = meanOf(studio.render(model, tracedSettings(16, 16, 1024)).radiance);
    const double R = 0.04;
    for (int c = 0; c < 3; ++c) {
      const double T = c == 1 ? 1 : double(left);  // of one way through
      const double reflected = R + (1 - R) * (1 - R) * R * T * T / (1 - R * R * T * T);
      const double passed = (1 - R) * (1 - R) * T / (1 - R * R * T * T);
      INFO("left " << left << " channel " << c);
      CHECK(got[c] == Approx(reflected + passed).epsilon(0.01));
    }
  }
}

TEST_CASE("Paths: masks and coverage let through what they leave", "[gl]") {
  test::Studio studio;
  const auto render = [&](const nlohmann::json& extra, float alpha) {
    GltfBuilder builder = emptyScene();
    nlohmann::json cover = glowing({1, 0, 0, alpha}, extra);
    test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), builder.append("materials", cover),
                      at(0, 0, 1));
    test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                      builder.append("materials", glowing({0, 0.5, 0, 1})));
    test::addOrthographicCamera(builder, 1, 1);
    return meanOf(studio.render(test::loadBuilt(builder), tracedSettings(16, 16, 64, "none")).radiance);
  };
  CHECK(render({{"alphaMode", "MASK"}}, 0.4f).x == 0);
  CHECK(render({{"alphaMode", "MASK"}}, 0.4f).y == Approx(0.5));
  CHECK(render({{"alphaMode", "MASK"}}, 0.6f).x == Approx(1));
  CHECK(render({{"alphaMode", "MASK"}}, 0.6f).y == 0);
  for (const float alpha : {0.0f, 0.25f, 0.8f, 1.0f}) {
    const glm::dvec3 mixed = render({{"alphaMode", "BLEND"}}, alpha);
    CHECK(mixed.x == Approx(double(alpha)).margin(0.01));
    CHECK(mixed.y == Approx(0.5 * (1 - double(alpha))).margin(0.01));
  }
}

TEST_CASE("Paths: the camera sees no back of what has one side, mirrored or not", "[gl]") {
  test::Studio studio;
  const auto render = [&](bool doubleSided, bool mirrored, bool turned) {
    GltfBuilder builder = emptyScene();
    nlohmann::json cover = glowing({1, 0, 0, 1});
    cover["doubleSided"] = doubleSided;
    nlohmann::json place = at(0, 0, 1);
    place["scale"] = {mirrored ? -1 : 1, 1, 1};
    if (turned) place["rotation"] = {0, 1, 0, 0};
    test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), builder.append("materials", cover), place);
    test::addOrthographicCamera(builder, 0.5, 0.5);
    PictureSettings settings = tracedSettings(8, 8, 1, "none");
    const frame::Picture traced = studio.render(test::loadBuilt(builder), settings);
    settings.quality.transport = frame::Transport::direct;
    const frame::Picture drawn = studio.render(test::loadBuilt(builder), settings);
    CHECK(test::pixel(traced.radiance, 4, 4) == test::pixel(drawn.radiance, 4, 4));
    return test::pixel(traced.radiance, 4, 4).x;
  };
  for (const bool mirrored : {false, true}) {
    CHECK(render(false, mirrored, false) == 1);
    CHECK(render(false, mirrored, true) == 0);
    CHECK(render(true, mirrored, true) == 1);
  }
}

TEST_CASE("Paths: skins, morph targets and many instances stand where they are drawn", "[gl]") {
  // They shine by themselves, so that the silhouette is all.
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  const int red = builder.append("materials", glowing({1, 0.2f, 0, 1}));
  const nlohmann::json ball = test::addSphere(builder, 0.1, 24, 48);
  const int first = test::addMeshNode(builder, ball, red, at(-1, -1, 0));
  const int mesh = builder.json["nodes"][size_t(first)]["mesh"];
  for (int i = 0; i < 60; ++i) {  // too many copies for triangles of their own
    nlohmann::json node = at(-1 + 0.3 * (i % 8), -1 + 0.3 * (i / 8), 0.2 * (i % 3));
    node["mesh"] = mesh;
    node["scale"] = {i % 2 ? -1.5 : 1, 1, 0.5};
    builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", node));
  }
  test::addOrthographicCamera(builder, 1.5, 1.5);
  // A sphere that a target moves and stretches, and one that a joint has taken elsewhere.
  test::addMeshNode(builder, test::addSphere(builder, 0.2, 24, 48), red, at(0.9, 0.6, 0));
  test::addMeshNode(builder, test::addSphere(builder, 0.2, 24, 48), red, at(0.5, 0.5, 0));
  io::LoadedModel model = test::loadBuilt(builder);
  scene::Mesh& morphed = model.model.meshes[model.model.meshes.size() - 2];
  scene::MorphTarget target;
  for (const glm::vec3& p : morphed.primitives[0].positions) target.positions.push_back({0.2f - p.x, 2 * p.y, 0});
  for (const glm::vec3& p : target.positions) target.bounds.add(p);
  morphed.primitives[0].targets = {target};
  morphed.weights = {0.7f};
  scene::Primitive& skinned = model.model.meshes.back().primitives[0];
  skinned.influences.assign(skinned.positions.size(), {0, 1});
  skinned.influencesPerVertex = 1;
  skinned.jointBounds = {skinned.bounds};
  scene::Node joint;
  joint.translation = {0.3, 1.1, 0}, joint.scale = {-1, 0.5, 1};
  model.model.nodes.push_back(joint);
  const int jointNode = static_cast<int>(model.model.nodes.size()) - 1;
  model.model.scenes[0].nodes.push_back(jointNode);
  model.model.skins.push_back({"", {jointNode}, {}});
  for (scene::Node& node : model.model.nodes)
    if (node.mesh == static_cast<int>(model.model.meshes.size()) - 1) node.skin = 0;
  PictureSettings settings = tracedSettings(64, 64, 64, "none");
  const frame::Picture traced = studio.render(model, settings);
  REQUIRE(traced.statistics.traced);
  CHECK(traced.statistics.traced->triangles < 8000);  // once for all
  settings.quality.transport = frame::Transport::direct;
  const frame::Picture drawn = studio.render(model, settings);
  double squares = 0;
  for (size_t i = 0; i < drawn.radiance.pixels.size(); ++i)
    squares += std::pow(double(traced.radiance.pixels[i].x - drawn.radiance.pixels[i].x), 2);
  CHECK(std::sqrt(squares / double(drawn.radiance.pixels.size())) < 0.02);  // edges, by other samples
}

TEST_CASE("Paths: the same bytes for the same wish, and none of it where nothing is traced", "[gl]") {
  test::Studio studio;
  const io::LoadedModel model = test::loadBuiltin("builtin:spheres");
  PictureSettings settings = tracedSettings(32, 32, 4, "builtin:studio");
  settings.viewpoint.camera.clear();
  const frame::Picture once = studio.render(model, settings), again = studio.render(model, settings);
  CHECK(once.display.data == again.display.data);
  CHECK(once.statistics.frame.passes.front() == "paths");
  settings.quality.transport = frame::Transport::direct;
  CHECK(studio.render(model, settings).statistics.frame.passes.front() == "opaque");

  // Nothing is lit: no trees, no rays.
  GltfBuilder builder = emptyScene();
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                    builder.append("materials", test::unlit({1, 0.5f, 0, 1})));
  test::addOrthographicCamera(builder, 0.5, 0.5);
  const frame::Picture unlit = studio.render(test::loadBuilt(builder), tracedSettings(8, 8, 2));
  CHECK_FALSE(unlit.statistics.traced);
  CHECK(unlit.statistics.frame.rays == 0);
  CHECK(test::pixel(unlit.radiance, 4, 4) == glm::vec4(1, 0.5f, 0, 1));
}
