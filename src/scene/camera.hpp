#pragma once

// Cameras. View space: x right, y up, looks along -z. Depth is reversed, for glClipControl(GL_LOWER_LEFT,
// GL_ZERO_TO_ONE), GL_GREATER and a float depth buffer cleared to 0: 1 at the near plane, 0 at the far plane or at
// infinity. Then depth has the same relative precision at every distance (Reed 2015, "Depth Precision Visualized"), so
// near may be tiny at no cost.

#include <limits>

#include "scene/model.hpp"

namespace facet::scene {

// eye = target + radius (sin phi sin theta, cos phi, sin phi cos theta).
struct OrbitCamera {
  double theta = 0;   // degrees, azimuth: 0 on +Z, positive towards +X
  double phi = 90;    // degrees, polar angle from +Y: 90 is level, 0 looks straight down
  double radius = 1;  // metres
  glm::dvec3 target = glm::dvec3(0);
  double fovY = 45;  // degrees, vertical
  // Rays are parallel; the picture's height is that of the perspective at the target, 2 radius tan(fovY / 2), and
  // nothing is too near.
  bool orthographic = false;
  glm::dvec3 up = glm::dvec3(0, 1, 0);  // world, any length: theta and phi are of the world that uprightFrame() turns
  double roll = 0;                      // degrees: turns the picture about its middle, counterclockwise

  bool operator==(const OrbitCamera&) const = default;
};

// Turns +Y to this direction the shortest way, so that +Z up leaves +X and has -Y in front; -Y up is half a turn about
// +Z. Exact for axes; the identity for zero.
glm::dmat3 uprightFrame(const glm::dvec3& up);

struct View {
  glm::dmat4 viewFromWorld = glm::dmat4(1);  // rotation and translation only
  glm::dmat4 clipFromView = glm::dmat4(1);
  glm::dmat4 clipFromWorld = glm::dmat4(1);
  glm::dvec3 eye = glm::dvec3(0);             // world
  glm::dvec3 right = glm::dvec3(1, 0, 0);     // world, unit
  glm::dvec3 up = glm::dvec3(0, 1, 0);        // world, unit
  glm::dvec3 forward = glm::dvec3(0, 0, -1);  // world, unit
  bool orthographic = false;                  // rays are parallel to forward
  double zNear = 0;                           // metres before the eye; negative: behind it (orthographic only)
  double zFar = std::numeric_limits<double>::infinity();
};

// Reversed perspective; zFar may be infinite. fovY in radians, in (0, pi); aspect = width / height; 0 < zNear < zFar.
glm::dmat4 perspective(double fovY, double aspect, double zNear, double zFar);

// Reversed orthographic; half sizes in metres, zNear < zFar, both finite.
glm::dmat4 orthographic(double halfWidth, double halfHeight, double zNear, double zFar);

// Near follows the scene's bounds: a hundredth of the way to their box when the eye is outside (animated geometry may
// leave it), and at least a millionth of what the camera looks at (orbit's or scene's radius, the smaller). Far is
// infinite. At the poles up is where it comes from continuously: at phi = 0 the picture's top is -Z for theta = 0.
// Orthographic: near and far are ten radii of the bounds before and behind their centre, whatever the eye's place.
View orbitView(const OrbitCamera& orbit, double aspect, const Bounds& scene);

// The glTF camera at a node. Scale and shear of the node are ignored (glTF 2.0, 3.10.2), a mirrored node doesn't mirror
// the picture. Where the camera's aspect ratio is not the picture's, what the camera sees is contained, not cropped or
// stretched.
View cameraView(const Camera& camera, const glm::dmat4& worldFromNode, double aspect, const Bounds& scene);

// The orbit that shows all of the bounding sphere, touching the picture's nearer edges. Looks from 30 degrees to the
// right and 15 above, so that a solid shows its depth; straight at what is flat in z (a chart); from 35 degrees above
// at what is flat in y (a floor). Flat: thinner than a tenth of the largest side. A point is framed as if 1 m large
// or, far from the origin, a thousandth of its distance; empty bounds as the unit sphere.
OrbitCamera frameBounds(const Bounds& bounds, double fovY = 45, double aspect = 1);
// The same with the field of view, the projection, the up vector (in the place of y, as uprightFrame() turns it) and
// the roll of a camera.
OrbitCamera frameBounds(const Bounds& bounds, double aspect, const OrbitCamera& like);

// Looks along other axes (world, unit, at right angles to each other): theta, phi and roll are new, target and radius
// stay.
OrbitCamera turnedTo(OrbitCamera camera, const glm::dvec3& right, const glm::dvec3& up);

// The orbit that shows what the view shows: with its eye, or as much of the scene where it is orthographic; the target
// lies where the view's axis comes nearest to the centre of the bounds. like: up vector, and the field of view of an
// orthographic one.
OrbitCamera orbitFromView(const View& view, const Bounds& scene, const OrbitCamera& like = {});

// Metres of what is seen at the target, from the picture's lower edge to its upper one; the radius for such a height.
double heightAtTarget(const OrbitCamera& camera);
double radiusForHeight(double height, double fovY);

}  // namespace facet::scene
