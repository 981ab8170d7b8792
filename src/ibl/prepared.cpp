#include "ibl/prepared.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"

namespace facet::ibl {

namespace {

// Largest stored value; leaves half floats room for interpolation and sums. Of maps below the other, the largest
// becomes 1, since halves below 2^-14 hold fewer bits the smaller they are.
constexpr float largestStored = 32768.0f, dimmest = 1.0f / 64;

}  // namespace

float radianceScaleFor(const scene::Environment& environment) {
  float largest = 0;
  for (const glm::vec3& texel : environment.radiance) largest = std::max({largest, texel.x, texel.y, texel.z});
  if (largest > largestStored) return std::exp2(std::ceil(std::log2(largest / largestStored)));
  return largest > 0 && largest < dimmest ? std::exp2(std::max(std::ceil(std::log2(largest)), -100.0f)) : 1.0f;
}

scene::Environment reduceEquirect(const scene::Environment& environment, int maxWidth) {
  const int factor = (environment.width + maxWidth - 1) / maxWidth;
  if (factor <= 1) return environment;
  scene::Environment out;
  out.name = environment.name;
  out.width = (environment.width + factor - 1) / factor;
  out.height = std::max(1, (environment.height + factor - 1) / factor);
  out.radiance.resize(static_cast<size_t>(out.width) * static_cast<size_t>(out.height));
  // Area resampling: source rows and columns count by their overlap, rows by their band's share of the sphere.
  const auto bandEdge = [](double row, int height) { return std::cos(std::numbers::pi * row / height); };
  parallelFor(static_cast<size_t>(out.height), [&](size_t y) {
    const double top = static_cast<double>(y) * environment.height / out.height;
    const double bottom = static_cast<double>(y + 1) * environment.height / out.height;
    for (int x = 0; x < out.width; ++x) {
      const double left = static_cast<double>(x) * environment.width / out.width;
      const double right = static_cast<double>(x + 1) * environment.width / out.width;
      glm::dvec3 sum(0);
      double weights = 0;
      for (int sy = static_cast<int>(top); sy < std::min<double>(environment.height, std::ceil(bottom)); ++sy) {
        const double band = bandEdge(std::max<double>(sy, top), environment.height) -
                            bandEdge(std::min<double>(sy + 1, bottom), environment.height);
        for (int sx = static_cast<int>(left); sx < std::min<double>(environment.width, std::ceil(right)); ++sx) {
          const double w = band * (std::min<double>(sx + 1, right) - std::max<double>(sx, left));
          sum += w * glm::dvec3(environment.radiance[static_cast<size_t>(sy) * static_cast<size_t>(environment.width) +
                                                     static_cast<size_t>(sx)]);
          weights += w;
        }
      }
      out.radiance[y * static_cast<size_t>(out.width) + static_cast<size_t>(x)] = glm::vec3(sum / weights);
    }
  });
  return out;
}

void blendPolarTexels(scene::Environment& environment, double maxWidth) {
  const int width = environment.width, height = environment.height;
  for (int row = 0; row < height; ++row) {
    const double texel = 2 * std::numbers::pi / width * std::sin(std::numbers::pi * (row + 0.5) / height);
    const int run = static_cast<int>(std::min<double>(width, maxWidth / texel));
    if (run < 2) continue;
    glm::vec3* texels = &environment.radiance[static_cast<size_t>(row) * static_cast<size_t>(width)];
    for (int first = 0; first < width; first += run) {
      const int end = std::min(width, first + run);
      glm::dvec3 sum(0);
      for (int column = first; column < end; ++column) sum += glm::dvec3(texels[column]);
      std::fill(texels + first, texels + end, glm::vec3(sum / static_cast<double>(end - first)));
    }
  }
}

PreparedEnvironment prepareEnvironment(const scene::Environment& environment, const Method& method,
                                       const scene::FoundSun* found) {
  PreparedEnvironment prepared{radianceScaleFor(environment), {}, {}};
  std::optional<scene::FoundSun> here;
  if (!method.takeSunOut) found = nullptr;
  if (method.takeSunOut && !found && (here = scene::findSun(environment))) found = &*here;
  if (found) prepared.sun = found->sun;
  prepared.reduced = reduceEquirect(found ? found->rest : environment, method.equirectWidth);
  return prepared;
}

PreparedEnvironment reducedFurther(const PreparedEnvironment& prepared, int maxWidth) {
  return {prepared.radianceScale, prepared.sun, reduceEquirect(prepared.reduced, maxWidth)};
}

}  // namespace facet::ibl
