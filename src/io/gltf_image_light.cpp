#include "io/gltf_image_light.hpp"

#include <algorithm>
#include <cmath>

namespace facet::io {

namespace {

struct Met {
  size_t face = 0;
  double s = 0, t = 0;  // [0, 1], OpenGL's (4.6, table 8.19)
};

Met meet(const glm::dvec3& d) {
  const glm::dvec3 a = glm::abs(d);
  if (a.x >= a.y && a.x >= a.z)
    return d.x > 0 ? Met{0, 0.5 - 0.5 * d.z / a.x, 0.5 - 0.5 * d.y / a.x}
                   : Met{1, 0.5 + 0.5 * d.z / a.x, 0.5 - 0.5 * d.y / a.x};
  if (a.y >= a.z)
    return d.y > 0 ? Met{2, 0.5 + 0.5 * d.x / a.y, 0.5 + 0.5 * d.z / a.y}
                   : Met{3, 0.5 + 0.5 * d.x / a.y, 0.5 - 0.5 * d.z / a.y};
  return d.z > 0 ? Met{4, 0.5 + 0.5 * d.x / a.z, 0.5 - 0.5 * d.y / a.z}
                 : Met{5, 0.5 - 0.5 * d.x / a.z, 0.5 - 0.5 * d.y / a.z};
}

std::array<double, 9> basis(const glm::dvec3& d) {
  return {0.282094792,
          0.488602512 * d.y,
          0.488602512 * d.z,
          0.488602512 * d.x,
          1.092548431 * d.x * d.y,
          1.092548431 * d.y * d.z,
          0.315391565 * (3 * d.z * d.z - 1),
          1.092548431 * d.x * d.z,
          0.546274215 * (d.x * d.x - d.y * d.y)};
}

}  // namespace

glm::dvec3 cubeRadiance(const CubeMap& cube, const glm::dvec3& direction, bool mirrored) {
  const Met met = meet(mirrored ? glm::dvec3(-direction.x, direction.y, direction.z) : direction);
  const double last = cube.size - 1;
  const double x = std::clamp((mirrored ? met.s : 1 - met.s) * cube.size - 0.5, 0.0, last);
  const double y = std::clamp(met.t * cube.size - 0.5, 0.0, last);
  const auto at = [&](double column, double row) {
    const double c = std::min(column, last), r = std::min(row, last);
    return glm::dvec3(
        cube.faces[met.face][static_cast<size_t>(r) * static_cast<size_t>(cube.size) + static_cast<size_t>(c)]);
  };
  const double left = std::floor(x), top = std::floor(y);
  return glm::mix(glm::mix(at(left, top), at(left + 1, top), x - left),
                  glm::mix(at(left, top + 1), at(left + 1, top + 1), x - left), y - top);
}

std::array<glm::dvec3, 9> harmonicsOf(const CubeMap& cube, bool mirrored) {
  constexpr int rows = 64;  // low frequencies: finer ones average out
  constexpr double pi = 3.14159265358979324;
  std::array<glm::dvec3, 9> sums{};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < 2 * rows; ++column) {
      const double latitude = pi * ((row + 0.5) / rows - 0.5), longitude = pi * (column + 0.5) / rows;
      const glm::dvec3 d(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                         std::cos(latitude) * std::sin(longitude));
      const glm::dvec3 light = cubeRadiance(cube, d, mirrored) * (std::cos(latitude) * pi * pi / (rows * rows));
      const std::array<double, 9> y = basis(d);
      for (size_t i = 0; i < y.size(); ++i) sums[i] += light * y[i];
    }
  return sums;
}

}  // namespace facet::io
