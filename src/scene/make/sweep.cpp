#include "scene/make/sweep.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace facet::scene {

namespace {

glm::dvec3 turnedAbout(const glm::dvec3& v, const glm::dvec3& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return v * c + glm::cross(axis, v) * s + axis * (glm::dot(axis, v) * (1 - c));
}

glm::dvec3 acrossOf(const glm::dvec3& v, const glm::dvec3& along) {
  const glm::dvec3 across = v - glm::dot(v, along) * along;
  if (glm::length(across) > 1e-9) return glm::normalize(across);
  const glm::dvec3 other = std::abs(along.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(other - glm::dot(other, along) * along);
}

// Of each point: the mean of what comes and what goes.
std::vector<glm::dvec3> directionsOf(const Path& path, bool closed) {
  const size_t n = path.size();
  std::vector<glm::dvec3> directions;
  for (size_t i = 0; i < n; ++i) {
    const glm::dvec3& before = path[i > 0 ? i - 1 : closed ? n - 1 : 0];
    const glm::dvec3& after = path[i + 1 < n ? i + 1 : closed ? 0 : n - 1];
    const glm::dvec3 in = path[i] - before, out = after - path[i];
    const auto unit = [](const glm::dvec3& v) { return glm::length(v) > 0 ? glm::normalize(v) : glm::dvec3(0); };
    const glm::dvec3 mean = unit(in) + unit(out);
    directions.push_back(glm::length(mean) > 1e-9 ? glm::normalize(mean) : unit(in));
  }
  return directions;
}

// x at the end of a step, by two reflections: one takes the first point to the second, one the direction there.
glm::dvec3 reflectedTwice(const glm::dvec3& x, const glm::dvec3& along, const glm::dvec3& step, const glm::dvec3& to) {
  const double square = glm::dot(step, step);
  if (square == 0) return acrossOf(x, to);
  const glm::dvec3 left = x - 2 / square * glm::dot(step, x) * step;
  const glm::dvec3 leftAlong = along - 2 / square * glm::dot(step, along) * step;
  const glm::dvec3 second = to - leftAlong;
  const double secondSquare = glm::dot(second, second);
  return secondSquare < 1e-24 ? left : left - 2 / secondSquare * glm::dot(second, left) * second;
}

Frame frameOf(const glm::dvec3& origin, const glm::dvec3& x, const glm::dvec3& along) {
  const glm::dvec3 across = acrossOf(x, along);
  return {origin, across, glm::cross(along, across), along};
}

// A sweep's points, floor by floor.
struct Grid {
  size_t floors, sides;
  std::vector<glm::dvec3> points;
  const glm::dvec3& at(size_t floor, size_t side) const { return points[floor % floors * sides + side % sides]; }
};

Grid gridOf(const Profile& profile, const std::vector<Floor>& floors) {
  Grid grid{floors.size(), profile.size(), {}};
  for (const Floor& floor : floors) {
    const double c = std::cos(floor.turn), s = std::sin(floor.turn);
    for (const glm::dvec2& p : profile) {
      const glm::dvec2 scaled = floor.scale * glm::dvec2(c * p.x - s * p.y, s * p.x + c * p.y);
      grid.points.push_back(floor.frame.origin + scaled.x * floor.frame.x + scaled.y * floor.frame.y);
    }
  }
  return grid;
}

// Twice the face's area, outwards.
glm::dvec3 faceNormal(const Grid& grid, size_t floor, size_t side) {
  const glm::dvec3 &a = grid.at(floor, side), &b = grid.at(floor, side + 1), &c = grid.at(floor + 1, side + 1),
                   &d = grid.at(floor + 1, side);
  return glm::cross(c - a, d - b);
}

uint32_t addVertex(Shape& shape, const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec2& uv) {
  shape.positions.emplace_back(position);
  shape.normals.emplace_back(normal);
  shape.texCoords.emplace_back(uv);
  return static_cast<uint32_t>(shape.positions.size() - 1);
}

void addTriangle(Shape& shape, uint32_t a, uint32_t b, uint32_t c) {
  const auto at = [&](uint32_t i) { return glm::dvec3(shape.positions[i]); };
  if (glm::length(glm::cross(at(b) - at(a), at(c) - at(a))) > 1e-12)
    shape.indices.insert(shape.indices.end(), {a, b, c});
}

// start: seen from where the path comes.
void addCap(Shape& shape, const Grid& grid, const Floor& floor, size_t index, bool start) {
  const glm::dvec3 normal = start ? -floor.frame.along : floor.frame.along;
  const auto uv = [&](const glm::dvec3& p) {
    const glm::dvec3 d = p - floor.frame.origin;
    return glm::dvec2(glm::dot(d, floor.frame.x), glm::dot(d, floor.frame.y));
  };
  const uint32_t middle = addVertex(shape, floor.frame.origin, normal, {0, 0});
  for (size_t side = 0; side < grid.sides; ++side)
    addVertex(shape, grid.at(index, side), normal, uv(grid.at(index, side)));
  for (size_t side = 0; side < grid.sides; ++side) {
    const auto a = middle + 1 + static_cast<uint32_t>(side),
               b = middle + 1 + static_cast<uint32_t>((side + 1) % grid.sides);
    start ? addTriangle(shape, middle, b, a) : addTriangle(shape, middle, a, b);
  }
}

}  // namespace

Profile polygonProfile(int sides, double radius, double offset) {
  Profile profile;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * pi * (i + offset) / sides;
    profile.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return profile;
}

Profile rectangleProfile(double width, double height, double chamfer) {
  const double x = width / 2, y = height / 2, c = chamfer;
  if (c <= 0) return {{x, -y}, {x, y}, {-x, y}, {-x, -y}};
  return {{x, -y + c}, {x, y - c}, {x - c, y}, {-x + c, y}, {-x, y - c}, {-x, -y + c}, {-x + c, -y}, {x - c, -y}};
}

Path helixPath(double radius, double pitch, double turns, int steps) {
  Path path;
  for (int i = 0; i <= steps; ++i) {
    const double turn = turns * i / steps, angle = 2 * pi * turn;
    path.emplace_back(radius * std::cos(angle), pitch * turn, -radius * std::sin(angle));
  }
  return path;
}

Path arcPath(const glm::dvec3& centre, const glm::dvec3& axis, const glm::dvec3& start, double angle, int steps) {
  Path path;
  for (int i = 0; i <= steps; ++i)
    path.push_back(centre + turnedAbout(start - centre, glm::normalize(axis), angle * i / steps));
  return path;
}

std::vector<Frame> pathFrames(const Path& path, const glm::dvec3& x, bool closed) {
  const std::vector<glm::dvec3> along = directionsOf(path, closed);
  std::vector<Frame> frames = {frameOf(path[0], x, along[0])};
  for (size_t i = 1; i < path.size(); ++i)
    frames.push_back(
        frameOf(path[i], reflectedTwice(frames[i - 1].x, along[i - 1], path[i] - path[i - 1], along[i]), along[i]));
  if (!closed || path.size() < 3) return frames;
  const glm::dvec3 back = reflectedTwice(frames.back().x, along.back(), path[0] - path.back(), along[0]);
  const double off = std::atan2(glm::dot(back, frames[0].y), glm::dot(back, frames[0].x));
  for (size_t i = 1; i < frames.size(); ++i) {
    const double turn = -off * static_cast<double>(i) / static_cast<double>(frames.size());
    frames[i] = frameOf(path[i], turnedAbout(frames[i].x, along[i], turn), along[i]);
  }
  return frames;
}

std::vector<Floor> floorsAlong(const std::vector<Frame>& frames, double scale) {
  std::vector<Floor> floors;
  for (const Frame& frame : frames) floors.push_back({frame, glm::dvec2(scale)});
  return floors;
}

std::vector<Floor> tower(const std::vector<glm::dvec2>& heights) {
  std::vector<Floor> floors;
  for (const glm::dvec2& h : heights)
    floors.push_back({{{0, h.x, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, glm::dvec2(h.y)});
  return floors;
}

Shape sweep(const Profile& profile, const std::vector<Floor>& floors, const SweepOptions& options) {
  const Grid grid = gridOf(profile, floors);
  const size_t steps = options.closed ? grid.floors : grid.floors - 1;
  std::vector<double> u = {0}, v = {0};  // metres; around: of the largest floor
  double largest = 0;
  for (const Floor& floor : floors) largest = std::max({largest, floor.scale.x, floor.scale.y});
  for (size_t side = 0; side < grid.sides; ++side)
    u.push_back(u.back() + largest * glm::distance(profile[side], profile[(side + 1) % grid.sides]));
  for (size_t floor = 0; floor < steps; ++floor)
    v.push_back(v.back() + glm::distance(floors[floor].frame.origin, floors[(floor + 1) % grid.floors].frame.origin));
  // Of each point the sum of the faces about it, by their area.
  const auto smoothNormal = [&](size_t floor, size_t side) {
    glm::dvec3 sum(0);
    const auto add = [&](size_t f) { sum += faceNormal(grid, f, side) + faceNormal(grid, f, side + grid.sides - 1); };
    if (options.closed || floor < steps) add(floor);
    if (options.closed || floor > 0) add(floor + grid.floors - 1);
    return glm::length(sum) > 0 ? glm::normalize(sum) : floors[floor].frame.along;
  };
  Shape shape;
  for (size_t floor = 0; floor < steps; ++floor)
    for (size_t side = 0; side < grid.sides; ++side) {
      const glm::dvec3 face = faceNormal(grid, floor, side);
      if (!(glm::length(face) > 1e-12)) continue;
      const auto corner = [&](size_t f, size_t s) {
        const glm::dvec3 n = options.smooth ? smoothNormal(f % grid.floors, s % grid.sides) : glm::normalize(face);
        return addVertex(shape, grid.at(f, s), n, {u[s], v[f]});
      };
      const uint32_t a = corner(floor, side), b = corner(floor, side + 1), c = corner(floor + 1, side + 1),
                     d = corner(floor + 1, side);
      addTriangle(shape, a, b, c);
      addTriangle(shape, a, c, d);
    }
  if (options.caps && !options.closed) {
    addCap(shape, grid, floors.front(), 0, true);
    addCap(shape, grid, floors.back(), grid.floors - 1, false);
  }
  return shape;
}

Shape turnedShape(const std::vector<glm::dvec2>& outline, int sides, bool smooth) {
  std::vector<glm::dvec2> heights;
  for (const glm::dvec2& p : outline) heights.emplace_back(p.y, p.x);
  return sweep(polygonProfile(sides, 1), tower(heights), {.smooth = smooth});
}

Shape boxShape(const glm::dvec3& size, double chamfer) {
  const double y = size.y / 2, c = chamfer;
  const glm::dvec2 narrow((size.z - 2 * c) / size.z, (size.x - 2 * c) / size.x);  // the profile's x is the box's z
  std::vector<Floor> floors = tower({{-y, 1}, {-y + c, 1}, {y - c, 1}, {y, 1}});
  floors.front().scale = floors.back().scale = narrow;
  return sweep(rectangleProfile(size.z, size.x, c), floors);
}

Shape rectangleShape(const glm::dvec3& corner, const glm::dvec3& u, const glm::dvec3& v, double repeat) {
  Shape shape;
  const glm::dvec3 normal = glm::normalize(glm::cross(u, v));
  const double width = glm::length(u) * repeat, height = glm::length(v) * repeat;
  for (const glm::dvec2 at : {glm::dvec2(0, 0), {1, 0}, {1, 1}, {0, 1}})
    addVertex(shape, corner + at.x * u + at.y * v, normal, {at.x * width, (1 - at.y) * height});
  shape.indices = {0, 1, 2, 0, 2, 3};
  return shape;
}

void append(Shape& shape, const Shape& more) {
  const auto first = static_cast<uint32_t>(shape.positions.size());
  shape.positions.insert(shape.positions.end(), more.positions.begin(), more.positions.end());
  shape.normals.insert(shape.normals.end(), more.normals.begin(), more.normals.end());
  shape.texCoords.insert(shape.texCoords.end(), more.texCoords.begin(), more.texCoords.end());
  for (const uint32_t i : more.indices) shape.indices.push_back(first + i);
}

Shape moved(Shape shape, const glm::dvec3& by) {
  for (glm::vec3& p : shape.positions) p = glm::vec3(glm::dvec3(p) + by);
  return shape;
}

}  // namespace facet::scene
