// Skins and morph targets in pictures, against the same vertices in double precision.

#include <catch2/catch.hpp>
#include <cmath>

#include "frame/draw_list.hpp"
#include "scene/animation.hpp"
#include "scene/deformation.hpp"
#include "scene/geometry.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

constexpr int size = 64;  // pixels; the camera sees [-2, 2]^2

// White unlit quads of 0.25 m, one for each centre; vertex i belongs to quad i / 4.
scene::Primitive quads(const std::vector<glm::vec3>& centers) {
  scene::Primitive p;
  for (const glm::vec3& c : centers) {
    const auto first = static_cast<uint32_t>(p.positions.size());
    for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)})
      p.positions.push_back(c + glm::vec3(corner * 0.125f, 0));
    for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) p.indices.push_back(first + i);
  }
  p.material = 0;
  return p;
}

scene::Node cameraNode() {
  scene::Node node;
  node.translation = {0, 0, 10};
  node.camera = 0;
  return node;
}

// One mesh on node 0, seen by an orthographic camera on node 1.
io::LoadedModel modelOf(scene::Primitive primitive) {
  io::LoadedModel loaded;
  scene::Model& model = loaded.model;
  scene::Material white;
  white.unlit = true;
  white.doubleSided = true;
  model.materials = {white};
  model.meshes = {{"mesh", {std::move(primitive)}}};
  scene::Camera camera;
  camera.perspective = false;
  camera.xMag = camera.yMag = 2, camera.zNear = 1, camera.zFar = 100;
  model.cameras = {camera};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  model.nodes.push_back(cameraNode());
  model.scenes = {{"", {0, 1}}};
  return loaded;
}

frame::PictureSettings settings() {
  frame::PictureSettings s = test::bareSettings(size, size);
  s.viewpoint.camera = "0";
  return s;
}

void addJoint(io::LoadedModel& loaded, const glm::dvec3& translation, int parent) {
  scene::Model& model = loaded.model;
  const auto index = static_cast<int>(model.nodes.size());
  scene::Node node;
  node.translation = translation;
  node.parent = parent;
  model.nodes.push_back(node);
  if (parent >= 0)
    model.nodes[static_cast<size_t>(parent)].children.push_back(index);
  else
    model.scenes[0].nodes.push_back(index);
}

// Every quad's middle is drawn where its four vertices, deformed in double precision, say; nothing else is drawn.
void checkQuads(const io::LoadedModel& loaded, const frame::Picture& picture, const scene::Pose& pose) {
  const scene::Model& model = loaded.model;
  const scene::FlatScene flat = scene::flatten(model, 0, pose);
  REQUIRE(flat.instances.size() == 1);
  const scene::Instance& instance = flat.instances[0];
  std::span<const glm::dmat4> joints;
  if (instance.skin >= 0) joints = flat.joints[static_cast<size_t>(instance.skin)];
  const scene::Primitive& p = model.meshes[0].primitives[0];
  const std::vector<float> weights = scene::morphWeights(model.meshes[0], pose.nodes.of(model.nodes, 0));
  for (size_t quad = 0; quad < p.positions.size() / 4; ++quad) {
    glm::dvec3 middle(0);
    for (size_t i = 0; i < 4; ++i)
      middle += 0.25 * scene::deformedPosition(p, 4 * quad + i, weights, joints, instance.worldFromNode);
    const int x = static_cast<int>(std::floor((middle.x + 2) / 4 * size));
    const int y = static_cast<int>(std::floor((2 - middle.y) / 4 * size));
    INFO("quad " << quad << " at " << middle.x << ", " << middle.y);
    REQUIRE(x >= 2);
    REQUIRE(x < size - 2);
    CHECK(test::pixel(picture.radiance, x, y).w == 1);
    CHECK(test::pixel(picture.radiance, x - 4, y).w == 0);
    CHECK(test::pixel(picture.radiance, x + 4, y).w == 0);
  }
  int covered = 0;
  for (const glm::vec4& pixel : picture.radiance.pixels) covered += pixel.w > 0;
  // 4 x 4 pixels each, a row or column more where an edge falls between pixels.
  CHECK(covered >= static_cast<int>(p.positions.size() / 4) * 9);
  CHECK(covered <= static_cast<int>(p.positions.size() / 4) * 25);
}

scene::Animation turning(int node, double degrees) {
  const auto half = static_cast<float>(glm::radians(degrees) / 2);
  scene::Animation animation;
  animation.name = "turn";
  animation.samplers = {{scene::Interpolation::linear, {0, 2}, {0, 0, 0, 1, 0, 0, std::sin(half), std::cos(half)}, 4}};
  animation.channels = {{0, scene::AnimatedProperty::rotation, node, {}}};
  return animation;
}

}  // namespace

TEST_CASE("Deformation: an arm of two joints bends as in double precision, weights shared and joints nested") {
  scene::Primitive p = quads({{0.5, 0, 0}, {1, 0, 0}, {1.5, 0, 0}});
  p.influencesPerVertex = 2;
  for (size_t v = 0; v < p.positions.size(); ++v) {
    const float elbow[] = {0, 0.5f, 1};
    const float w = elbow[v / 4];
    if (w > 0.4f && w < 0.6f)
      p.influences.insert(p.influences.end(), {{0, 0.5f}, {1, 0.5f}});
    else
      p.influences.insert(p.influences.end(), {{w > 0 ? 1u : 0u, 1.0f}, {0, 0.0f}});
  }
  p.jointBounds = {{glm::dvec3(0), glm::dvec3(2, 1, 1)}, {glm::dvec3(0, -1, -1), glm::dvec3(2, 1, 1)}};
  io::LoadedModel loaded = modelOf(p);
  addJoint(loaded, {0, 0, 0}, -1);  // node 2: shoulder
  addJoint(loaded, {1, 0, 0}, 2);   // node 3: elbow
  loaded.model.nodes[0].skin = 0;
  loaded.model.nodes[0].translation = {5, 5, 5};  // must not matter
  loaded.model.skins = {{"arm", {2, 3}, {glm::dmat4(1), glm::dmat4(1)}}};
  loaded.model.skins[0].inverseBindMatrices[1][3] = glm::dvec4(-1, 0, 0, 1);
  loaded.model.animations = {turning(3, 90)};

  test::Studio studio;
  frame::PictureSettings s = settings();
  checkQuads(loaded, studio.render(loaded, s), {});
  s.placement.animation = "turn";
  for (const double time : {0.0, 1.0, 2.0, 99.0}) {
    s.placement.timeSeconds = time;
    checkQuads(loaded, studio.render(loaded, s), scene::poseAt(loaded.model, std::vector{0}, time));
  }
  // In closed form: at the end the outer quad, half a metre beyond the elbow, stands above it.
  CHECK(test::pixel(studio.render(loaded, s).radiance, size * 3 / 4, size * 3 / 8).w == 1);
}

TEST_CASE("Deformation: more joints than any uniform block holds") {
  constexpr uint32_t count = 5000;
  scene::Primitive p = quads({{0, 0, 0}});
  p.influencesPerVertex = 1;
  p.influences.assign(p.positions.size(), {count - 1, 1});
  p.jointBounds.resize(count);
  p.jointBounds[count - 1] = {glm::dvec3(-1), glm::dvec3(1)};
  io::LoadedModel loaded = modelOf(p);
  for (uint32_t i = 0; i < count; ++i) addJoint(loaded, {i == count - 1 ? -1 : 50, 1, 0}, -1);
  loaded.model.nodes[0].skin = 0;
  scene::Skin skin;
  for (uint32_t i = 0; i < count; ++i) skin.joints.push_back(static_cast<int>(2 + i));
  loaded.model.skins = {skin};
  checkQuads(loaded, test::Studio().render(loaded, settings()), {});
}

TEST_CASE("Deformation: morph targets add up by weight, those of weight 0 are not read") {
  scene::Primitive p = quads({{0, 0, 0}, {0, 1, 0}});
  scene::MorphTarget right, up, none;
  right.positions.assign(8, glm::vec3(1, 0, 0));
  up.positions.assign(8, glm::vec3(0));
  for (size_t i = 4; i < 8; ++i) up.positions[i] = glm::vec3(0, 1, 0);
  none.normals.assign(8, glm::vec3(0, 0, 1));
  p.targets = {right, none, up};
  io::LoadedModel loaded = modelOf(p);
  loaded.model.meshes[0].weights = {0.5f, 1, 0};
  Notes notes;
  scene::completeGeometry(loaded.model, notes);
  test::Studio studio;
  checkQuads(loaded, studio.render(loaded, settings()), {});
  loaded.model.nodes[0].weights = {-1.25f, 0, 0.5f};
  checkQuads(loaded, studio.render(loaded, settings()), {});
  // In closed form: the second quad from (0, 1) to (-1.25, 1.5).
  CHECK(test::pixel(studio.render(loaded, settings()).radiance, 12, 8).w == 1);
}

TEST_CASE("Deformation: weights move colours and normals, and flat triangles stay flat") {
  scene::Primitive p = quads({{0, 0, 0}});
  p.colors.assign(4, glm::vec4(0.25f, 0.5f, 0.75f, 1));
  scene::MorphTarget target;
  target.colors.assign(4, glm::vec4(0.5f, -0.25f, 1, 0));
  // The right edge comes 0.25 m nearer: the quad turns by 45 degrees about y.
  target.positions = {glm::vec3(0), glm::vec3(0, 0, 0.25f), glm::vec3(0, 0, 0.25f), glm::vec3(0)};
  p.targets = {target};
  io::LoadedModel loaded = modelOf(p);
  loaded.model.meshes[0].weights = {1};
  test::Studio studio;
  test::checkPixel(test::pixel(studio.render(loaded, settings()).radiance, size / 2, size / 2),
                   {0.75f, 0.25f, 1, 1});  // the sum is clamped to [0, 1]

  loaded.model.materials[0].unlit = false;
  Notes notes;
  scene::completeGeometry(loaded.model, notes);
  frame::PictureSettings s = settings();
  s.look.channel = "normal";
  const float half = std::sqrt(0.5f);
  test::checkPixel(test::pixel(studio.render(loaded, s).radiance, size / 2, size / 2),
                   {-half * 0.5f + 0.5f, 0.5f, half * 0.5f + 0.5f, 1}, 2e-3f);
}

TEST_CASE("Deformation: a draw that reads less than the buffer holds finds its numbers all the same") {
  scene::Primitive p = quads({{0, 0, 0}});
  p.colors.assign(4, glm::vec4(1));
  scene::MorphTarget target;
  target.positions.assign(4, glm::vec3(1, 0, 0));
  target.colors.assign(4, glm::vec4(-0.5f, 0, 0, 0));
  p.targets = {target, target};
  io::LoadedModel loaded = modelOf(p);
  loaded.model.meshes[0].weights = {0.5f, 0.5f};
  Notes notes;
  scene::completeGeometry(loaded.model, notes);
  frame::LoadedScene onGpu = test::sceneOf(loaded);
  test::Studio studio;
  frame::PictureSettings s = settings();
  // All attributes first, then a view that does not read the colours.
  test::checkPixel(test::pixel(studio.render(onGpu, s).radiance, size * 3 / 4, size / 2), {0.5f, 1, 1, 1});
  s.look.channel = "uv";
  CHECK(test::pixel(studio.render(onGpu, s).radiance, size * 3 / 4, size / 2).w == 1);
  CHECK(test::pixel(studio.render(onGpu, s).radiance, size / 2, size / 2).w == 0);
}

TEST_CASE("Deformation: what has no joints in a skinned mesh stays where its mesh is") {
  io::LoadedModel loaded = modelOf(quads({{0.5, 0, 0}}));
  scene::Primitive rigid = quads({{1.5, 0, 0}});
  scene::Primitive& skinned = loaded.model.meshes[0].primitives[0];
  skinned.influencesPerVertex = 1;
  skinned.influences.assign(4, {0, 1.0f});
  loaded.model.meshes[0].primitives.push_back(rigid);
  addJoint(loaded, {0, 0, 0}, -1);
  loaded.model.nodes[0].skin = 0;
  loaded.model.skins = {{"one", {2}, {}}};
  Notes notes;
  scene::completeGeometry(loaded.model, notes);
  const frame::Picture picture = test::Studio().render(loaded, settings());
  CHECK(test::pixel(picture.radiance, size * 5 / 8, size / 2).w == 1);
  CHECK(test::pixel(picture.radiance, size * 7 / 8, size / 2).w == 1);
}
