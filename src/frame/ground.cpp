#include "frame/ground.hpp"

#include <algorithm>
#include <cmath>

#include "frame/choose.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

constexpr int pathsAtOnce = 1 << 15;  // rows of the largest grid are fewer

Result<const gl::Program*> shareProgram(ProgramStore& programs) {
  return programs.compute("passes/ground_share.comp.glsl");
}
// Whether what is behind the floor is known when it is drawn.
bool covers(const FrameInput& in) { return in.settings.frame.background != Background::environment; }
Result<const gl::Program*> drawProgram(const FrameInput& in, ProgramStore& programs) {
  return programs.render("passes/ground.vert.glsl", "passes/ground.frag.glsl",
                         covers(in) ? std::vector<shading::Define>{{"COVER"}} : std::vector<shading::Define>{});
}

gl::Texture layers(int size, int count, const char* label) {
  gl::Texture texture(
      {.target = GL_TEXTURE_2D_ARRAY, .format = GL_RGBA32F, .width = size, .height = size, .layers = count}, label);
  texture.filterLinear();
  return texture;
}

void begin(Ground& ground, const GroundWish& wish) {
  const bool same = ground.shares && ground.wish.size == wish.size;
  ground.wish = wish, ground.done = ground.row = 0;
  ground.sums = layers(wish.size, layout::groundSumLayers, "light on the floor");
  const glm::vec4 zero(0);
  glClearTexImage(ground.sums.id(), 0, GL_RGBA, GL_FLOAT, &zero.x);
  if (!same) ground.shares = {};
}

Result<void> makeShares(Ground& ground, ProgramStore& programs) {
  const auto program = shareProgram(programs);
  if (!program) return tl::unexpected(program.error());
  if (!ground.shares) ground.shares = layers(ground.wish.size, layout::groundLayers, "floor");
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  ground.sums.bind(0);
  glBindSampler(0, 0);
  glBindImageTexture(0, ground.shares.id(), 0, GL_TRUE, 0, GL_WRITE_ONLY, GL_RGBA32F);
  constexpr float noise = 0.8f;  // of a share by one sample
  const auto done = static_cast<float>(ground.done);
  (*program)->set(layout::groundNoiseLocation,
                  glm::vec4(noise / std::sqrt(done), static_cast<float>(ground.wish.samples) / done, 0, 0));
  glUseProgram((*program)->id());
  const auto groups = static_cast<GLuint>(layout::groupsFor(ground.wish.size));
  glDispatchCompute(groups, groups, 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  return {};
}

}  // namespace

GroundWish groundWish(const PictureSettings& settings) {
  const int samples = settings.quality.maxError ? correctedUpTo + 1 : settings.quality.samples;
  const int size = samples <= correctedUpTo ? 256 : samples <= 256 ? 512 : 1024;
  return {size, 16, settings.quality.seed, settings.frame.environmentRotationDeg, settings.frame.environmentStrength};
}

Ground placedGround(const DrawList& list, const scene::Bounds& bounds) {
  Ground ground;
  if (bounds.empty()) return ground;
  const glm::dvec3 size = bounds.max - bounds.min;
  const double width = std::max(0.5 * std::hypot(size.x, size.z) + 1.5 * size.y, 1e-30);
  const glm::dvec3 center = bounds.center() - list.origin;
  constexpr double below = 1e-4;  // of what stands on it; what lies on it is not in its place
  const double y = bounds.min.y - list.origin.y - below * bounds.radius();
  ground.place = glm::vec4(glm::dvec4(center.x, y, center.z, width));
  return ground;
}

bool groundComplete(const Ground* ground, const PictureSettings& settings) {
  return !ground || (ground->complete() && ground->wish == groundWish(settings));
}

Result<bool> continueGround(const FrameInput& in, Ground& ground, ProgramStore& programs, const KeepGoing& keepGoing) {
  const GroundWish wish = groundWish(in.settings);
  if (ground.wish != wish) begin(ground, wish);
  if (ground.complete()) return true;
  FrameInput paths = tracedInput(in);
  paths.ground = &ground, paths.firstRow = 0;
  const int shown = ground.done;
  do {
    PathRows rows{ground.row, std::min(wish.size - ground.row, pathsAtOnce / wish.size), PathUse::ground};
    rows.columns = wish.size, rows.share = 1.0f / static_cast<float>(wish.samples);
    glBindImageTexture(0, ground.sums.id(), 0, GL_TRUE, 0, GL_READ_WRITE, GL_RGBA32F);
    if (Result<void> r = tracePaths(paths, rows, ground.work, ground.done, programs); !r)
      return tl::unexpected(r.error());
    ground.row += rows.count;
    if (ground.row == wish.size) ground.row = 0, ++ground.done;
  } while (!ground.complete() && (!keepGoing || keepGoing()));
  if (ground.done != shown && (ground.complete() || (ground.done & (ground.done - 1)) == 0))
    if (Result<void> r = makeShares(ground, programs); !r) return tl::unexpected(r.error());
  if (!ground.complete()) return false;
  ground.rays = tracedRays(ground.work);
  ground.sums = {}, ground.work = {};
  return true;
}

Result<void> drawGround(const FrameInput& in, ProgramStore& programs, FrameStatistics& statistics) {
  if (!in.ground || !in.ground->shares) return {};
  const auto program = drawProgram(in, programs);
  if (!program) return tl::unexpected(program.error());
  beginPass(in, statistics, "ground");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glFrontFace(GL_CCW);
  glEnable(GL_BLEND);
  if (covers(in))
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  else
    glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  in.ground->shares.bind(layout::groundUnit);
  glUseProgram((*program)->id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  return {};
}

std::vector<ProgramGetter> neededGroundPrograms(const FrameInput& in, ProgramStore& programs) {
  std::vector<ProgramGetter> out = neededPathPrograms(tracedInput(in), PathUse::ground, programs);
  out.emplace_back([&programs] { return shareProgram(programs); });
  if (!in.list.features.paths) out.emplace_back([&in, &programs] { return drawProgram(in, programs); });
  return out;
}

}  // namespace facet::frame
