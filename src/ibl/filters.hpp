#pragma once

// The environment cube -> what is read for rough surfaces: layers of LD and irradiance, by each method, as steps of
// bounded work.

#include <functional>
#include <memory>
#include <vector>

#include "base/error.hpp"
#include "gl/texture.hpp"
#include "ibl/cut.hpp"
#include "ibl/method.hpp"
#include "ibl/source.hpp"
#include "optics/zonal.hpp"
#include "shading/programs.hpp"

namespace facet::ibl {

// A bounded piece of GPU work.
struct Step {
  const char* table = "";  // that it is for
  uint64_t fetches = 0;    // texture and list reads
  std::function<Result<void>()> run;
};

// What steps leave for later ones; they keep it alive.
struct Scratch {
  CubeSource source;
  gl::Texture cube;                                     // RGBA32F with levels; alpha of level 0 on: solid angle
  const gl::Texture* presentCube = nullptr;             // in its place where there is one already
  std::vector<gl::Texture> blurred;                     // optics::blurredCopies; [0] stays empty: the cube itself
  size_t lastBlurPlanned = 0;                           // of these
  gl::Texture summed[std::size(optics::summedAlphas)];  // RGBA32F cubes; the last is irradiance / pi
  bool sumPlanned[std::size(optics::summedAlphas)] = {};
  CutTree tree;
  uint64_t counted = 0;  // fetches whose number only the steps found

  const gl::Texture& environmentCube() const { return presentCube ? *presentCube : cube; }
};

// A level of one cube of a cube map array, RGBA16F.
struct LayerTarget {
  GLuint array = 0;
  int cube = 0, level = 0, size = 0;
  double perceptualRoughness = 0;
  std::vector<double> mixture = {};  // of the copies and sums; empty: the layer's of that roughness
};

// Steps that make these layers from the environment's cube, which is made by then.
void addLayerSteps(std::vector<Step>& steps, const std::vector<LayerTarget>& layers,
                   const std::shared_ptr<Scratch>& scratch, shading::ProgramStore& programs, const Method& method);

// Steps that leave irradiance / pi as the last of scratch->summed.
void addIrradianceSteps(std::vector<Step>& steps, const std::shared_ptr<Scratch>& scratch,
                        shading::ProgramStore& programs, const Method& method);

}  // namespace facet::ibl
