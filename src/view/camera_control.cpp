#include "view/camera_control.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace facet::view {

namespace {

// (-180, 180]
double wrappedDegrees(double degrees) {
  const double turned = std::remainder(degrees, 360.0);
  return turned == -180 ? 180 : turned;
}

struct Axes {
  glm::dvec3 right, up, back;
};

Axes axesOf(const scene::OrbitCamera& camera) {
  const scene::View view = scene::orbitView(camera, 1, {});
  return {view.right, view.up, -view.forward};
}

// As a drag would be in the picture of a level camera.
glm::dvec2 levelled(const glm::dvec2& drag, double rollDegrees) {
  if (rollDegrees == 0) return drag;
  const double c = std::cos(glm::radians(rollDegrees)), s = std::sin(glm::radians(rollDegrees));
  return {c * drag.x - s * drag.y, s * drag.x + c * drag.y};
}

scene::OrbitCamera turned(scene::OrbitCamera camera, const glm::dvec2& picture) {
  const glm::dvec2 degrees = levelled(picture, camera.roll);
  camera.theta = wrappedDegrees(camera.theta - degrees.x);
  camera.phi = std::clamp(camera.phi - degrees.y, 0.0, 180.0);
  return camera;
}

}  // namespace

RadiusLimits radiusLimits(const scene::Bounds& scene) {
  const double radius = scene.radius() > 0 && std::isfinite(scene.radius()) ? scene.radius() : 1.0;
  return {1e-3 * radius, 1e2 * radius};
}

glm::dvec3 eyeOf(const scene::OrbitCamera& camera) { return camera.target + axesOf(camera).back * camera.radius; }

scene::OrbitCamera orbited(scene::OrbitCamera camera, const glm::dvec2& dragPixels, double windowHeight) {
  return turned(camera, dragPixels * (180 / std::max(windowHeight, 1.0)));
}

scene::OrbitCamera panned(scene::OrbitCamera camera, const glm::dvec2& dragPixels, double windowHeight) {
  const glm::dvec2 metres = dragPixels * (scene::heightAtTarget(camera) / std::max(windowHeight, 1.0));
  const Axes axes = axesOf(camera);
  camera.target += -axes.right * metres.x + axes.up * metres.y;
  return camera;
}

scene::OrbitCamera zoomed(scene::OrbitCamera camera, double steps, const RadiusLimits& limits) {
  const double least = std::min(limits.min, camera.radius), most = std::max(limits.max, camera.radius);
  camera.radius = std::clamp(camera.radius * std::pow(0.9, steps), least, most);
  return camera;
}

scene::OrbitCamera zoomedAt(const scene::OrbitCamera& camera, double steps, const RadiusLimits& limits,
                            const glm::dvec2& pixel, const glm::dvec2& windowSize) {
  scene::OrbitCamera nearer = zoomed(camera, steps, limits);
  const glm::dvec2 fromMiddle = (pixel - 0.5 * windowSize) * (scene::heightAtTarget(camera) / windowSize.y);
  const Axes axes = axesOf(camera);
  nearer.target += (axes.right * fromMiddle.x - axes.up * fromMiddle.y) * (1 - nearer.radius / camera.radius);
  return nearer;
}

scene::OrbitCamera tumbled(const scene::OrbitCamera& camera, const glm::dvec2& dragPixels, double windowHeight) {
  const Axes axes = axesOf(camera);
  const glm::dvec3 about = axes.up * -dragPixels.x + axes.right * -dragPixels.y;
  const double length = glm::length(about);
  if (!(length > 0)) return camera;
  const glm::dmat3 turn =
      glm::dmat3(glm::rotate(glm::dmat4(1), length * glm::radians(180 / std::max(windowHeight, 1.0)), about / length));
  return scene::turnedTo(camera, turn * axes.right, turn * axes.up);
}

scene::OrbitCamera rolled(scene::OrbitCamera camera, double degrees) {
  camera.roll = wrappedDegrees(camera.roll + degrees);
  return camera;
}

scene::OrbitCamera looked(scene::OrbitCamera camera, const glm::dvec2& dragPixels, double windowHeight) {
  const glm::dvec3 eye = eyeOf(camera);
  camera = turned(camera, dragPixels * (camera.fovY / std::max(windowHeight, 1.0)));
  camera.target = eye - axesOf(camera).back * camera.radius;
  return camera;
}

scene::OrbitCamera flown(scene::OrbitCamera camera, const glm::dvec3& rightUpForward) {
  const Axes axes = axesOf(camera);
  camera.target += axes.right * rightUpForward.x + axes.up * rightUpForward.y - axes.back * rightUpForward.z;
  return camera;
}

scene::OrbitCamera framedAll(const scene::OrbitCamera& camera, const scene::Bounds& scene, double aspect) {
  scene::OrbitCamera framed = scene::frameBounds(scene, aspect, camera);
  framed.theta = camera.theta;
  framed.phi = camera.phi;
  return framed;
}

scene::OrbitCamera seenFrom(scene::OrbitCamera camera, ViewFrom side) {
  constexpr glm::dvec2 angles[] = {{0, 90}, {180, 90}, {90, 90}, {-90, 90}, {0, 0}, {0, 180}};
  const glm::dvec2& chosen = angles[static_cast<size_t>(side)];
  camera.theta = chosen.x;
  camera.phi = chosen.y;
  camera.roll = 0;
  return camera;
}

scene::OrbitCamera turntable(scene::OrbitCamera camera, double seconds, double degreesPerSecond) {
  camera.theta = wrappedDegrees(camera.theta + seconds * degreesPerSecond);
  return camera;
}

double flightSpeed(const scene::OrbitCamera& camera, const scene::Bounds& scene) {
  constexpr double radiiPerSecond = 0.7, slowest = 0.01;
  const double radius = scene.radius() > 0 && std::isfinite(scene.radius()) ? scene.radius() : 1.0;
  return radiiPerSecond * std::clamp(camera.radius, slowest * radius, radius);
}

PixelRay rayThrough(const scene::View& view, const glm::dvec2& pixel, const glm::dvec2& windowSize) {
  const glm::dvec2 ndc(2 * pixel.x / windowSize.x - 1, 1 - 2 * pixel.y / windowSize.y);
  const double x = ndc.x / view.clipFromView[0][0], y = ndc.y / view.clipFromView[1][1];
  if (view.orthographic) return {view.eye + view.right * x + view.up * y + view.forward * view.zNear, view.forward};
  const glm::dvec3 direction = view.forward + view.right * x + view.up * y;
  return {view.eye + direction * view.zNear, glm::normalize(direction)};
}

}  // namespace facet::view
