#include "view/camera_control.hpp"

#include <algorithm>
#include <cmath>

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

scene::OrbitCamera turned(scene::OrbitCamera camera, const glm::dvec2& degrees) {
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
  const double heightAtTarget = 2 * camera.radius * std::tan(glm::radians(camera.fovY) / 2);
  const glm::dvec2 metres = dragPixels * (heightAtTarget / std::max(windowHeight, 1.0));
  const Axes axes = axesOf(camera);
  camera.target += -axes.right * metres.x + axes.up * metres.y;
  return camera;
}

scene::OrbitCamera zoomed(scene::OrbitCamera camera, double steps, const RadiusLimits& limits) {
  camera.radius = std::clamp(camera.radius * std::pow(0.9, steps), limits.min, limits.max);
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
  scene::OrbitCamera framed = scene::frameBounds(scene, camera.fovY, aspect);
  framed.theta = camera.theta;
  framed.phi = camera.phi;
  return framed;
}

}  // namespace facet::view
