#include "ibl/source.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "base/parallel.hpp"
#include "layout.h"

namespace facet::ibl {

namespace {

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
  const GLuint groups = static_cast<GLuint>(layout::groupsFor(size));
  glDispatchCompute(groups, groups, static_cast<GLuint>(faces));
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
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
    (*program)->set(layout::cubeTapsLocation, method.cubeTaps);
    (*program)->set(layout::cubeSteepTapsLocation, method.steepTaps);
    (*program)->set(layout::cubeSteepLocation, source.steep);
  }
  (*program)->set(layout::cubeFirstFaceLocation, firstFace);
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
