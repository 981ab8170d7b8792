#pragma once

// One frame: draw list + tables + view -> scene-linear picture -> display picture. A list of passes over plain structs.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "frame/draw_list.hpp"
#include "frame/gpu_scene.hpp"
#include "frame/settings_fwd.hpp"
#include "frame/statistics.hpp"
#include "gl/buffer.hpp"
#include "gl/texture.hpp"
#include "gl/vertex_array.hpp"
#include "ibl/tables.hpp"
#include "io/radiance.hpp"
#include "scene/camera.hpp"
#include "shading/programs.hpp"

namespace facet::frame {

// A copy of what is drawn before the transmitting surfaces. Level k + 1 is level k filtered by [1 3 3 1] / 8 along each
// axis and halved: its texel i covers pixels [i, i + 1) 2^k.
struct Behind {
  gl::Texture color;  // as Targets::color
  gl::Texture depth;  // R32F as in the depth buffer: its mean is the mean of 1 / distance (perspective)
};

// What covers each pixel of surfaces that are blended (shaders/blend_lists.glsl).
struct BlendLists {
  gl::Buffer heads, nodes;
  uint32_t capacity = 0;  // nodes that there is room for
};

// Where a frame is drawn. Either one draw with several coverage samples a pixel, each pixel shaded once, or many draws
// with one sample each, jittered within the pixel and gathered.
struct Targets {
  int width = 0, height = 0;
  int samples = 1;          // of the multisample targets
  gl::Texture multisample;  // as color, only where samples > 1
  gl::Texture depth;        // 32F, reversed: 1 near, 0 far
  gl::Texture color;        // RGBA16F, RGBA32F where precise; scene-linear, associated alpha
  gl::Texture sum;          // RGBA32F, only while several draws are gathered
  gl::Texture before;       // RGBA32F, the sum as it was; only where the error is wanted
  gl::Texture contrasts;  // RGBA32F, of parts of the draws; only where each pixel's own error is wanted, with `before`
  gl::Texture fitted;     // as sum, else as color, of the fitted model; only where it is compared
  gl::Texture display;    // RGBA8, sRGB-encoded, straight alpha
  Behind behind;          // only for scenes with transmitting surfaces
  std::unique_ptr<BlendLists> lists;  // grow while they are filled; only where they are wanted
  gl::Framebuffer drawn, resolved, gathered, fittedGathered, shown;
  gl::VertexArray noAttributes;  // core profile draws nothing without a vertex array, full-screen passes too
};
// precise: in single precision from the first sample, for who reads radiance. Halves, which hold 11 bits and which
// drivers round towards zero, are enough for what is shown.
Targets createTargets(int width, int height, int samples, bool gather, bool precise = false);
// For gathering a picture that is shown in others' display picture: with what its error is estimated from.
Targets createGatherTargets(int width, int height);
// For values of a debug channel in single precision, to be read (format GL_RGBA32F), or for a mask (GL_RGBA8).
Targets createValueTargets(int width, int height, GLenum format);
// Adds the copy of what is behind where the list has transmitting surfaces and the targets have none yet; frees it
// where the list has none.
void prepareBehind(Targets& targets, const DrawList& list);
// Likewise for the fitted model's picture, where the list is compared.
void prepareComparison(Targets& targets, const DrawList& list);
size_t targetBytes(const Targets& targets);  // of the textures

struct PathScene;
struct Difference;
struct Ground;
struct Screen;
class PassClock;

struct FrameInput {
  const scene::Model& model;
  const DrawList& list;
  const GpuScene& gpu;
  const ibl::Tables& tables;
  const scene::View& view;
  const PictureSettings& settings;
  const gl::Buffer* measured = nullptr;     // of the measured BRDF in the materials' place
  const gl::Buffer* fittedModel = nullptr;  // of the model fitted to it, where it is drawn in its place or beside it
  const PathScene* paths = nullptr;         // of the list, where paths are traced
  const Difference* difference = nullptr;   // what is added to the picture, where rays correct it
  const Ground* ground = nullptr;           // the floor, where there is one
  const Screen* screen = nullptr;           // what it knows of what stands in the light's way, where that is wanted
  PassClock* clock = nullptr;               // measures the passes, where that is wanted
  int firstRow = 0;                         // the targets hold the picture's rows from here on, counted from the bottom
  bool fitted = false;                      // draws the fitted model in the measured BRDF's place
  bool precise = false;                     // as createTargets has it
};

// Tells a pass, and measures it until the next one or endPass().
void beginPass(const FrameInput& in, FrameStatistics& statistics, std::string pass);
void endPass(const FrameInput& in);

// One program, compiled where it is not there yet.
using ProgramGetter = std::function<Result<const gl::Program*>()>;

// Binds the tables that are there to the units of their names.
void bindTables(const ibl::Tables& tables);

// How many draws a picture gathers: one, or one for each sample.
int gatheredDraws(const PictureSettings& settings, const Targets& targets);

// Compiles what the draw list needs and is not there yet. Errors: a shader does not compile (a driver's or a user's
// file).
Result<void> preparePrograms(const FrameInput& in, shading::ProgramStore& programs);

// Compiles one of them at most. True where none was missing.
Result<bool> prepareNextProgram(const FrameInput& in, shading::ProgramStore& programs);

// Draws settings.quality.samples samples a pixel into targets.color (or targets.sum) and the display picture into
// targets.display. All programs are ready (preparePrograms). Estimates the error where the targets have a `before`.
Result<FrameStatistics> drawFrame(const FrameInput& in, const Targets& targets, shading::ProgramStore& programs);

// Scene-linear, associated alpha; unit: radianceUnit of what was drawn. Waits for the GPU.
io::RadianceImage readRadiance(const Targets& targets, float unit = 1);
// The same of the fitted model, where it is compared.
// The standard error of each pixel's radiance, of so many draws. It takes draws for independent: where they are evener
// it is too much.
io::RadianceImage readStandardError(const Targets& targets, int draws, float unit);
io::RadianceImage readFitted(const Targets& targets, float unit = 1);
// 8-bit sRGB; RGB where the background covers everything, RGBA else.
io::Pixels readDisplay(const Targets& targets, bool withAlpha);

}  // namespace facet::frame
