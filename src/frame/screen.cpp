#include "frame/screen.hpp"

#include <algorithm>
#include <iterator>

#include "frame/depth_pass.hpp"
#include "frame/display_pass.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

constexpr int largestEdge = 2048;    // texels of the horizons
constexpr float reachRadii = 0.25f;  // how far horizons are looked for, in radii of the scene
constexpr float slices = 2, stepsASide = 8;

Result<const gl::Program*> horizonsProgram(ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/horizons.frag.glsl");
}
Result<const gl::Program*> smoothProgram(ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/horizons_smooth.frag.glsl");
}

void prepareTargets(Screen& screen, const FrameSettings& frame) {
  const int larger = std::max(frame.width, frame.height);
  const int divisor = std::max(2, (larger + largestEdge - 1) / largestEdge);
  const int width = (frame.width + divisor - 1) / divisor, height = (frame.height + divisor - 1) / divisor;
  if (screen.width == width && screen.height == height) return;
  screen.width = width, screen.height = height;
  screen.depth = gl::Texture({.format = GL_DEPTH_COMPONENT32F, .width = width, .height = height}, "depth of horizons");
  screen.found = gl::Texture({.format = GL_RG16F, .width = width, .height = height}, "horizons found");
  screen.shares = gl::Texture({.format = GL_RG16F, .width = width, .height = height}, "horizons");
  for (const gl::Texture* texture : {&screen.depth, &screen.found, &screen.shares}) {
    texture->parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    texture->parameter(GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    texture->parameter(GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  screen.depthOnly = gl::Framebuffer("depth of horizons");
  screen.depthOnly.attach(GL_DEPTH_ATTACHMENT, screen.depth);
  screen.finding = gl::Framebuffer("horizons found");
  screen.finding.attach(GL_COLOR_ATTACHMENT0, screen.found);
  screen.smoothing = gl::Framebuffer("horizons");
  screen.smoothing.attach(GL_COLOR_ATTACHMENT0, screen.shares);
}

Result<void> drawHorizons(const FrameInput& in, Screen& screen, ProgramStore& programs, FrameStatistics& statistics) {
  const auto find = horizonsProgram(programs);
  if (!find) return tl::unexpected(find.error());
  const auto smooth = smoothProgram(programs);
  if (!smooth) return tl::unexpected(smooth.error());
  prepareTargets(screen, in.settings.frame);
  beginPass(in, statistics, "horizons");
  FrameInput whole = in;
  whole.firstRow = 0, whole.screen = &screen;
  if (Result<void> r = drawDepth(whole, in.view, screen.depthOnly, {screen.width, screen.height}, DepthOf::frontSides,
                                 programs, statistics);
      !r)
    return r;
  const gl::Buffer frame =
      gl::Buffer::of(std::vector<layout::FrameUniforms>{frameUniforms(whole, 0, 1, glm::dvec2(0))}, "horizons' frame");
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frame.id());
  (*find)->set(layout::horizonReachLocation, glm::vec4(reachRadii, slices, stepsASide, 0));
  drawFullscreen({screen.finding, screen.noAttributes, screen.width, screen.height}, screen.depth, **find);
  drawFullscreen({screen.smoothing, screen.noAttributes, screen.width, screen.height}, screen.found, **smooth);
  endPass(in);
  return {};
}

}  // namespace

size_t Screen::bytes() const {
  size_t sum = 0;
  for (const gl::Texture* texture : {&shadows.depths, &depth, &found, &shares})
    if (*texture) sum += texture->bytes();
  return sum;
}

Result<void> prepareScreen(const FrameInput& in, Screen& screen, ProgramStore& programs, FrameStatistics& statistics) {
  if (in.list.features.shadows)
    if (Result<void> r = drawShadowMaps(in, screen.shadows, programs, statistics); !r) return r;
  if (in.list.features.horizons)
    if (Result<void> r = drawHorizons(in, screen, programs, statistics); !r) return r;
  return {};
}

void bindScreen(const FrameInput& in) {
  if (!in.screen) return;
  if (in.screen->shares) in.screen->shares.bind(layout::horizonsUnit);
  if (!in.screen->shadows.depths) return;
  in.screen->shadows.depths.bind(layout::shadowMapsUnit);
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::shadowsBinding, in.screen->shadows.uniforms.id());
}

std::vector<ProgramGetter> neededScreenPrograms(const FrameInput& in, ProgramStore& programs) {
  std::vector<ProgramGetter> needed;
  if (!in.list.features.shadows && !in.list.features.horizons) return needed;
  needed = neededDepthPrograms(in, programs);
  if (!in.list.features.horizons) return needed;
  needed.emplace_back([&programs] { return horizonsProgram(programs); });
  needed.emplace_back([&programs] { return smoothProgram(programs); });
  return needed;
}

}  // namespace facet::frame
