#include "ibl/filters.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/angle.hpp"
#include "gl/buffer.hpp"
#include "ibl/harmonics.hpp"
#include "ibl/kernel.hpp"
#include "ibl/layers.hpp"
#include "ibl/mixtures.hpp"
#include "layout.h"
#include "optics/quadrature.hpp"

namespace facet::ibl {

namespace {

using shading::ProgramStore;
using ScratchPointer = std::shared_ptr<Scratch>;

uint64_t texels(int size, int faces = 6) {
  return static_cast<uint64_t>(faces) * static_cast<uint64_t>(size) * static_cast<uint64_t>(size);
}

// Large faces one by one, so that no step is long.
template <class Run>
void addByFaces(std::vector<Step>& steps, const char* table, int size, uint64_t fetchesPerTexel, const Run& run) {
  const int faces = size >= 128 ? 1 : 6;
  for (int face = 0; face < 6; face += faces)
    steps.push_back({table, texels(size, faces) * fetchesPerTexel, [=] { return run(face, faces); }});
}

// ---- Sums over the sphere -------------------------------------------------------------------------------------------

// Texels along a cell's edge: enough for its centroid and spread.
int cellTexels(int sumSize) { return std::min(8, mirrorSize / sumSize); }

gl::Buffer cellsOf(const gl::Texture& cube, int sumSize, const gl::Program& program) {
  gl::Buffer cells(texels(sumSize) * layout::cellVectors * sizeof(glm::vec4), "environment cells");
  glUseProgram(program.id());
  program.set(layout::cellTexelsLocation, cellTexels(sumSize));
  glBindImageTexture(0, cube.id(), levelOfSize(cube, sumSize * cellTexels(sumSize)), GL_TRUE, 0, GL_READ_ONLY,
                     GL_RGBA32F);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, cells.id());
  dispatchFaces(sumSize);
  return cells;
}

void addSum(std::vector<Step>& steps, const char* table, size_t which, const ScratchPointer& scratch,
            ProgramStore& programs, const Method& method) {
  scratch->sumPlanned[which] = true;
  const int size = method.irradianceSize, sumSize = method.sumSize;
  const auto run = [=, &programs]() -> Result<void> {
    const auto toCells = programs.compute("passes/cube_to_cells.comp.glsl");
    if (!toCells) return tl::unexpected(toCells.error());
    const auto sum = programs.compute("passes/zonal_sum.comp.glsl");
    if (!sum) return tl::unexpected(sum.error());
    gl::Texture& result = scratch->summed[which];
    result = cubeTexture(GL_RGBA32F, size, 1, "summed kernel");
    const gl::Buffer cells = cellsOf(scratch->environmentCube(), sumSize, **toCells);
    glUseProgram((*sum)->id());
    (*sum)->set(layout::sumAlpha2Location,
                static_cast<float>(optics::summedAlphas[which] * optics::summedAlphas[which]));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, cells.id());
    glBindImageTexture(0, result.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchFaces(size);
    return {};
  };
  const int groups = layout::groupsFor(size);  // each reads the cells once
  steps.push_back(
      {table, texels(sumSize * cellTexels(sumSize)) + texels(groups) * layout::cellVectors * texels(sumSize), run});
}

// ---- Mixtures of blurred copies -------------------------------------------------------------------------------------

void addBlur(std::vector<Step>& steps, size_t index, const optics::BlurredCopy& copy, const ScratchPointer& scratch,
             ProgramStore& programs) {
  std::vector<glm::vec4> taps;
  for (const optics::Ring& ring : copy.rings)
    for (int i = 0; i < ring.count; ++i) {
      const double phi = 2 * pi * (i + ring.turn) / ring.count, sine = std::sin(ring.angle);
      taps.emplace_back(sine * std::cos(phi), sine * std::sin(phi), std::cos(ring.angle), ring.weight / ring.count);
    }
  const auto run = [=, &programs, size = copy.size](int face, int faces) -> Result<void> {
    const auto program = programs.compute("passes/blur.comp.glsl");
    if (!program) return tl::unexpected(program.error());
    gl::Texture& blurred = scratch->blurred[index];
    if (!blurred) blurred = cubeTexture(GL_RGBA32F, size, 1, "blurred environment");
    const gl::Buffer input = gl::Buffer::of(taps, "taps");
    glUseProgram((*program)->id());
    (*program)->set(layout::blurFirstFaceLocation, face);
    (index == 1 ? scratch->environmentCube() : scratch->blurred[index - 1]).bind(layout::sourceUnit);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, input.id());
    glBindImageTexture(0, blurred.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchFaces(size, faces);
    return {};
  };
  addByFaces(steps, "LD layers", copy.size, taps.size(), run);
}

using MixtureParts = std::vector<std::pair<size_t, float>>;

template <class Weights>
MixtureParts partsThatCount(const Weights& weights) {
  MixtureParts parts;
  for (size_t i = 0; i < weights.size(); ++i)
    if (weights[i] > 0) parts.emplace_back(i, static_cast<float>(weights[i]));
  return parts;
}

// Roughness 0 is the cube.
MixtureParts mixtureOf(const LayerTarget& target) {
  if (!target.mixture.empty()) return partsThatCount(target.mixture);
  if (target.perceptualRoughness == 0) return {{0, 1.0f}};
  const auto layer = std::ranges::find(layers, target.perceptualRoughness, &Layer::perceptualRoughness);
  assert(layer != layers.end());
  return partsThatCount(mixtures[static_cast<size_t>(layer - layers.begin() - 1)]);
}

void addMixture(std::vector<Step>& steps, const LayerTarget& layer, const ScratchPointer& scratch,
                ProgramStore& programs) {
  const auto parts = mixtureOf(layer);
  const auto run = [=, &programs](int face, int faces) -> Result<void> {
    const auto program = programs.compute("passes/mix.comp.glsl");
    if (!program) return tl::unexpected(program.error());
    glUseProgram((*program)->id());
    (*program)->set(layout::layerCubeLocation, layer.cube);
    (*program)->set(layout::layerFirstFaceLocation, face);
    (*program)->set(layout::mixCountLocation, static_cast<int>(parts.size()));
    for (size_t i = 0; i < parts.size(); ++i) {
      const size_t part = parts[i].first;
      const gl::Texture& texture = part == 0                 ? scratch->environmentCube()
                                   : part < blurredCopyCount ? scratch->blurred[part]
                                                             : scratch->summed[part - blurredCopyCount];
      texture.bind(static_cast<GLuint>(i));
      (*program)->set(layout::mixWeightsLocation + static_cast<GLint>(i), parts[i].second);
    }
    glBindImageTexture(0, layer.array, layer.level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    dispatchFaces(layer.size, faces);
    return {};
  };
  addByFaces(steps, "LD layers", layer.size, parts.size(), run);
}

void addMixtures(std::vector<Step>& steps, const std::vector<LayerTarget>& wanted, const ScratchPointer& scratch,
                 ProgramStore& programs, const Method& method) {
  std::vector<bool> used(mixturePartCount, false);
  for (const LayerTarget& layer : wanted)
    for (const auto& [part, weight] : mixtureOf(layer)) used[part] = true;
  const std::vector<optics::BlurredCopy> copies = optics::blurredCopies();
  assert(copies.size() == blurredCopyCount);
  scratch->blurred.resize(copies.size());
  size_t last = copies.size() - 1;
  while (last > 0 && !used[last]) --last;
  size_t& planned = scratch->lastBlurPlanned;
  for (; planned < last; ++planned) addBlur(steps, planned + 1, copies[planned + 1], scratch, programs);
  for (size_t i = 0; i < std::size(scratch->summed); ++i)
    if (used[blurredCopyCount + i] && !scratch->sumPlanned[i]) addSum(steps, "LD layers", i, scratch, programs, method);
  for (const LayerTarget& layer : wanted) addMixture(steps, layer, scratch, programs);
}

// ---- Samples of the lobe --------------------------------------------------------------------------------------------

// Unfiltered: H by the normals' distribution on Hammersley points, weight NoL, as is usual.
std::vector<glm::vec4> importanceSamples(double alpha, int count) {
  std::vector<glm::vec4> samples;
  for (int i = 0; i < count; ++i) {
    const glm::dvec2 u = optics::hammersley(static_cast<uint32_t>(i), static_cast<uint32_t>(count));
    const double cosine = std::sqrt((1 - u.y) / (1 + (alpha * alpha - 1) * u.y));
    const double NoL = 2 * cosine * cosine - 1;
    if (NoL <= 0) continue;
    const double sine = std::sqrt(std::max(0.0, 1 - NoL * NoL)), phi = 2 * pi * u.x;
    samples.emplace_back(glm::vec3(glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), NoL) * NoL), 0.0f);
  }
  return samples;
}

std::vector<glm::vec4> layerSamples(double alpha, const gl::Texture& cube, const Method& method) {
  if (alpha == 0) return {glm::vec4(0, 0, 1, 0)};
  if (method.ld == LdMethod::importance) return importanceSamples(alpha, method.samples);
  std::vector<glm::vec4> samples;
  const double wider = 0.5 * std::log2(method.filterGain);
  for (const KernelSample& s : kernelSamples(alpha, method.samples, cube.description().width))
    samples.emplace_back(glm::vec3(s.direction), static_cast<float>(std::max(0.0, s.level + wider)));
  return samples;
}

void addSampled(std::vector<Step>& steps, const LayerTarget& layer, const ScratchPointer& scratch,
                ProgramStore& programs, const Method& method) {
  const double alpha = layer.perceptualRoughness * layer.perceptualRoughness;
  const auto run = [=, &programs](int face, int faces) -> Result<void> {
    const auto program = programs.compute("passes/prefilter.comp.glsl");
    if (!program) return tl::unexpected(program.error());
    const gl::Buffer input = gl::Buffer::of(layerSamples(alpha, scratch->environmentCube(), method), "LD samples");
    glUseProgram((*program)->id());
    (*program)->set(layout::layerCubeLocation, layer.cube);
    (*program)->set(layout::layerFirstFaceLocation, face);
    scratch->environmentCube().bind(layout::sourceUnit);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, input.id());
    glBindImageTexture(0, layer.array, layer.level, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    dispatchFaces(layer.size, faces);
    return {};
  };
  addByFaces(steps, "LD layers", layer.size, alpha == 0 ? 1 : static_cast<uint64_t>(method.samples), run);
}

// ---- Cuts
// ------------------------------------------------------------------------------------------------------------

constexpr int cutRows = 32;  // of a face, in one step

void addCut(std::vector<Step>& steps, const LayerTarget& layer, const ScratchPointer& scratch, ProgramStore& programs,
            const Method& method) {
  const double alpha = layer.perceptualRoughness * layer.perceptualRoughness;
  const CutParameters parameters{method.cutTolerance, method.cutAcross, method.cutByG2};
  for (int face = 0; face < 6; ++face)
    for (int row = 0; row < layer.size; row += cutRows) {
      const CutTarget target{
          layer.array, layer.cube, layer.level, layer.size, face, row, std::min(cutRows, layer.size)};
      steps.push_back({"LD layers", 0, [=, &programs] {
                         return drawCut(target, alpha, scratch->tree, scratch->environmentCube(), programs, parameters);
                       }});
    }
}

void addCuts(std::vector<Step>& steps, const std::vector<LayerTarget>& wanted, const ScratchPointer& scratch,
             ProgramStore& programs, const Method& method) {
  steps.push_back({"LD layers", texels(mirrorSize) * 4 / 3, [=, &programs]() -> Result<void> {
                     Result<CutTree> tree = buildCutTree(scratch->environmentCube(), programs);
                     if (!tree) return tl::unexpected(tree.error());
                     scratch->tree = std::move(*tree);
                     return {};
                   }});
  for (const LayerTarget& layer : wanted)
    if (layer.perceptualRoughness == 0)
      addSampled(steps, layer, scratch, programs, method);
    else
      addCut(steps, layer, scratch, programs, method);
  steps.push_back({"LD layers", 0, [=]() -> Result<void> {
                     scratch->counted += scratch->tree.readVisits();
                     scratch->tree = {};
                     return {};
                   }});
}

// ---- Irradiance -----------------------------------------------------------------------------------------------------

constexpr double riemannStep = 0.025;  // rad

void addRiemann(std::vector<Step>& steps, const ScratchPointer& scratch, ProgramStore& programs, const Method& method) {
  const int size = method.irradianceSize;
  const auto fetches = static_cast<uint64_t>(std::ceil(2 * pi / riemannStep) * std::ceil(0.5 * pi / riemannStep));
  const auto run = [=, &programs]() -> Result<void> {
    const auto program = programs.compute("passes/irradiance_riemann.comp.glsl");
    if (!program) return tl::unexpected(program.error());
    gl::Texture& result = scratch->summed[1];
    result = cubeTexture(GL_RGBA32F, size, 1, "irradiance / pi");
    glUseProgram((*program)->id());
    (*program)->set(layout::riemannStepLocation, static_cast<float>(riemannStep));
    scratch->environmentCube().bind(layout::sourceUnit);
    glBindImageTexture(0, result.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
    dispatchFaces(size);
    return {};
  };
  steps.push_back({"irradiance", texels(size) * fetches, run});
}

void addHarmonics(std::vector<Step>& steps, const ScratchPointer& scratch, const Method& method) {
  const auto run = [=]() -> Result<void> {
    scratch->summed[1] =
        irradianceByHarmonics(scratch->environmentCube(), method.harmonicsOrder, method.irradianceSize);
    return {};
  };
  steps.push_back({"irradiance", texels(harmonicsSource), run});
}

}  // namespace

void addLayerSteps(std::vector<Step>& steps, const std::vector<LayerTarget>& wanted, const ScratchPointer& scratch,
                   ProgramStore& programs, const Method& method) {
  if (method.ld == LdMethod::mixture) return addMixtures(steps, wanted, scratch, programs, method);
  if (method.ld == LdMethod::cut) return addCuts(steps, wanted, scratch, programs, method);
  for (const LayerTarget& layer : wanted) addSampled(steps, layer, scratch, programs, method);
}

void addIrradianceSteps(std::vector<Step>& steps, const ScratchPointer& scratch, ProgramStore& programs,
                        const Method& method) {
  switch (method.irradiance) {
    case IrradianceMethod::summed:
      return addSum(steps, "irradiance", 1, scratch, programs, method);
    case IrradianceMethod::riemann:
      return addRiemann(steps, scratch, programs, method);
    case IrradianceMethod::harmonics:
      return addHarmonics(steps, scratch, method);
  }
}

}  // namespace facet::ibl
