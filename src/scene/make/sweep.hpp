#pragma once

// Shapes from rules: a profile swept along a path, in double precision. Texture coordinates are metres: u around the
// profile, v along the path.

#include <glm/glm.hpp>
#include <vector>

#include "scene/shapes.hpp"

namespace facet::scene {

// A closed polygon that its middle sees whole, counter-clockwise seen against the path's direction.
using Profile = std::vector<glm::dvec2>;
// offset: of the first corner from +x, in steps of a side; 0.5 has an edge there.
Profile polygonProfile(int sides, double radius, double offset = 0);
Profile rectangleProfile(double width, double height, double chamfer);

// Where a profile stands: its x and y axis and the path's direction, which is x cross y; unit and at right angles.
struct Frame {
  glm::dvec3 origin, x, y, along;
};

using Path = std::vector<glm::dvec3>;
// From (radius, 0, 0) around +Y, towards -Z first; pitch: rise of a turn.
Path helixPath(double radius, double pitch, double turns, int steps);
// From `start` around an axis through `centre`.
Path arcPath(const glm::dvec3& centre, const glm::dvec3& axis, const glm::dvec3& start, double angle, int steps);

// Frames along a path that turn about it as little as can be, so that tubes do not twist: Wang, Juettler, Zheng, Liu
// 2008, "Computation of Rotation Minimizing Frames" (TOG 27(1)), double reflection. The first x is what of `x` is at
// right angles to the path. closed: the last point leads to the first again, and what the frames turn on the way round
// is spread over them.
std::vector<Frame> pathFrames(const Path& path, const glm::dvec3& x, bool closed = false);

// A profile at one place of a sweep.
struct Floor {
  Frame frame;
  glm::dvec2 scale{1};  // of the profile's x and y
  double turn = 0;      // of the profile about the path [rad]
};
std::vector<Floor> floorsAlong(const std::vector<Frame>& frames, double scale = 1);
// Up from the origin along +Y: (height, scale) each.
std::vector<Floor> tower(const std::vector<glm::dvec2>& heights);

struct SweepOptions {
  bool smooth = false;  // normals across edges, else each face has its own
  bool closed = false;  // the last floor leads to the first again
  bool caps = true;     // of a sweep that is not closed
};
// Faces without area are left out: a floor of scale 0 is a tip.
Shape sweep(const Profile& profile, const std::vector<Floor>& floors, const SweepOptions& options = {});

// An outline of (radius, height), from below, around +Y; where a radius is 0 at an end it closes there.
Shape turnedShape(const std::vector<glm::dvec2>& outline, int sides, bool smooth);

// Chamfered on all edges, around the origin.
Shape boxShape(const glm::dvec3& size, double chamfer);

// A rectangle from its corner along two edges at right angles, seen from where u turns to v counter-clockwise; texture
// coordinates in metres times `repeat`.
Shape rectangleShape(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, double repeat = 1);

void append(Shape& shape, const Shape& more);
Shape moved(Shape shape, const glm::dvec3& by);

}  // namespace facet::scene
