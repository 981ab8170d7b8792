#include "ibl/tables.hpp"

#include <algorithm>
#include <cassert>
#include <chrono>
#include <cmath>
#include <numbers>

#include "base/parallel.hpp"
#include "gl/buffer.hpp"
#include "ibl/kernel.hpp"
#include "ibl/layers.hpp"
#include "layout.h"
#include "optics/quadrature.hpp"

namespace facet::ibl {

namespace {

using Clock = std::chrono::steady_clock;
using shading::ProgramStore;

// Largest stored value; leaves half floats room for interpolation and sums.
constexpr float largestStored = 32768.0f;

float radianceScaleFor(const scene::Environment& environment) {
  float largest = 0;
  for (const glm::vec3& texel : environment.radiance) largest = std::max({largest, texel.x, texel.y, texel.z});
  return largest > largestStored ? std::exp2(std::ceil(std::log2(largest / largestStored))) : 1.0f;
}

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

gl::Texture uploadEquirect(const scene::Environment& environment, GLenum format, float scale, std::string_view label) {
  gl::Texture texture({.format = format, .width = environment.width, .height = environment.height}, label);
  texture.filterLinear();
  texture.parameter(GL_TEXTURE_WRAP_S, GL_REPEAT);
  const std::vector<glm::vec3>* texels = &environment.radiance;
  std::vector<glm::vec3> scaled;
  if (scale != 1) {
    scaled = environment.radiance;
    for (glm::vec3& texel : scaled) texel /= scale;
    texels = &scaled;
  }
  glTextureSubImage2D(texture.id(), 0, 0, 0, environment.width, environment.height, GL_RGB, GL_FLOAT, texels->data());
  return texture;
}

gl::Texture cubeTexture(GLenum format, int size, int levels, std::string_view label) {
  gl::Texture texture(
      {.target = GL_TEXTURE_CUBE_MAP, .format = format, .width = size, .height = size, .levels = levels}, label);
  texture.filterLinear();
  return texture;
}

gl::Texture cubeArray(int size, int cubes, int levels, std::string_view label) {
  gl::Texture texture({.target = GL_TEXTURE_CUBE_MAP_ARRAY,
                       .format = GL_RGBA16F,
                       .width = size,
                       .height = size,
                       .layers = cubes,
                       .levels = levels},
                      label);
  texture.filterLinear();
  if (levels > 1) texture.parameter(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  return texture;
}

void dispatchFaces(int size, int faces = 6) {
  const GLuint groups = static_cast<GLuint>((size + 7) / 8);
  glDispatchCompute(groups, groups, static_cast<GLuint>(faces));
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
}

// Runs one step, waits for it and books it.
template <class Step>
Result<void> timed(std::vector<TableStatistics>& statistics, const char* name, size_t bytes, uint64_t fetches,
                   Step&& step) {
  const Clock::time_point start = Clock::now();
  if (Result<void> result = step(); !result) return result;
  glFinish();
  statistics.push_back({name, bytes, fetches, std::chrono::duration<double, std::milli>(Clock::now() - start).count()});
  return {};
}

// A square table by quadrature over two variables.
struct AlbedoTable {
  const char* name;
  const char* pass;
  GLenum format;
  int size, firstNodes, secondNodes;
};

Result<void> computeAlbedo(gl::Texture& table, ProgramStore& programs, const AlbedoTable& made) {
  const auto program = programs.compute(made.pass);
  if (!program) return tl::unexpected(program.error());
  std::vector<glm::vec2> nodes;
  for (const int count : {made.firstNodes, made.secondNodes}) {
    const optics::Quadrature rule = optics::gaussLegendre(static_cast<size_t>(count));
    for (size_t i = 0; i < rule.nodes.size(); ++i) nodes.emplace_back(rule.nodes[i], rule.weights[i]);
  }
  const gl::Buffer input = gl::Buffer::of(nodes, "quadrature");
  table = gl::Texture({.format = made.format, .width = made.size, .height = made.size}, made.name);
  table.filterLinear();
  glUseProgram((*program)->id());
  (*program)->set(0, made.firstNodes);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, input.id());
  glBindImageTexture(0, table.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, made.format);
  dispatchFaces(made.size, 1);
  return {};
}

// Computes and books it.
Result<void> addAlbedo(gl::Texture& table, std::vector<TableStatistics>& booked, size_t texelBytes,
                       ProgramStore& programs, const AlbedoTable& made) {
  const auto size = static_cast<uint64_t>(made.size);
  const auto nodes = static_cast<uint64_t>(made.firstNodes * made.secondNodes);
  return timed(booked, made.name, size * size * texelBytes, size * size * nodes,
               [&] { return computeAlbedo(table, programs, made); });
}

// The environment as a cube map with solid-angle-weighted levels down to 1^2.
Result<gl::Texture> environmentCube(const scene::Environment& environment, float scale, ProgramStore& programs,
                                    const Method& method) {
  const auto toCube = programs.compute("passes/equirect_to_cube.comp.glsl");
  if (!toCube) return tl::unexpected(toCube.error());
  const auto toMip = programs.compute("passes/cube_mip.comp.glsl");
  if (!toMip) return tl::unexpected(toMip.error());
  const bool tooWide = environment.width > method.equirectWidth;
  scene::Environment reduced;
  if (tooWide) reduced = reduceEquirect(environment, method.equirectWidth);
  const scene::Environment& source = tooWide ? reduced : environment;
  const gl::Texture equirect = uploadEquirect(source, GL_RGBA32F, scale, "equirectangular source");
  const double steep = method.steepness * meanRadiance(source) / static_cast<double>(scale);
  gl::Texture cube = cubeTexture(GL_RGBA32F, mirrorSize, gl::mipLevels(mirrorSize, mirrorSize), "environment cube");
  glUseProgram((*toCube)->id());
  (*toCube)->set(0, method.cubeTaps);
  (*toCube)->set(1, method.steepTaps);
  (*toCube)->set(2, static_cast<float>(steep));
  equirect.bind(layout::equirectUnit);
  glBindImageTexture(0, cube.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  dispatchFaces(mirrorSize);
  glUseProgram((*toMip)->id());
  for (int level = 1; level < cube.description().levels; ++level) {
    glBindImageTexture(0, cube.id(), level - 1, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA32F);
    glBindImageTexture(1, cube.id(), level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchFaces(mirrorSize >> level);
  }
  return cube;
}

Result<void> computeIrradiance(gl::Texture& irradiance, const gl::Texture& cube, ProgramStore& programs,
                               const Method& method) {
  constexpr int listLevel = 3, listSize = mirrorSize >> listLevel;
  const auto toList = programs.compute("passes/cube_to_list.comp.glsl");
  if (!toList) return tl::unexpected(toList.error());
  const auto sum = programs.compute("passes/irradiance.comp.glsl");
  if (!sum) return tl::unexpected(sum.error());
  const gl::Buffer list(size_t{6} * listSize * listSize * 2 * sizeof(glm::vec4), "environment list");
  glUseProgram((*toList)->id());
  glBindImageTexture(0, cube.id(), listLevel, GL_TRUE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, list.id());
  dispatchFaces(listSize);
  irradiance = cubeTexture(GL_RGBA16F, method.irradianceSize, 1, "irradiance / pi");
  glUseProgram((*sum)->id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, list.id());
  glBindImageTexture(0, irradiance.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
  dispatchFaces(method.irradianceSize);
  return {};
}

int sampleCount(const Layer& layer, const Method& method) {
  if (layer.perceptualRoughness == 0) return 1;
  // The lobe of r = 0.05 is narrower than a texel of the cube.
  if (layer.mirror) return 8;
  return layer.perceptualRoughness < 0.25 ? method.samplesNarrow : method.samplesWide;
}

uint64_t layerFetches(const Layer& layer, const Method& method) {
  return uint64_t{6} * static_cast<uint64_t>(layer.size) * static_cast<uint64_t>(layer.size) *
         static_cast<uint64_t>(sampleCount(layer, method));
}

Result<void> computeLayer(const Layer& layer, const gl::Texture& target, const gl::Texture& cube,
                          ProgramStore& programs, const Method& method) {
  const auto program = programs.compute("passes/prefilter.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  std::vector<glm::vec4> samples;
  const double alpha = layer.perceptualRoughness * layer.perceptualRoughness;
  for (const KernelSample& s : kernelSamples(alpha, sampleCount(layer, method), mirrorSize))
    samples.emplace_back(glm::vec3(s.direction), static_cast<float>(s.level));
  const gl::Buffer input = gl::Buffer::of(samples, "LD samples");
  glUseProgram((*program)->id());
  (*program)->set(0, layer.cube);
  cube.bind(layout::sourceUnit);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, input.id());
  glBindImageTexture(0, target.id(), layer.level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
  dispatchFaces(layer.size);
  return {};
}

}  // namespace

size_t Tables::bytes() const {
  size_t sum = 0;
  for (const gl::Texture* texture : {&dfg, &sheen, &irradiance, &mirrorLayers, &roughLayers, &cube, &background})
    if (*texture) sum += texture->bytes();
  return sum;
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

Result<void> computeTables(Tables& tables, const scene::Environment* environment, const Needs& needs,
                           ProgramStore& programs, const Method& method) {
  std::vector<TableStatistics>& booked = tables.statistics;
  booked.clear();
  if (needs.dfg && !tables.dfg) {
    const AlbedoTable made{"DFG",          "passes/dfg.comp.glsl", GL_RGBA16F,
                           method.dfgSize, method.dfgRadii,        method.dfgAngles};
    if (auto r = addAlbedo(tables.dfg, booked, 8, programs, made); !r) return r;
  }
  if (needs.sheen && !tables.sheen) {
    const AlbedoTable made{
        "sheen", "passes/sheen_albedo.comp.glsl", GL_R32F, method.sheenSize, method.sheenHeights, method.sheenAngles};
    if (auto r = addAlbedo(tables.sheen, booked, 4, programs, made); !r) return r;
  }
  const bool background = needs.background && !tables.background;
  const bool irradiance = needs.irradiance && !tables.irradiance;
  const bool layersWanted = needs.layers && !tables.roughLayers;
  const bool cubeWanted = needs.cube && !tables.cube;
  if (!background && !irradiance && !layersWanted && !cubeWanted) return {};

  assert(environment != nullptr && environment->width > 0);
  tables.radianceScale = radianceScaleFor(*environment);
  if (background) tables.background = uploadEquirect(*environment, GL_RGBA16F, tables.radianceScale, "background");
  if (!irradiance && !layersWanted && !cubeWanted) return {};

  gl::Texture made;  // freed at the end unless it is asked for
  if (!tables.cube) {
    const uint64_t texels = uint64_t{6} * mirrorSize * mirrorSize;
    const uint64_t fetches = texels * static_cast<uint64_t>(method.cubeTaps * method.cubeTaps) + texels * 4 / 3;
    const auto make = [&]() -> Result<void> {
      Result<gl::Texture> cube = environmentCube(*environment, tables.radianceScale, programs, method);
      if (!cube) return tl::unexpected(cube.error());
      made = std::move(*cube);
      return {};
    };
    if (auto r = timed(booked, "environment cube", 0, fetches, make); !r) return r;
  }
  const gl::Texture& cube = tables.cube ? tables.cube : made;
  if (irradiance) {
    const auto faceTexels = static_cast<uint64_t>(method.irradianceSize * method.irradianceSize);
    const auto make = [&] { return computeIrradiance(tables.irradiance, cube, programs, method); };
    if (auto r = timed(booked, "irradiance", 6 * faceTexels * 8, 6 * faceTexels * 6 * 32 * 32, make); !r) return r;
  }
  if (layersWanted) {
    gl::Texture mirrorLayers = cubeArray(mirrorSize, layout::ldMirrorLayerCount, 1, "LD mirror layers");
    gl::Texture roughLayers = cubeArray(roughSize, roughCubes, 3, "LD rough layers");
    uint64_t fetches = 0;
    for (const Layer& layer : layers) fetches += layerFetches(layer, method);
    const auto make = [&]() -> Result<void> {
      for (const Layer& layer : layers)
        if (Result<void> r = computeLayer(layer, layer.mirror ? mirrorLayers : roughLayers, cube, programs, method); !r)
          return r;
      return {};
    };
    const size_t bytes = mirrorLayers.bytes() + roughLayers.bytes();
    if (auto r = timed(booked, "LD layers", bytes, fetches, make); !r) return r;
    tables.mirrorLayers = std::move(mirrorLayers);
    tables.roughLayers = std::move(roughLayers);
  }
  if (cubeWanted) tables.cube = std::move(made);
  return {};
}

}  // namespace facet::ibl
