#include "scene/shapes.hpp"

#include <cmath>

#include "base/angle.hpp"

namespace facet::scene {

namespace {

void addVertex(Shape& shape, const glm::dvec3& position, const glm::dvec3& normal, double u, double v) {
  shape.positions.emplace_back(position);
  shape.normals.emplace_back(normal);
  shape.texCoords.emplace_back(u, v);
}

// Two triangles of a grid's cell (row, column) with columns + 1 vertices a row; rows run down, columns to the right.
void addCell(Shape& shape, int row, int column, int columns, bool upper = true, bool lower = true) {
  const auto a = uint32_t(row * (columns + 1) + column), b = a + 1, c = a + uint32_t(columns) + 1, d = c + 1;
  if (upper) shape.indices.insert(shape.indices.end(), {a, d, b});
  if (lower) shape.indices.insert(shape.indices.end(), {a, c, d});
}

}  // namespace

Shape sphereShape(int stacks, int slices) {
  Shape shape;
  for (int i = 0; i <= stacks; ++i) {
    const double theta = pi * i / stacks;
    const double level = i == 0 || i == stacks ? 0 : std::sin(theta);  // poles are points
    for (int j = 0; j <= slices; ++j) {
      const double phi = 2 * pi * (j % slices) / slices;  // the seam closes to the bit
      const glm::dvec3 p(-level * std::cos(phi), std::cos(theta), level * std::sin(phi));
      // At a pole the triangle's u is that of its middle.
      const double u = (j + (level == 0 ? (i == 0 ? 0.5 : -0.5) : 0)) / slices;
      addVertex(shape, p, p, u, double(i) / stacks);
    }
  }
  for (int i = 0; i < stacks; ++i)
    for (int j = 0; j < slices; ++j) addCell(shape, i, j, slices, i > 0, i + 1 < stacks);
  // The triangles at the poles are (pole, below left, below right) and (above left, pole, above right).
  return shape;
}

glm::dvec3 torusKnotPoint(double t) {
  const double a = 4 * pi * t, b = 6 * pi * t;
  const double r = 1 + 0.5 * std::cos(b);
  return {r * std::cos(a), r * std::sin(a), 0.5 * std::sin(b)};
}

Shape torusKnotShape(double tubeRadius, int segments, int sides) {
  Shape shape;
  for (int i = 0; i <= segments; ++i) {
    const double t = double(i % segments) / segments, h = 1e-4;
    const glm::dvec3 center = torusKnotPoint(t);
    const glm::dvec3 along = glm::normalize(torusKnotPoint(t + h) - torusKnotPoint(t - h));
    // Any frame that closes: away from the knot's centre, made perpendicular to the curve.
    const glm::dvec3 side = glm::normalize(glm::cross(along, center));
    const glm::dvec3 out = glm::cross(side, along);
    for (int j = 0; j <= sides; ++j) {
      const double phi = 2 * pi * (j % sides) / sides;
      const glm::dvec3 n = out * std::cos(phi) - side * std::sin(phi);
      addVertex(shape, center + n * tubeRadius, n, 24.0 * i / segments, double(j) / sides);
    }
  }
  for (int i = 0; i < segments; ++i)
    for (int j = 0; j < sides; ++j) addCell(shape, i, j, sides);
  return shape;
}

Shape discShape(double radius, double rimRadius, int rings, int segments) {
  Shape shape;
  constexpr int rimSteps = 12;
  const double flat = radius - rimRadius;
  for (int i = 0; i <= rings + rimSteps; ++i) {
    const bool rim = i > rings;
    const double tilt = rim ? pi / 2 * (i - rings) / rimSteps : 0;  // of the normal, towards outside
    const double r = rim ? flat + rimRadius * std::sin(tilt) : flat * i / rings;
    const double y = rimRadius * (std::cos(tilt) - 1);
    for (int j = 0; j <= segments; ++j) {
      const double phi = 2 * pi * (j % segments) / segments;
      const glm::dvec3 out(std::cos(phi), 0, -std::sin(phi));
      addVertex(shape, out * r + glm::dvec3(0, y, 0), out * std::sin(tilt) + glm::dvec3(0, std::cos(tilt), 0),
                0.5 + 0.5 * out.x * r / radius, 0.5 + 0.5 * out.z * r / radius);
    }
  }
  for (int i = 0; i < rings + rimSteps; ++i)
    for (int j = 0; j < segments; ++j) addCell(shape, i, j, segments, i > 0);
  return shape;
}

}  // namespace facet::scene
