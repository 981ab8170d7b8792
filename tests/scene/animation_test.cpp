#include "scene/animation.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "base/angle.hpp"
#include "scene/nodes.hpp"
#include "support/not_a_number.hpp"

using namespace facet;
using namespace facet::scene;

using facet::test::notANumber;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

AnimationSampler sampler(Interpolation interpolation, int width, std::vector<float> times, std::vector<float> values) {
  return {interpolation, std::move(times), std::move(values), width};
}

std::vector<double> at(const AnimationSampler& s, double time, bool isRotation = false) {
  std::vector<double> out(size_t(s.width));
  sampleAt(s, time, isRotation, out);
  return out;
}

// Rotation about z as x, y, z, w.
std::array<float, 4> aboutZ(double angle) { return {0, 0, float(std::sin(angle / 2)), float(std::cos(angle / 2))}; }

AnimationSampler rotations(std::initializer_list<std::array<float, 4>> keys,
                           Interpolation how = Interpolation::linear) {
  AnimationSampler s{how, {}, {}, 4};
  for (const auto& key : keys) {
    s.times.push_back(float(s.times.size()));
    s.values.insert(s.values.end(), key.begin(), key.end());
  }
  return s;
}

double angleAboutZ(const std::vector<double>& q) { return 2 * std::atan2(q[2], q[3]); }

double length(const std::vector<double>& q) { return std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]); }

// One animation with one channel whose value stays.
Model constant(Model model, AnimatedProperty property, std::vector<float> value,
               TextureSlot slot = TextureSlot::baseColor) {
  const int width = int(value.size());
  model.animations.push_back(
      {"", {sampler(Interpolation::linear, width, {0}, std::move(value))}, {{0, property, 0, slot}}});
  return model;
}

Pose only(const Model& model, double time = 0) { return poseAt(model, std::array{0}, time); }

}  // namespace

TEST_CASE("Step and linear samplers between, before and after their keys") {
  const AnimationSampler linear = sampler(Interpolation::linear, 2, {1, 3, 4}, {10, -1, 20, -2, 0, 5});
  AnimationSampler step = linear;
  step.interpolation = Interpolation::step;
  using V = std::vector<double>;
  struct Row {
    double time;
    V linear, step;
  };
  const Row rows[] = {
      {1.5, {12.5, -1.25}, {10, -1}},
      {3, {20, -2}, {20, -2}},
      {2.999, {19.995, -1.9995}, {10, -1}},
      {3.75, {5, 3.25}, {20, -2}},
      {0, {10, -1}, {10, -1}},
      {-1e30, {10, -1}, {10, -1}},
      {5, {0, 5}, {0, 5}},
      {1e30, {0, 5}, {0, 5}},
      {infinity, {0, 5}, {0, 5}},
      {notANumber, {10, -1}, {10, -1}},
      {-infinity, {10, -1}, {10, -1}},
  };
  for (const Row& row : rows) {
    CAPTURE(row.time);
    for (size_t i = 0; i < 2; ++i) {
      CHECK(at(linear, row.time)[i] == Approx(row.linear[i]).epsilon(1e-14));
      CHECK(at(step, row.time)[i] == row.step[i]);
    }
  }
}

TEST_CASE("A single key holds at all times") {
  const double time = GENERATE(-1.0, 0.5, 2.0, 1e300, notANumber);
  CHECK(at(sampler(Interpolation::linear, 1, {0.5f}, {7}), time)[0] == 7);
  CHECK(at(sampler(Interpolation::step, 1, {0.5f}, {7}), time)[0] == 7);
  CHECK(at(sampler(Interpolation::cubicSpline, 1, {0.5f}, {3, 7, 5}), time)[0] == 7);
}

TEST_CASE("Keys that lie next to each other in single precision are still apart") {
  const float t = 1e30f;
  const auto s = sampler(Interpolation::linear, 1, {t, std::nextafter(t, 2e30f)}, {0, 1});
  const double middle = (double(s.times[0]) + double(s.times[1])) / 2;
  CHECK(at(s, middle)[0] == 0.5);
  const float d = std::numeric_limits<float>::denorm_min();
  CHECK(at(sampler(Interpolation::cubicSpline, 1, {0, d}, {0, 1, 0, 0, 3, 0}), d / 2.0)[0] == Approx(2));
}

TEST_CASE("A cubic spline takes the value worked out by hand") {
  // From 1 at 2 s with slope 3 per second to 5 at 4 s with slope -1. At a quarter (2.5 s), Hermite's weights are
  // 54/64, 9/64, 10/64 and -3/64: 0.84375 * 1 + 2 * 0.140625 * 3 + 0.15625 * 5 + 2 * -0.046875 * -1 = 2.5625.
  const auto s = sampler(Interpolation::cubicSpline, 1, {2, 4}, {100, 1, 3, -1, 5, 200});
  CHECK(at(s, 2.5)[0] == 2.5625);
  CHECK(at(s, 3)[0] == 4);  // (1 + 5) / 2 + 2 (3 - -1) / 8
  CHECK(at(s, 2)[0] == 1);
  CHECK(at(s, 4)[0] == 5);
  CHECK(at(s, 1)[0] == 1);
  CHECK(at(s, 9)[0] == 5);
  // Slopes at the keys, by differences.
  const double h = 1e-6;
  CHECK((at(s, 2 + h)[0] - 1) / h == Approx(3).margin(1e-5));
  CHECK((5 - at(s, 4 - h)[0]) / h == Approx(-1).margin(1e-5));
}

TEST_CASE("A cubic through a cubic is that cubic, in each of its numbers and pieces") {
  // p(t) = t^3 - 2 t and q(t) = 4 - t^2 at 0, 1, 3 seconds.
  const auto s = sampler(Interpolation::cubicSpline, 2, {0, 1, 3},
                         {-2, 0, 0, 4, -2, 0, 1, -2, -1, 3, 1, -2, 25, -6, 21, -5, 25, -6});
  for (const double t : {0.0, 0.3, 0.9, 1.0, 1.7, 2.9, 3.0}) {
    CHECK(at(s, t)[0] == Approx(t * t * t - 2 * t).margin(1e-13));
    CHECK(at(s, t)[1] == Approx(4 - t * t).margin(1e-13));
  }
}

TEST_CASE("Rotations turn at constant speed along the shortest way") {
  const auto quarter = rotations({aboutZ(0), aboutZ(pi / 2)});
  CHECK(angleAboutZ(at(quarter, 0.25, true)) == Approx(pi / 8).epsilon(1e-7));
  CHECK(angleAboutZ(at(quarter, 0.75, true)) == Approx(3 * pi / 8).epsilon(1e-7));

  // The same rotations, the second one written with the other sign: the dot product is negative.
  std::array<float, 4> other = aboutZ(pi / 2);
  for (float& x : other) x = -x;
  CHECK(angleAboutZ(at(rotations({aboutZ(0), other}), 0.25, true)) == Approx(pi / 8).epsilon(1e-7));

  // 350 degrees ahead is 10 degrees back.
  CHECK(angleAboutZ(at(rotations({aboutZ(0), aboutZ(350 * pi / 180)}), 0.5, true)) ==
        Approx(-5 * pi / 180).epsilon(1e-6));

  // Without isRotation the numbers are just numbers.
  CHECK(at(quarter, 0.5)[3] == Approx((1 + std::sqrt(0.5)) / 2));
}

TEST_CASE("Rotations that are nearly equal, opposite, half a turn apart, unnormalised or nothing") {
  const std::array<float, 4> identity = {0, 0, 0, 1};
  SECTION("an angle of 2e-20, far below the epsilon of cosines") {
    const auto q = at(rotations({identity, {0, 0, 1e-20f, 1}}), 0.25, true);
    CHECK(q[2] == Approx(0.25e-20).epsilon(1e-6));
    CHECK(q[3] == 1);
  }
  SECTION("opposite signs are the same rotation") {
    const auto q = at(rotations({{0.6f, 0, 0, 0.8f}, {-0.6f, 0, 0, -0.8f}}), 0.3, true);
    CHECK(q[0] == Approx(0.6));
    CHECK(q[3] == Approx(0.8));
  }
  SECTION("half a turn has no shortest way but has its middle on one of them") {
    const auto q = at(rotations({identity, {0, 0, 1, 0}}), 0.5, true);
    CHECK(std::abs(angleAboutZ(q)) == Approx(pi / 2));
  }
  SECTION("every result has unit length") {
    for (const Interpolation how : {Interpolation::step, Interpolation::linear})
      for (const double t : {-1.0, 0.0, 0.3, 1.0, 5.0})
        CHECK(length(at(rotations({{0, 0, 0, 2}, {3e-30f, 4e-30f, 0, 0}}, how), t, true)) == Approx(1).epsilon(1e-14));
    const auto spline = sampler(Interpolation::cubicSpline, 4, {0, 1},
                                {0, 0, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 0, 0, 9, 0, 0, 0, 1, 0, 0, 0, 0, 0});
    for (const double t : {-1.0, 0.0, 0.3, 0.5, 1.0}) CHECK(length(at(spline, t, true)) == Approx(1).epsilon(1e-14));
  }
  SECTION("a result without length is the identity") {
    CHECK(at(rotations({{0, 0, 0, 0}}), 0, true) == std::vector<double>{0, 0, 0, 1});
    // A spline from q to -q without slopes passes through 0 at half time.
    const auto spline = sampler(Interpolation::cubicSpline, 4, {0, 1},
                                {0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 0, 0, 0, 0, 0, 0});
    CHECK(at(spline, 0.5, true) == std::vector<double>{0, 0, 0, 1});
  }
}

TEST_CASE("An animation lasts until its last channel's last key") {
  Animation animation;
  CHECK(duration(animation) == 0);
  animation.samplers = {sampler(Interpolation::step, 1, {0, 2.5f}, {0, 0}), sampler(Interpolation::step, 1, {4}, {0}),
                        sampler(Interpolation::step, 1, {9}, {0})};
  animation.channels = {{0}, {1}};
  CHECK(duration(animation) == 4);  // no channel uses the third
}

TEST_CASE("Animations are chosen by name, index or all together") {
  Model model;
  model.name = "m.gltf";
  model.animations.resize(4);
  model.animations[0].name = "Walk";
  model.animations[1].name = "0";
  model.animations[3].name = "Walk";
  using V = std::vector<int>;
  CHECK(*chooseAnimations(model, "") == V{});
  CHECK(*chooseAnimations(model, "Walk") == V{0});
  CHECK(*chooseAnimations(model, "0") == V{1});
  CHECK(*chooseAnimations(model, "2") == V{2});
  CHECK(*chooseAnimations(model, "all") == V{0, 1, 2, 3});
  for (const char* wrong : {"4", "-1", "2x", " 2", "99999999999999999999999"})
    CHECK_FALSE(chooseAnimations(model, wrong));
  CHECK(describe(chooseAnimations(model, "Run").error()) ==
        "m.gltf: there is no animation \"Run\"; choose all or one of 0 \"Walk\", 1 \"0\", 2, 3 \"Walk\".");
  model.animations.clear();
  CHECK(*chooseAnimations(model, "all") == V{});
  CHECK(describe(chooseAnimations(model, "Run").error()) == "m.gltf: there are no animations; leave out \"Run\".");
}

TEST_CASE("A node's translation, rotation, scale, weights and visibility follow their channels") {
  Model model;
  model.nodes.resize(2);
  model.nodes[1].scale = {5, 5, 5};
  Animation a;
  a.samplers = {sampler(Interpolation::linear, 3, {0, 2}, {0, 0, 0, 4, 8, 2}), rotations({aboutZ(0), aboutZ(pi / 2)}),
                sampler(Interpolation::linear, 3, {0, 2}, {1, 1, 1, -1, 3, 0}),
                sampler(Interpolation::linear, 3, {0, 2}, {0, 1, 2, 1, 0, -2}),
                sampler(Interpolation::linear, 1, {0, 1, 2}, {1, 0, 1})};
  a.channels = {{0, AnimatedProperty::translation, 0},
                {1, AnimatedProperty::rotation, 0},
                {2, AnimatedProperty::scale, 0},
                {3, AnimatedProperty::weights, 0},
                {4, AnimatedProperty::visible, 0}};
  model.animations = {a};
  const Pose pose = only(model, 0.5);
  const Node& node = pose.nodes.of(model.nodes, 0);
  CHECK(node.translation == glm::dvec3(1, 2, 0.5));
  CHECK(2 * std::atan2(node.rotation.z, node.rotation.w) == Approx(pi / 4).epsilon(1e-7));
  CHECK(node.scale == glm::dvec3(0.5, 1.5, 0.75));
  CHECK(node.weights == std::vector<float>{0.25f, 0.75f, 1});
  CHECK(node.visible);
  CHECK_FALSE(only(model, 1.5).nodes.of(model.nodes, 0).visible);  // jumps although the file says linear
  CHECK(only(model, 2).nodes.of(model.nodes, 0).visible);
  CHECK(pose.nodes.changed.size() == 1);
  CHECK(pose.nodes.of(model.nodes, 1).scale == glm::dvec3(5, 5, 5));
  CHECK(model.nodes[0].translation == glm::dvec3(0));
  CHECK(poseAt(model, {}, 1).nodes.changed.empty());
}

TEST_CASE("Of two animations of one property the later one wins") {
  Model model;
  model.nodes.resize(1);
  model = constant(model, AnimatedProperty::translation, {1, 0, 0});
  model = constant(model, AnimatedProperty::translation, {2, 0, 0});
  CHECK(poseAt(model, std::array{0, 1}, 0).nodes.of(model.nodes, 0).translation.x == 2);
  CHECK(poseAt(model, std::array{1, 0}, 0).nodes.of(model.nodes, 0).translation.x == 1);
}

TEST_CASE("An animated matrix keeps what is not animated") {
  Model model;
  model.nodes.resize(1);
  model.nodes[0].matrix = glm::translate(glm::dmat4(1), {1, 2, 3}) *
                          glm::rotate(glm::dmat4(1), 2.0, glm::normalize(glm::dvec3(1, -2, 3))) *
                          glm::scale(glm::dmat4(1), {-2, 3, 0.5});
  glm::dmat4 expected = *model.nodes[0].matrix;
  expected[3] = {9, 8, 7, 1};
  model = constant(model, AnimatedProperty::translation, {9, 8, 7});
  const glm::dmat4 moved = localTransform(only(model).nodes.of(model.nodes, 0));
  for (int c = 0; c < 4; ++c) CHECK(glm::distance(moved[c], expected[c]) < 1e-12);
  CHECK(model.nodes[0].matrix);

  model.animations[0] = {"", {sampler(Interpolation::step, 1, {0}, {0})}, {{0, AnimatedProperty::visible, 0}}};
  CHECK(only(model).nodes.of(model.nodes, 0).matrix);  // showing and hiding doesn't touch it
}

TEST_CASE("Pointers set materials, and values stay in range") {
  Model model;
  model.materials.resize(1);
  using P = AnimatedProperty;
  const auto material = [&](P property, std::vector<float> value, TextureSlot slot = TextureSlot::baseColor) {
    const Model animated = constant(model, property, std::move(value), slot);
    return only(animated).materials.of(animated.materials, 0);
  };
  CHECK(material(P::baseColorFactor, {0.1f, -1, 7, 0.5f}).baseColorFactor == glm::vec4(0.1f, 0, 1, 0.5f));
  CHECK(material(P::metallicFactor, {-0.5f}).metallicFactor == 0);
  CHECK(material(P::metallicFactor, {0.25f}).metallicFactor == 0.25f);
  CHECK(material(P::perceptualRoughnessFactor, {1.5f}).perceptualRoughnessFactor == 1);
  CHECK(material(P::emissiveFactor, {0.5f, -3, 2}).emissiveFactor == glm::vec3(0.5f, 0, 1));
  CHECK(material(P::emissiveStrength, {-2}).emissiveStrength == 0);
  CHECK(material(P::emissiveStrength, {200}).emissiveStrength == 200);
  CHECK(material(P::normalScale, {-2}).normalScale == -2);
  CHECK(material(P::occlusionStrength, {3}).occlusionStrength == 1);
  CHECK(material(P::alphaCutoff, {-3}).alphaCutoff == 0);
  CHECK(material(P::alphaCutoff, {1.1f}).alphaCutoff == 1.1f);
  CHECK(material(P::textureOffset, {3, -4}, TextureSlot::normal).normal.transform.offset == glm::vec2(3, -4));
  CHECK(material(P::textureRotation, {7}, TextureSlot::emissive).emissive.transform.rotation == 7);
  CHECK(material(P::textureScale, {2, 0}, TextureSlot::occlusion).occlusion.transform.scale == glm::vec2(2, 0));
  CHECK(material(P::textureScale, {2, 0}, TextureSlot::metallicRoughness).metallicRoughness.transform.scale.x == 2);
  CHECK(material(P::textureScale, {2, 0}).baseColor.transform.scale.x == 2);
  CHECK(material(P::textureScale, {2, 0}).normal.transform == TextureTransform{});
}

TEST_CASE("Pointers set the factors of material extensions, and values stay in range") {
  Model model;
  model.materials.resize(1);
  using P = AnimatedProperty;
  const auto material = [&](P property, std::vector<float> value) {
    const Model animated = constant(model, property, std::move(value), TextureSlot::baseColor);
    return only(animated).materials.of(animated.materials, 0);
  };
  CHECK(material(P::ior, {1.75f}).ior == 1.75f);
  CHECK(material(P::ior, {0}).ior == 0);
  CHECK(material(P::ior, {0.5f}).ior == 1);
  CHECK(material(P::specularWeight, {0.25f}).specularWeight == 0.25f);
  CHECK(material(P::specularColorFactor, {-1, 0.5f, 3}).specularColorFactor == glm::vec3(0, 0.5f, 3));
  CHECK(material(P::clearcoatFactor, {2}).clearcoatFactor == 1);
  CHECK(material(P::clearcoatRoughnessFactor, {0.5f}).clearcoatRoughnessFactor == 0.5f);
  CHECK(material(P::clearcoatNormalScale, {-3}).clearcoatNormalScale == -3);
  CHECK(material(P::sheenColorFactor, {0.5f, 2, -1}).sheenColorFactor == glm::vec3(0.5f, 1, 0));
  CHECK(material(P::sheenRoughnessFactor, {0.75f}).sheenRoughnessFactor == 0.75f);
  CHECK(material(P::anisotropyStrength, {0.5f}).anisotropyStrength == 0.5f);
  CHECK(material(P::anisotropyRotation, {-7}).anisotropyRotation == -7);
  CHECK(material(P::iridescenceFactor, {0.5f}).iridescenceFactor == 0.5f);
  CHECK(material(P::iridescenceIor, {0.5f}).iridescenceIor == 1);
  CHECK(material(P::iridescenceThicknessMinimum, {-5}).iridescenceThicknessMinimum == 0);
  CHECK(material(P::iridescenceThicknessMaximum, {900}).iridescenceThicknessMaximum == 900);
  CHECK(material(P::transmissionFactor, {1.5f}).transmissionFactor == 1);
  CHECK(material(P::thicknessFactor, {12}).thicknessFactor == 12);
  CHECK(material(P::attenuationDistance, {0}).attenuationDistance == 1e-18f);
  CHECK(material(P::attenuationDistance, {0.5f}).attenuationDistance == 0.5f);
  CHECK(material(P::attenuationColor, {0.5f, 2, -1}).attenuationColor == glm::vec3(0.5f, 1, 0));
  CHECK(material(P::dispersion, {7}).dispersion == 7);
  CHECK(material(P::diffuseTransmissionFactor, {0.5f}).diffuseTransmissionFactor == 0.5f);
  CHECK(material(P::diffuseRoughnessFactor, {1.5f}).diffuseRoughnessFactor == 1);
  CHECK(material(P::diffuseTransmissionColorFactor, {0.5f, 2, -1}).diffuseTransmissionColorFactor ==
        glm::vec3(0.5f, 1, 0));
}

TEST_CASE("Pointers set lights and cameras, and values stay in range") {
  Model model;
  model.lights.resize(1);
  model.lights[0].innerConeAngle = 0.5f;
  model.cameras.resize(1);
  using P = AnimatedProperty;
  const auto light = [&](P property, std::vector<float> value) {
    const Model animated = constant(model, property, std::move(value));
    return only(animated).lights.of(animated.lights, 0);
  };
  CHECK(light(P::lightColor, {-1, 2, 0.5f}).color == glm::vec3(0, 2, 0.5f));
  CHECK(light(P::lightIntensity, {-1}).intensity == 0);
  CHECK(light(P::lightIntensity, {50}).intensity == 50);
  CHECK(light(P::lightRange, {3}).range == 3);
  CHECK(light(P::lightRange, {0}).range > 0);
  CHECK(light(P::lightInnerConeAngle, {0.25f}).innerConeAngle == 0.25f);
  CHECK(light(P::lightInnerConeAngle, {3}).innerConeAngle == Approx(model.lights[0].outerConeAngle - 1e-4));
  CHECK(light(P::lightOuterConeAngle, {3}).outerConeAngle == Approx(pi / 2));
  CHECK(light(P::lightOuterConeAngle, {0.25f}).innerConeAngle == Approx(0.25 - 1e-4));
  CHECK(light(P::lightOuterConeAngle, {-1}).outerConeAngle > 0);
  CHECK(light(P::lightOuterConeAngle, {-1}).innerConeAngle == 0);

  const auto camera = [&](P property, std::vector<float> value) {
    const Model animated = constant(model, property, std::move(value));
    return only(animated).cameras.of(animated.cameras, 0);
  };
  CHECK(camera(P::cameraFovY, {0.5f}).fovY == 0.5);
  CHECK(camera(P::cameraFovY, {9}).fovY < pi);
  CHECK(camera(P::cameraFovY, {-9}).fovY > 0);
  CHECK(camera(P::cameraZNear, {0.5f}).zNear == 0.5);
  CHECK(camera(P::cameraZNear, {-1}).zNear > 0);
  CHECK(camera(P::cameraZFar, {50}).zFar == 50);
  CHECK(camera(P::cameraAspectRatio, {2.5f}).aspectRatio == 2.5);
  CHECK(camera(P::cameraAspectRatio, {0}).aspectRatio == 1e-4);  // 0 would be the picture's
  CHECK(camera(P::cameraZFar, {0.001f}).zFar == infinity);       // in front of the near plane
  CHECK(camera(P::cameraXMag, {-2}).xMag == 2);
  CHECK(camera(P::cameraYMag, {0}).yMag > 0);
  model.cameras[0].perspective = false;
  CHECK(camera(P::cameraZNear, {0}).zNear == 0);
  CHECK(camera(P::cameraZFar, {0.001f}).zFar == Approx(0.02));
}

TEST_CASE("Splines that leave the range of floats end at its border") {
  constexpr float huge = 3e38f;
  Model model;
  model.nodes.resize(1);
  model.materials.resize(1);
  Animation a;
  a.samplers = {sampler(Interpolation::cubicSpline, 1, {0, 1e30f}, {0, huge, huge, -huge, huge, 0})};
  a.channels = {{0, AnimatedProperty::weights, 0}, {0, AnimatedProperty::normalScale, 0}};
  model.animations = {a};
  const Pose pose = only(model, 5e29);
  CHECK(pose.nodes.of(model.nodes, 0).weights[0] == std::numeric_limits<float>::max());
  CHECK(pose.materials.of(model.materials, 0).normalScale == std::numeric_limits<float>::max());
  CHECK(std::isfinite(at(a.samplers[0], 5e29)[0]));
}

TEST_CASE("Animation: a single weight leaves the others, which are the mesh's where the node has none") {
  Model model;
  model.meshes = {{"mesh", {}, {0.1f, 0.2f, 0.3f}}};
  model.nodes.resize(1);
  model.nodes[0].mesh = 0;
  AnimationSampler sampler;
  sampler.times = {0, 1};
  sampler.values = {0, 1};
  sampler.width = 1;
  AnimationChannel channel;
  channel.property = AnimatedProperty::weights;
  channel.object = 0;
  channel.element = 1;
  model.animations = {{"one", {sampler}, {channel}}};
  CHECK(poseAt(model, std::vector{0}, 0.5).nodes.of(model.nodes, 0).weights == std::vector<float>{0.1f, 0.5f, 0.3f});
  model.animations[0].channels[0].element = 4;
  CHECK(poseAt(model, std::vector{0}, 1).nodes.of(model.nodes, 0).weights ==
        std::vector<float>{0.1f, 0.2f, 0.3f, 0, 1});
}
