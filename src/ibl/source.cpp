#include "ibl/source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/parallel.hpp"
#include "layout.h"

namespace facet::ibl {

namespace {

// Largest stored value; leaves half floats room for interpolation and sums.
constexpr float largestStored = 32768.0f;

// Mean over the sphere of the brightest channel; rows count by their share of it.
double meanRadiance(const scene::Environment& environment) {
  double sum = 0, weights = 0;
  for (int row = 0; row < environment.height; ++row) {
    double rowSum = 0;
    const glm::vec3* texels = &environment.radiance[static_cast<size_t>(row) * static_cast<size_t>(environment.width)];
    for (int column = 0; column < environment.width; ++column)
      rowSum += static_cast<double>(std::max({texels[column].x, texels[column].y, texels[column].z}));
    const double weight = std::sin(std::numbers::pi * (row + 0.5) / environment.height);
    sum += weight * rowSum;
    weights += weight * environment.width;
  }
  return sum / weights;
}

}  // namespace

float radianceScaleFor(const scene::Environment& environment) {
  float largest = 0;
  for (const glm::vec3& texel : environment.radiance) largest = std::max({largest, texel.x, texel.y, texel.z});
  return largest > largestStored ? std::exp2(std::ceil(std::log2(largest / largestStored))) : 1.0f;
}

gl::Texture equirectTexture(const scene::Environment& environment, GLenum format, std::string_view label) {
  gl::Texture texture({.format = format, .width = environment.width, .height = environment.height}, label);
  texture.filterLinear();
  texture.parameter(GL_TEXTURE_WRAP_S, GL_REPEAT);
  return texture;
}

void uploadEquirectRows(const gl::Texture& texture, const scene::Environment& environment, float scale, int first,
                        int end) {
  const auto width = static_cast<size_t>(environment.width);
  const std::span rows = std::span(environment.radiance)
                             .subspan(static_cast<size_t>(first) * width, static_cast<size_t>(end - first) * width);
  const glm::vec3* texels = rows.data();
  std::vector<glm::vec3> scaled;
  if (scale != 1) {
    for (const glm::vec3& texel : rows) scaled.push_back(texel / scale);
    texels = scaled.data();
  }
  glTextureSubImage2D(texture.id(), 0, 0, first, environment.width, end - first, GL_RGB, GL_FLOAT, texels);
}

gl::Texture cubeTexture(GLenum format, int size, int levels, std::string_view label) {
  gl::Texture texture(
      {.target = GL_TEXTURE_CUBE_MAP, .format = format, .width = size, .height = size, .levels = levels}, label);
  texture.filterLinear();
  return texture;
}

int levelOfSize(const gl::Texture& cube, int size) {
  int level = 0;
  while ((cube.description().width >> level) > size) ++level;
  return level;
}

void dispatchFaces(int size, int faces) {
  const GLuint groups = static_cast<GLuint>((size + 7) / 8);
  glDispatchCompute(groups, groups, static_cast<GLuint>(faces));
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
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

CubeSource cubeSource(const PreparedEnvironment& prepared, const Method& method) {
  scene::Environment map = prepared.reduced;
  if (method.cube == CubeMethod::areaExact) {
    // A needle is caught when it is as wide as the distance of two of the cube's taps.
    const double tap = std::numbers::pi / 2 / 256 / method.cubeTaps;
    blendPolarTexels(map, 2 * tap);
  }
  CubeSource source{equirectTexture(map, GL_RGBA32F, "equirectangular source"), 0};
  uploadEquirectRows(source.equirect, map, prepared.radianceScale, 0, map.height);
  source.steep = static_cast<float>(method.steepness * meanRadiance(map) / static_cast<double>(prepared.radianceScale));
  return source;
}

Result<void> drawCubeFaces(const gl::Texture& cube, const CubeSource& source, int firstFace, int faces,
                           shading::ProgramStore& programs, const Method& method) {
  const bool oneTap = method.cube == CubeMethod::oneTap;
  const auto program =
      programs.compute("passes/equirect_to_cube.comp.glsl",
                       oneTap ? std::vector<shading::Define>{{"ONE_TAP"}} : std::vector<shading::Define>{});
  if (!program) return tl::unexpected(program.error());
  glUseProgram((*program)->id());
  if (!oneTap) {
    (*program)->set(0, method.cubeTaps);
    (*program)->set(1, method.steepTaps);
    (*program)->set(2, source.steep);
  }
  (*program)->set(3, firstFace);
  source.equirect.bind(layout::equirectUnit);
  glBindImageTexture(0, cube.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  dispatchFaces(cube.description().width, faces);
  return {};
}

Result<void> drawCubeLevels(const gl::Texture& cube, shading::ProgramStore& programs) {
  const auto program = programs.compute("passes/cube_mip.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  glUseProgram((*program)->id());
  for (int level = 1; level < cube.description().levels; ++level) {
    glBindImageTexture(0, cube.id(), level - 1, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA32F);
    glBindImageTexture(1, cube.id(), level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchFaces(cube.description().width >> level);
  }
  return {};
}

uint64_t cubeFetches(int size, const Method& method) {
  const uint64_t texels = uint64_t{6} * static_cast<uint64_t>(size) * static_cast<uint64_t>(size);
  if (method.cube == CubeMethod::oneTap) return texels + texels * 4 / 3;
  return texels * static_cast<uint64_t>(method.cubeTaps * method.cubeTaps + 4) + texels * 4 / 3;
}

}  // namespace facet::ibl
