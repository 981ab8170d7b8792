#pragma once

// What the hand does to the camera: pure functions on the orbit camera. Pixels are the window's, y down.

#include "scene/camera.hpp"

namespace facet::view {

// Radii between which the camera stays, metres.
struct RadiusLimits {
  double min = 1e-3, max = 1e3;
};

// A thousandth to a hundred times the scene's radius; for empty bounds and for a point as for a radius of one metre.
RadiusLimits radiusLimits(const scene::Bounds& scene);

// The scene follows the pointer: a drag across the window's height turns by half a turn. Azimuth stays in
// (-180, 180], the polar angle in [0, 180] (the poles are good views).
scene::OrbitCamera orbited(scene::OrbitCamera camera, const glm::dvec2& dragPixels, double windowHeight);

// Moves parallel to the picture so that a point at the target's depth stays under the pointer.
scene::OrbitCamera panned(scene::OrbitCamera camera, const glm::dvec2& dragPixels, double windowHeight);

// One step nearer is a factor of 0.9 on the radius. A radius that lies outside the limits already (a small part was
// framed) stays there, or comes nearer to them.
scene::OrbitCamera zoomed(scene::OrbitCamera camera, double steps, const RadiusLimits& limits);

// The same towards what is at a pixel of the window: that stays there, at whatever depth it is.
scene::OrbitCamera zoomedAt(const scene::OrbitCamera& camera, double steps, const RadiusLimits& limits,
                            const glm::dvec2& pixel, const glm::dvec2& windowSize);

// As orbited(), but about the picture's own axes, over the poles: the horizon does not stay level.
scene::OrbitCamera tumbled(const scene::OrbitCamera& camera, const glm::dvec2& dragPixels, double windowHeight);

// Turns the picture about its middle, counterclockwise; the roll stays in (-180, 180].
scene::OrbitCamera rolled(scene::OrbitCamera camera, double degrees);

// Turns the head: the eye stays, the target moves around it. A drag to the right looks to the right; across the
// window's height it turns by the vertical field of view.
scene::OrbitCamera looked(scene::OrbitCamera camera, const glm::dvec2& dragPixels, double windowHeight);

// Moves eye and target along the camera's right, up and forward, metres.
scene::OrbitCamera flown(scene::OrbitCamera camera, const glm::dvec3& rightUpForward);

// Same direction of view, all of the bounds in the picture.
scene::OrbitCamera framedAll(const scene::OrbitCamera& camera, const scene::Bounds& scene, double aspect);

// From this side of the target, at the same distance, level; for the views from above and below up is what is up where
// theta is 0. The sides are those of the camera's up vector (scene::uprightFrame).
enum class ViewFrom { front, back, right, left, top, bottom };  // where y is up: +Z, -Z, +X, -X, +Y, -Y
scene::OrbitCamera seenFrom(scene::OrbitCamera camera, ViewFrom side);

// A turntable: the camera goes round the target about its up vector, as if the scene turned the other way.
scene::OrbitCamera turntable(scene::OrbitCamera camera, double seconds, double degreesPerSecond);

// Metres per second of flight: a scene is crossed in about three seconds; slower where a small part is looked at.
double flightSpeed(const scene::OrbitCamera& camera, const scene::Bounds& scene);

// The point of the window, pixels from its top left, as a ray from the near side of what is seen.
struct PixelRay {
  glm::dvec3 origin = glm::dvec3(0), direction = glm::dvec3(0, 0, -1);  // world; the direction is unit
};
PixelRay rayThrough(const scene::View& view, const glm::dvec2& pixel, const glm::dvec2& windowSize);

glm::dvec3 eyeOf(const scene::OrbitCamera& camera);

}  // namespace facet::view
