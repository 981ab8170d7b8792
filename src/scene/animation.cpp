#include "scene/animation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/text.hpp"
#include "base/whole_number.hpp"
#include "scene/material_properties.hpp"
#include "scene/nodes.hpp"
#include "scene/properties.hpp"
#include "scene/usage.hpp"

namespace facet::scene {

namespace {

// Between two keys, or on one (from == to).
struct Place {
  size_t from = 0, to = 0;
  double t = 0;     // [0, 1] from `from` to `to`
  double span = 0;  // seconds between them
};

// A time that is no number is before the first key.
Place locate(const std::vector<float>& times, double time) {
  const size_t last = times.size() - 1;
  if (!(time > double(times[0]))) return {};
  if (time >= double(times[last])) return {last, last};
  const auto after =
      std::upper_bound(times.begin(), times.end(), time, [](double a, float b) { return a < double(b); });
  const auto to = size_t(after - times.begin());
  const double begin = times[to - 1], span = double(times[to]) - begin;
  return {to - 1, to, (time - begin) / span, span};
}

glm::dquat unitQuat(const double* xyzw) {
  const glm::dvec4 q(xyzw[0], xyzw[1], xyzw[2], xyzw[3]);
  const double length = glm::length(q);
  if (!(length > 0) || !std::isfinite(length)) return glm::dquat(1, 0, 0, 0);
  return glm::dquat(q.w / length, q.x / length, q.y / length, q.z / length);
}

void store(const glm::dquat& q, std::span<double> out) {
  const double xyzw[] = {q.x, q.y, q.z, q.w};
  std::copy(xyzw, xyzw + 4, out.begin());
}

// glTF 2.0, C.4, for unit quaternions. The angle a in [0, pi/2] comes from the chord, 2 atan(|q - p| / |q + p|),
// because the arc cosine of the dot product loses half of its digits for nearly equal ones. Opposite ones are the same
// rotation: the result stays.
glm::dquat slerpShortest(const glm::dquat& p, glm::dquat q, double t) {
  if (glm::dot(p, q) < 0) q = -q;
  const double a = 2 * std::atan2(glm::length(q + -p), glm::length(q + p));
  const double s = std::sin(a);
  if (!(s > 0)) return p;
  return glm::normalize(p * (std::sin(a * (1 - t)) / s) + q * (std::sin(a * t) / s));
}

// glTF 2.0, C.5: Hermite's polynomials; tangents are per second.
void cubicSpline(const AnimationSampler& sampler, const Place& at, std::span<double> out) {
  const double t = at.t, t2 = t * t, t3 = t2 * t;
  const double p0 = 2 * t3 - 3 * t2 + 1, m0 = at.span * (t3 - 2 * t2 + t);
  const double p1 = 3 * t2 - 2 * t3, m1 = at.span * (t3 - t2);
  const auto width = size_t(sampler.width);
  const float* v0 = sampler.values.data() + (3 * at.from + 1) * width;  // value, then out-tangent
  const float* in1 = sampler.values.data() + 3 * at.to * width;         // in-tangent, then value
  for (size_t i = 0; i < width; ++i)
    out[i] = p0 * double(v0[i]) + m0 * double(v0[width + i]) + m1 * double(in1[i]) + p1 * double(in1[width + i]);
}

void sampleAs(Interpolation how, const AnimationSampler& sampler, double time, bool isRotation, std::span<double> out) {
  const auto width = size_t(sampler.width);
  const bool spline = sampler.interpolation == Interpolation::cubicSpline;
  assert(!sampler.times.empty() && out.size() == width);
  assert(sampler.values.size() == sampler.times.size() * width * (spline ? 3 : 1));
  const auto value = [&](size_t key) { return sampler.values.data() + (spline ? 3 * key + 1 : key) * width; };

  const Place at = locate(sampler.times, time);
  const float *a = value(at.from), *b = value(at.to);
  if (how == Interpolation::step || at.from == at.to) {
    std::copy(a, a + width, out.begin());
  } else if (how == Interpolation::cubicSpline) {
    cubicSpline(sampler, at, out);
  } else if (isRotation) {
    const double p[] = {a[0], a[1], a[2], a[3]}, q[] = {b[0], b[1], b[2], b[3]};
    store(slerpShortest(unitQuat(p), unitQuat(q), at.t), out);
    return;
  } else {
    for (size_t i = 0; i < width; ++i) out[i] = double(a[i]) * (1 - at.t) + double(b[i]) * at.t;
  }
  if (isRotation) store(unitQuat(out.data()), out);
}

// Cubic splines can leave the range of floats and the valid range of a property: to [low, high], for values that are
// finite.
float limited(double value, double low, double high) {
  constexpr double largest = std::numeric_limits<float>::max();
  return float(std::clamp(value, std::max(low, -largest), std::min(high, largest)));
}

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double smallest = std::numeric_limits<float>::min();
constexpr double halfPi = 1.57079632679489662;

template <class Vector>
void take(Vector& to, const std::vector<double>& v, double low = -unbounded, double high = unbounded) {
  for (int i = 0; i < to.length(); ++i) to[i] = limited(v[size_t(i)], low, high);
}

void setNode(Node& node, const AnimationChannel& channel, const std::vector<double>& v, const Model& model) {
  const AnimatedProperty property = channel.property;
  const int element = channel.element;
  const bool moves = property == AnimatedProperty::translation || property == AnimatedProperty::rotation ||
                     property == AnimatedProperty::scale;
  if (moves) decompose(node);
  if (property == AnimatedProperty::translation) node.translation = {v[0], v[1], v[2]};
  if (property == AnimatedProperty::rotation) node.rotation = glm::dquat(v[3], v[0], v[1], v[2]);
  if (property == AnimatedProperty::scale) node.scale = {v[0], v[1], v[2]};
  if (property == AnimatedProperty::visible) node.visible = v[0] != 0;
  if (property != AnimatedProperty::weights) return;
  if (node.weights.empty() && element >= 0 && node.mesh >= 0) node.weights = model.meshes[size_t(node.mesh)].weights;
  // A single weight leaves the others as they are.
  const size_t first = element < 0 ? 0 : size_t(element);
  node.weights.resize(element < 0 ? v.size() : std::max(node.weights.size(), first + 1));
  for (size_t i = 0; i < v.size(); ++i) node.weights[first + i] = limited(v[i], -unbounded, unbounded);
}

void setMaterial(Material& m, const AnimationChannel& channel, const std::vector<double>& v) {
  if (const MaterialProperty* property = materialProperty(channel.property)) {
    const std::span<float> to = components(m, *property);
    for (size_t i = 0; i < to.size(); ++i) to[i] = inRange(*property, v[i]);
    return;
  }
  TextureTransform& transform = textureRef(m, channel.slot).transform;
  if (channel.property == AnimatedProperty::textureOffset) take(transform.offset, v);
  if (channel.property == AnimatedProperty::textureRotation) transform.rotation = limited(v[0], -unbounded, unbounded);
  if (channel.property == AnimatedProperty::textureScale) take(transform.scale, v);
}

void setLight(Light& light, AnimatedProperty property, const std::vector<double>& v) {
  if (property == AnimatedProperty::lightColor) take(light.color, v, 0);
  if (property == AnimatedProperty::lightIntensity) light.intensity = limited(v[0], 0, unbounded);
  if (property == AnimatedProperty::lightRange) light.range = limited(v[0], 1e-18, unbounded);  // 1 / range^2 is finite
  if (property == AnimatedProperty::lightInnerConeAngle) light.innerConeAngle = limited(v[0], 0, halfPi);
  if (property == AnimatedProperty::lightOuterConeAngle) light.outerConeAngle = limited(v[0], 1e-4, halfPi);
}

void setCamera(Camera& camera, AnimatedProperty property, const std::vector<double>& v) {
  constexpr double largest = std::numeric_limits<float>::max();
  if (property == AnimatedProperty::cameraFovY) camera.fovY = std::clamp(v[0], 1e-4, 3.1415);
  if (property == AnimatedProperty::cameraZNear)
    camera.zNear = std::clamp(v[0], camera.perspective ? smallest : 0, largest);
  if (property == AnimatedProperty::cameraZFar) camera.zFar = std::clamp(v[0], smallest, largest);
  if (property == AnimatedProperty::cameraXMag) camera.xMag = std::clamp(std::abs(v[0]), smallest, largest);
  if (property == AnimatedProperty::cameraAspectRatio) camera.aspectRatio = std::clamp(v[0], 1e-4, 1e4);
  if (property == AnimatedProperty::cameraYMag) camera.yMag = std::clamp(std::abs(v[0]), smallest, largest);
}

void apply(const Model& model, const Animation& animation, double time, std::vector<double>& value, Pose& pose) {
  for (const AnimationChannel& channel : animation.channels) {
    const AnimationSampler& sampler = animation.samplers[size_t(channel.sampler)];
    const bool step = channel.property == AnimatedProperty::visible;  // there is nothing between true and false
    value.resize(size_t(sampler.width));
    sampleAs(step ? Interpolation::step : sampler.interpolation, sampler, time,
             channel.property == AnimatedProperty::rotation, value);
    setProperty(pose, model, channel, value);
  }
}

std::string listed(const std::vector<Animation>& animations) {
  constexpr size_t most = 20;
  std::string text;
  for (size_t i = 0; i < std::min(animations.size(), most); ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(i);
    if (!animations[i].name.empty()) text += " \"" + animations[i].name + "\"";
  }
  if (animations.size() > most) text += " and " + std::to_string(animations.size() - most) + " more";
  return text;
}

}  // namespace

void sampleAt(const AnimationSampler& sampler, double time, bool isRotation, std::span<double> out) {
  sampleAs(sampler.interpolation, sampler, time, isRotation, out);
}

double duration(const Animation& animation) {
  double last = 0;
  for (const AnimationChannel& channel : animation.channels)
    last = std::max(last, double(animation.samplers[size_t(channel.sampler)].times.back()));
  return last;
}

Result<std::vector<int>> chooseAnimations(const Model& model, const std::string& wanted) {
  if (wanted.empty()) return std::vector<int>{};
  for (size_t i = 0; i < model.animations.size(); ++i)
    if (model.animations[i].name == wanted) return std::vector{int(i)};
  if (wanted == "all") {
    std::vector<int> all(model.animations.size());
    for (size_t i = 0; i < all.size(); ++i) all[i] = int(i);
    return all;
  }
  const std::optional<int> index = wholeNumber(wanted);
  if (index && *index >= 0 && size_t(*index) < model.animations.size()) return std::vector{*index};
  if (model.animations.empty())
    return fail(model.name, "", "there are no animations", "leave out \"" + printable(wanted, 80) + "\"",
                Setting::animation);
  return fail(model.name, "", "there is no animation \"" + printable(wanted, 80) + "\"",
              "choose all or one of " + listed(model.animations), Setting::animation);
}

void setProperty(Pose& pose, const Model& model, const AnimationChannel& channel, const std::vector<double>& value) {
  const auto edit = [&](auto& changes, const auto& rest) -> auto& { return changes.edit(rest, channel.object); };
  switch (ownerOf(channel.property)) {
    case Owner::node:
      setNode(edit(pose.nodes, model.nodes), channel, value, model);
      break;
    case Owner::material:
      setMaterial(edit(pose.materials, model.materials), channel, value);
      break;
    case Owner::light:
      setLight(edit(pose.lights, model.lights), channel.property, value);
      break;
    case Owner::camera:
      setCamera(edit(pose.cameras, model.cameras), channel.property, value);
      break;
    case Owner::mesh:
      break;
  }
}

void reconcile(Pose& pose) {
  for (auto& [index, light] : pose.lights.changed)
    light.innerConeAngle = std::min(light.innerConeAngle, std::max(0.0f, light.outerConeAngle - 1e-4f));
  for (auto& [index, camera] : pose.cameras.changed)
    if (!(camera.zFar > camera.zNear))
      camera.zFar = camera.perspective ? unbounded : std::max(camera.zNear * 2, smallest);
}

Pose poseAt(const Model& model, std::span<const int> animations, double time) {
  Pose pose;
  std::vector<double> value;
  for (const int i : animations) apply(model, model.animations[size_t(i)], time, value, pose);
  reconcile(pose);
  return pose;
}

}  // namespace facet::scene
