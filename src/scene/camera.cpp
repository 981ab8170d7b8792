#include "scene/camera.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace facet::scene {

namespace {

// Sine and cosine that are exact at multiples of 90 degrees, so that a level camera is level to the last bit.
struct SinCos {
  double sin, cos;
};
SinCos sinCosDegrees(double degrees) {
  const double turns = std::remainder(degrees, 360.0);
  const double quarter = std::nearbyint(turns / 90);
  const double rest = (turns - quarter * 90) * degree;
  const double s = std::sin(rest), c = std::cos(rest);
  switch (((int(quarter) % 4) + 4) % 4) {
    case 0:
      return {s, c};
    case 1:
      return {c, -s};
    case 2:
      return {-s, -c};
    default:
      return {-c, s};
  }
}

double distanceToBox(const Bounds& box, const glm::dvec3& p) {
  return glm::length(glm::max(glm::max(box.min - p, p - box.max), glm::dvec3(0)));
}

double farthestOfBox(const Bounds& box, const glm::dvec3& p) {
  return glm::length(glm::max(glm::abs(box.min - p), glm::abs(box.max - p)));
}

// Smallest near plane that is worth having: see orbitView. lookedAt: metres, > 0.
double nearPlane(const Bounds& scene, const glm::dvec3& eye, double lookedAt) {
  constexpr double share = 1e-6;
  // The reciprocal of near has to be a float, as has near squared times a bit.
  constexpr double smallest = 1e-18;
  if (scene.empty()) return std::max(share * lookedAt, smallest);
  const double radius = scene.radius() > 0 ? std::min(scene.radius(), lookedAt) : lookedAt;
  return std::max({0.01 * distanceToBox(scene, eye), share * radius, smallest});
}

void place(View& view, const glm::dvec3& eye, const glm::dvec3& right, const glm::dvec3& up,
           const glm::dvec3& forward) {
  view.eye = eye, view.right = right, view.up = up, view.forward = forward;
  const glm::dmat3 rotation = glm::transpose(glm::dmat3(right, up, -forward));
  view.viewFromWorld = glm::dmat4(rotation);
  view.viewFromWorld[3] = glm::dvec4(-(rotation * eye), 1);
}

// Of the level camera there, in the orbit's own frame.
struct Level {
  glm::dvec3 right, up, back;
};
Level levelAt(double thetaDeg, double phiDeg) {
  const SinCos theta = sinCosDegrees(thetaDeg), phi = sinCosDegrees(phiDeg);
  return {{theta.cos, 0, -theta.sin},
          {-phi.cos * theta.sin, phi.sin, -phi.cos * theta.cos},  // -d back / d phi
          {phi.sin * theta.sin, phi.cos, phi.sin * theta.cos}};
}

double validAspect(double aspect) { return std::isfinite(aspect) && aspect > 0 ? aspect : 1.0; }

double validRadius(double radius) { return std::isfinite(radius) && radius > 0 ? radius : 1.0; }

// Field of view that a projection can have, radians.
double validFovY(double fovY) { return std::isfinite(fovY) ? std::clamp(fovY, 1e-4 * degree, 179.0 * degree) : 0.8; }

}  // namespace

glm::dmat4 perspective(double fovY, double aspect, double zNear, double zFar) {
  const double cot = 1 / std::tan(fovY / 2);
  glm::dmat4 m(0);
  m[0][0] = cot / aspect;
  m[1][1] = cot;
  // depth = (a z + b) / -z with depth(-near) = 1 and depth(-far) = 0.
  const double a = std::isinf(zFar) ? 0.0 : zNear / (zFar - zNear);
  m[2][2] = a;
  m[3][2] = zNear * (1 + a);
  m[2][3] = -1;
  return m;
}

glm::dmat4 orthographic(double halfWidth, double halfHeight, double zNear, double zFar) {
  glm::dmat4 m(0);
  m[0][0] = 1 / halfWidth;
  m[1][1] = 1 / halfHeight;
  m[2][2] = 1 / (zFar - zNear);
  m[3][2] = zFar / (zFar - zNear);
  m[3][3] = 1;
  return m;
}

glm::dmat3 uprightFrame(const glm::dvec3& up) {
  const double length = glm::length(up);
  if (!(length > 0) || !std::isfinite(length) || (up.x == 0 && up.z == 0 && up.y > 0)) return glm::dmat3(1);
  const glm::dvec3 u = up / length;
  if (u.y < -1 + 1e-12) return glm::dmat3(-1, 0, 0, 0, -1, 0, 0, 0, 1);
  const double s = 1 / (1 + u.y);
  return {{1 - u.x * u.x * s, -u.x, -u.x * u.z * s}, u, {-u.x * u.z * s, -u.z, 1 - u.z * u.z * s}};
}

View orbitView(const OrbitCamera& orbit, double aspect, const Bounds& scene) {
  const double radius = validRadius(orbit.radius);
  Level axes = levelAt(orbit.theta, orbit.phi);
  if (orbit.up != glm::dvec3(0, 1, 0)) {
    const glm::dmat3 upright = uprightFrame(orbit.up);
    axes = {upright * axes.right, upright * axes.up, upright * axes.back};
  }
  if (orbit.roll != 0) {
    const SinCos roll = sinCosDegrees(orbit.roll);
    axes = {axes.right * roll.cos - axes.up * roll.sin, axes.right * roll.sin + axes.up * roll.cos, axes.back};
  }
  View view;
  place(view, orbit.target + axes.back * radius, axes.right, axes.up, -axes.back);
  if (orbit.orthographic) {
    const double size = scene.empty() || !(scene.radius() > 0) ? radius : scene.radius();
    const double middle = scene.empty() ? radius : glm::dot(scene.center() - view.eye, view.forward);
    view.orthographic = true;
    view.zNear = middle - 10 * size, view.zFar = middle + 10 * size;
    const double halfHeight = 0.5 * heightAtTarget(orbit);
    view.clipFromView = orthographic(halfHeight * validAspect(aspect), halfHeight, view.zNear, view.zFar);
  } else {
    view.zNear = nearPlane(scene, view.eye, radius);
    view.clipFromView = perspective(validFovY(orbit.fovY * degree), validAspect(aspect), view.zNear, view.zFar);
  }
  view.clipFromWorld = view.clipFromView * view.viewFromWorld;
  return view;
}

double heightAtTarget(const OrbitCamera& camera) {
  return 2 * validRadius(camera.radius) * std::tan(validFovY(camera.fovY * degree) / 2);
}

double radiusForHeight(double height, double fovY) { return height / (2 * std::tan(validFovY(fovY * degree) / 2)); }

View cameraView(const Camera& camera, const glm::dmat4& worldFromNode, double aspect, const Bounds& scene) {
  View view;
  const auto unit = [](const glm::dvec3& v, const glm::dvec3& otherwise) {
    const double length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : otherwise;
  };
  const glm::dvec3 forward = unit(-glm::dvec3(worldFromNode[2]), {0, 0, -1});
  const glm::dvec3 nodeUp = unit(glm::dvec3(worldFromNode[1]), {0, 1, 0});
  const glm::dvec3 anyRight = std::abs(forward.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, -1);
  const glm::dvec3 right =
      unit(glm::cross(forward, nodeUp), unit(anyRight - forward * glm::dot(forward, anyRight), anyRight));
  place(view, glm::dvec3(worldFromNode[3]), right, glm::cross(right, forward), forward);

  const double pictureAspect = validAspect(aspect);
  if (camera.perspective) {
    double halfHeight = std::tan(validFovY(camera.fovY) / 2);
    if (camera.aspectRatio > pictureAspect) halfHeight *= camera.aspectRatio / pictureAspect;
    view.zNear = camera.zNear > 0 ? camera.zNear : nearPlane(scene, view.eye, validRadius(scene.radius()));
    view.zFar = camera.zFar > view.zNear ? camera.zFar : std::numeric_limits<double>::infinity();
    view.clipFromView = perspective(2 * std::atan(halfHeight), pictureAspect, view.zNear, view.zFar);
  } else {
    view.orthographic = true;
    double halfHeight = validRadius(std::abs(camera.yMag));
    halfHeight = std::max(halfHeight, validRadius(std::abs(camera.xMag)) / pictureAspect);
    view.zNear = std::max(camera.zNear, 0.0);
    view.zFar = camera.zFar;
    if (!std::isfinite(view.zFar)) view.zFar = scene.empty() ? 1.0 : farthestOfBox(scene, view.eye) * 1.001;
    if (!(view.zFar > view.zNear)) view.zFar = view.zNear + 1;
    view.clipFromView = orthographic(halfHeight * pictureAspect, halfHeight, view.zNear, view.zFar);
  }
  view.clipFromWorld = view.clipFromView * view.viewFromWorld;
  return view;
}

OrbitCamera frameBounds(const Bounds& bounds, double fovY, double aspect) {
  OrbitCamera like;
  like.fovY = fovY;
  return frameBounds(bounds, aspect, like);
}

OrbitCamera frameBounds(const Bounds& bounds, double aspect, const OrbitCamera& like) {
  OrbitCamera orbit = like;
  orbit.fovY = validFovY(like.fovY * degree) / degree;
  orbit.theta = 30;
  orbit.phi = 75;
  orbit.target = glm::dvec3(0);
  double sphere = 1;
  if (!bounds.empty()) {
    orbit.target = bounds.center();
    sphere = bounds.radius();
    if (!(sphere > 0)) sphere = std::max(0.5, 5e-4 * glm::length(orbit.target));
    const glm::dvec3 size = bounds.max - bounds.min;
    const double thin = 0.1 * std::max({size.x, size.y, size.z});
    const glm::dmat3 upright = uprightFrame(orbit.up);
    if (glm::dot(glm::abs(upright[2]), size) < thin)
      orbit.theta = 0, orbit.phi = 90;
    else if (glm::dot(glm::abs(upright[1]), size) < thin)
      orbit.phi = 55;
  }
  if (orbit.orthographic) {
    orbit.radius = radiusForHeight(2 * sphere / std::min(validAspect(aspect), 1.0), orbit.fovY);
    return orbit;
  }
  const double halfY = orbit.fovY * degree / 2;
  const double halfX = std::atan(std::tan(halfY) * validAspect(aspect));
  orbit.radius = sphere / std::sin(std::min(halfX, halfY));
  return orbit;
}

OrbitCamera turnedTo(OrbitCamera camera, const glm::dvec3& right, const glm::dvec3& up) {
  const glm::dmat3 toUpright = glm::transpose(uprightFrame(camera.up));
  const glm::dvec3 r = toUpright * right, back = toUpright * glm::cross(right, up);
  const double level = std::hypot(back.x, back.z);
  camera.phi = std::atan2(level, back.y) / degree;
  // At the poles the azimuth is in the right vector alone, and nothing is rolled.
  camera.theta = (level < 1e-9 ? std::atan2(-r.z, r.x) : std::atan2(back.x, back.z)) / degree;
  const Level axes = levelAt(camera.theta, camera.phi);
  camera.roll = std::atan2(-glm::dot(r, axes.up), glm::dot(r, axes.right)) / degree;
  if (std::abs(camera.roll) < 1e-9) camera.roll = 0;
  return camera;
}

OrbitCamera orbitFromView(const View& view, const Bounds& scene, const OrbitCamera& like) {
  OrbitCamera orbit = like;
  const double along = scene.empty() ? 1.0 : glm::dot(scene.center() - view.eye, view.forward);
  orbit.radius = along > 0 ? along : validRadius(scene.radius());
  orbit.target = view.eye + view.forward * orbit.radius;
  orbit.orthographic = view.orthographic;
  const double halfHeight = 1 / view.clipFromView[1][1];
  if (view.orthographic)
    orbit.radius = radiusForHeight(2 * halfHeight, orbit.fovY);
  else
    orbit.fovY = 2 * std::atan(halfHeight) / degree;
  return turnedTo(orbit, view.right, view.up);
}

}  // namespace facet::scene
