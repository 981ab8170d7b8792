#include "ibl/harmonics.hpp"

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "ibl/source.hpp"
#include "optics/mapping.hpp"
#include "optics/zonal.hpp"

namespace facet::ibl {

namespace {

// The clamped cosine / pi, degree by degree, by quadrature: 1, 2/3, 1/4, 0, -1/24, 0, ...
std::vector<double> cosineCoefficients(size_t count) {
  constexpr int nodes = 4000;
  std::vector<double> sum(count, 0);
  for (int i = 0; i < nodes; ++i) {
    const double mu = (i + 0.5) / nodes;
    const std::vector<double> P = optics::legendre(mu, count);
    for (size_t l = 0; l < count; ++l) sum[l] += 2 * mu * P[l] / nodes;
  }
  return sum;
}

glm::dvec3 centre(int face, int column, int row, int size) {
  return optics::directionFromCube({face, {(column + 0.5) / size, (row + 0.5) / size}});
}

}  // namespace

// By the addition theorem no basis is needed: the projection of degree l, evaluated at n, is
// (2l + 1) / 4 pi int L(d) P_l(n.d) dd.
gl::Texture irradianceByHarmonics(const gl::Texture& cube, int order, int size) {
  const int level = levelOfSize(cube, harmonicsSource);
  const int source = cube.description().width >> level;
  const auto count = static_cast<size_t>(6 * source * source);
  std::vector<glm::vec4> values(count);
  glGetTextureImage(cube.id(), level, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(count * sizeof(glm::vec4)),
                    values.data());
  std::vector<double> kernel = cosineCoefficients(static_cast<size_t>(order) + 1);
  for (size_t l = 0; l < kernel.size(); ++l) kernel[l] *= (2 * static_cast<double>(l) + 1) / (4 * std::numbers::pi);
  const auto at = [&](int face, size_t i, int edge) {
    const auto e = static_cast<size_t>(edge);
    return centre(face, static_cast<int>(i % e), static_cast<int>(i / e % e), edge);
  };
  const auto sourceFace = static_cast<size_t>(source * source), face = static_cast<size_t>(size * size);
  std::vector<glm::dvec3> directions;
  for (size_t i = 0; i < count; ++i) directions.push_back(at(static_cast<int>(i / sourceFace), i, source));
  std::vector<glm::vec4> result;
  for (size_t i = 0; i < 6 * face; ++i) {
    const glm::dvec3 n = at(static_cast<int>(i / face), i, size);
    glm::dvec3 sum(0);
    for (size_t k = 0; k < count; ++k) {
      const double x = glm::dot(n, directions[k]);
      double previous = 1, P = x, weight = kernel[0];
      for (size_t l = 1; l < kernel.size(); ++l) {
        weight += kernel[l] * P;
        const auto d = static_cast<double>(l);
        const double next = ((2 * d + 1) * x * P - d * previous) / (d + 1);
        previous = P, P = next;
      }
      sum += glm::dvec3(values[k]) * (weight * static_cast<double>(values[k].w));
    }
    result.emplace_back(glm::vec3(sum), 1.0f);
  }
  gl::Texture texture = cubeTexture(GL_RGBA32F, size, 1, "irradiance / pi");
  glTextureSubImage3D(texture.id(), 0, 0, 0, 0, size, size, 6, GL_RGBA, GL_FLOAT, result.data());
  return texture;
}

}  // namespace facet::ibl
