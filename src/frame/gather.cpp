#include "frame/gather.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "frame/difference.hpp"
#include "frame/display_pass.hpp"
#include "frame/pass_clock.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"
#include "optics/sobol.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

Result<const gl::Program*> gatherProgram(ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/gather.frag.glsl");
}
Result<const gl::Program*> errorProgram(ProgramStore& programs) {
  return programs.compute("passes/picture_error.comp.glsl");
}
Result<const gl::Program*> contrastProgram(ProgramStore& programs) {
  return programs.compute("passes/contrast_add.comp.glsl");
}

// What lies in the rows that the targets hold.
VisibleDraws visibleRows(const FrameInput& in, const Targets& targets) {
  const auto clip = [&](int row) { return 2.0 * row / in.settings.frame.height - 1; };
  constexpr double marginPixels = 2;  // offsets within the pixel; lines and points are one pixel wide
  return visibleDraws(in.list, in.view, {clip(in.firstRow), clip(in.firstRow + targets.height)},
                      2 * marginPixels / std::min(in.settings.frame.width, in.settings.frame.height));
}

// Adds targets.color / draws to a sum.
Result<void> addToSum(const Targets& targets, const gl::Framebuffer& sum, const Gathering& gathering,
                      ProgramStore& programs) {
  const auto program = gatherProgram(programs);
  if (!program) return tl::unexpected(program.error());
  (*program)->set(layout::gatherShareLocation, 1.0f / static_cast<float>(gathering.draws()));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  drawFullscreen({sum, targets.noAttributes, targets.width, targets.height}, targets.color, **program);
  glDisable(GL_BLEND);
  return {};
}

// One draw of the scene, or of its band of rows, into the sum where there is one.
Result<FrameStatistics> drawOnce(const FrameInput& in, const Targets& targets, const Gathering& gathering,
                                 const gl::Framebuffer& sum, ProgramStore& programs) {
  const auto index = static_cast<size_t>(gathering.done);
  Result<FrameStatistics> drawn =
      drawScene(in, gathering.visible, targets, gathering.done, gathering.draws(), gathering.offsets[index], programs);
  if (!drawn || !targets.sum) return drawn;
  if (in.clock) in.clock->begin("gather");
  if (Result<void> added = addToSum(targets, sum, gathering, programs); !added) return tl::unexpected(added.error());
  endPass(in);
  return drawn;
}

// The same of the fitted model, before the measured BRDF's, which stays in targets.color.
Result<void> drawFitted(const FrameInput& in, const Targets& targets, const Gathering& gathering,
                        ProgramStore& programs) {
  FrameInput fitted = in;
  fitted.fitted = true;
  const auto drawn = drawOnce(fitted, targets, gathering, targets.fittedGathered, programs);
  if (!drawn) return tl::unexpected(drawn.error());
  if (!targets.sum)
    glCopyImageSubData(targets.color.id(), GL_TEXTURE_2D, 0, 0, 0, 0, targets.fitted.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                       targets.width, targets.height, 1);
  return {};
}

}  // namespace

// Offsets within the pixel: Owen-scrambled Sobol points, shifted so that their mean is the pixel's centre. All pixels
// share them, as one draw has one camera; the scrambling makes halves of them disagree as much as their errors are
// large, which the points of a lattice do not.
std::vector<glm::dvec2> jitter(int count, int seed) {
  constexpr uint32_t jitterUse = 0x6a697474;
  const uint32_t sequence = optics::pixelSeed({0, 0}, jitterUse ^ static_cast<uint32_t>(seed));
  std::vector<glm::dvec2> offsets;
  glm::dvec2 mean(0);
  for (int i = 0; i < count; ++i) {
    offsets.push_back(optics::owenSobol2(static_cast<uint32_t>(i), 0, sequence));
    mean += offsets.back() / static_cast<double>(count);
  }
  for (glm::dvec2& offset : offsets) offset -= mean;
  return offsets;
}

float meanScale(const Gathering& gathering) {
  return static_cast<float>(gathering.draws()) / static_cast<float>(gathering.done);
}

int gatheredDraws(const PictureSettings& settings, const Targets& targets) {
  return targets.sum ? settings.quality.samples : 1;
}

Gathering beginGathering(const FrameInput& in, const Targets& targets) {
  Gathering gathering;
  gathering.offsets = jitter(gatheredDraws(in.settings, targets), in.settings.quality.seed);
  gathering.visible = visibleRows(in, targets);
  gathering.visibleBuffer = gl::Buffer::of(gathering.visible.instances, "visible instances");
  const glm::vec4 zero(0);
  if (targets.sum) glClearNamedFramebufferfv(targets.gathered.id(), GL_COLOR, 0, &zero.x);
  if (targets.sum && targets.fitted) glClearNamedFramebufferfv(targets.fittedGathered.id(), GL_COLOR, 0, &zero.x);
  return gathering;
}

namespace {

Result<void> gatherPaths(const FrameInput& in, const Targets& targets, Gathering& gathering, int64_t rows,
                         ProgramStore& programs) {
  if (gathering.statistics.passes.empty()) {
    gathering.statistics.passes.emplace_back("paths");
    if (comparing(in)) gathering.statistics.passes.emplace_back("all again, of the fitted model");
  }
  const float share = 1.0f / static_cast<float>(gathering.draws());
  while (rows > 0 && !gathering.complete()) {
    const int band = static_cast<int>(std::min<int64_t>(rows, targets.height - gathering.rows));
    FrameInput fitted = in;
    fitted.fitted = true;
    if (in.clock) in.clock->begin("paths");
    Result<void> traced;
    if (comparing(in))
      traced = tracePaths(fitted, {gathering.rows, band, PathUse::picture, &targets.fitted, share}, gathering.paths,
                          gathering.done, programs);
    if (traced)
      traced = tracePaths(in, {gathering.rows, band, PathUse::picture, &targets.sum, share}, gathering.paths,
                          gathering.done, programs);
    endPass(in);
    if (!traced) return traced;
    rows -= band;
    gathering.rows += band;
    if (gathering.rows == targets.height) gathering.rows = 0, ++gathering.done;
  }
  return {};
}

}  // namespace

Result<void> gatherRows(const FrameInput& in, const Targets& targets, Gathering& gathering, int64_t rows,
                        ProgramStore& programs) {
  if (in.list.features.paths) return gatherPaths(in, targets, gathering, rows, programs);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::visibleBinding, gathering.visibleBuffer.id());
  while (rows > 0 && !gathering.complete()) {
    const bool whole = !in.list.transmitting.empty() || (!targets.sum && comparing(in));
    const int left = targets.height - gathering.rows;
    const int band = whole ? left : static_cast<int>(std::min<int64_t>(rows, left));
    if (band < targets.height) {
      glEnable(GL_SCISSOR_TEST);
      glScissor(0, gathering.rows, targets.width, band);
    }
    Result<void> fitted;
    if (comparing(in)) fitted = drawFitted(in, targets, gathering, programs);
    Result<FrameStatistics> drawn;
    if (fitted) drawn = drawOnce(in, targets, gathering, targets.gathered, programs);
    glDisable(GL_SCISSOR_TEST);
    if (!fitted) return fitted;
    if (!drawn) return tl::unexpected(drawn.error());
    if (gathering.done == 0 && gathering.rows == 0) {
      gathering.statistics = std::move(*drawn), gathering.statistics.culled = gathering.visible.culled;
      if (comparing(in)) gathering.statistics.passes.emplace_back("all again, of the fitted model");
    }
    rows -= band;
    gathering.rows += band;
    if (gathering.rows == targets.height) gathering.rows = 0, ++gathering.done;
  }
  return {};
}

Result<void> drawDisplay(const FrameInput& in, const Targets& targets, const Gathering& gathering, const Targets& shown,
                         ProgramStore& programs) {
  assert(gathering.done > 0 && gathering.rows == 0);
  return showPicture(in, targets, meanScale(gathering), shown, programs);
}

bool isContrast(int done, int draws) { return 2 * done >= draws; }

int nextEstimate(int done, int draws) { return 3 * done > draws ? draws : 2 * done; }

void markBefore(const Targets& targets, Gathering& gathering) {
  assert(gathering.rows == 0);
  glMemoryBarrier(GL_TEXTURE_UPDATE_BARRIER_BIT);
  glCopyImageSubData(targets.sum.id(), GL_TEXTURE_2D, 0, 0, 0, 0, targets.before.id(), GL_TEXTURE_2D, 0, 0, 0, 0,
                     targets.width, targets.height, 1);
  gathering.before = gathering.done;
}

Result<ErrorSums> sumErrors(const FrameInput& in, const Targets& targets, const Gathering& gathering,
                            const Targets& shown, ProgramStore& programs) {
  assert(targets.before && gathering.done > gathering.before && gathering.before > 0 && gathering.rows == 0);
  const auto program = errorProgram(programs);
  if (!program) return tl::unexpected(program.error());
  const DisplayParameters display = displayParameters(in, meanScale(gathering));
  (*program)->set(layout::displayParametersLocation, display.parameters);
  (*program)->set(layout::displayBackdropLocation, display.backdrop);
  const double before = gathering.before, after = gathering.done - gathering.before, all = gathering.done;
  const int height = std::min(targets.height, in.settings.frame.height - in.firstRow);  // of the picture
  (*program)->set(layout::errorPartsLocation, glm::vec4(all / before, all / after, height, 0));
  const int columns = layout::groupsFor(targets.width, layout::sumTileSize),
            rows = layout::groupsFor(height, layout::sumTileSize);
  ErrorSums out;
  out.tiles = static_cast<size_t>(columns) * static_cast<size_t>(rows);
  out.values = static_cast<size_t>(targets.width) * static_cast<size_t>(height) * 3;
  out.before = gathering.before, out.after = gathering.done - gathering.before;
  out.sums = gl::Buffer(out.tiles * sizeof(glm::vec4), "errors");
  glBindImageTexture(0, targets.sum.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(1, targets.before.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(2, shown.display.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA8);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.sums.id());
  glUseProgram((*program)->id());
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glDispatchCompute(static_cast<GLuint>(columns), static_cast<GLuint>(rows), 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  return out;
}

Result<void> addContrast(const Targets& targets, const Gathering& gathering, ProgramStore& programs) {
  const auto program = contrastProgram(programs);
  if (!program) return tl::unexpected(program.error());
  const double draws = gathering.draws(), before = gathering.before, after = gathering.done - gathering.before;
  (*program)->set(layout::errorPartsLocation,
                  glm::vec4(draws / before, draws / after, before * after / (before + after), 0));
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  glBindImageTexture(0, targets.sum.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(1, targets.before.id(), 0, GL_FALSE, 0, GL_READ_ONLY, GL_RGBA32F);
  glBindImageTexture(2, targets.contrasts.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  glUseProgram((*program)->id());
  glDispatchCompute(static_cast<GLuint>(layout::groupsFor(targets.width, layout::groupSize)),
                    static_cast<GLuint>(layout::groupsFor(targets.height, layout::groupSize)), 1);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT);
  return {};
}

PictureErrors readErrors(const ErrorSums& sums) {
  glm::dvec4 whole(0);
  for (const glm::vec4& tile : sums.sums.read<glm::vec4>(sums.tiles)) whole += tile;
  const double values = static_cast<double>(sums.values);
  return {{sums.before, sums.after, whole.x, whole.z, values}, 255 * std::sqrt(whole.y / values)};
}

Result<void> prepareGatherPrograms(ProgramStore& programs) {
  if (const auto program = gatherProgram(programs); !program) return tl::unexpected(program.error());
  if (const auto program = errorProgram(programs); !program) return tl::unexpected(program.error());
  return {};
}

namespace {

// The difference of the draws before the mark and those after it, waited for.
Result<PartDifference> partDifference(const FrameInput& in, const Targets& targets, const Gathering& gathering,
                                      ProgramStore& programs) {
  const Result<ErrorSums> sums = sumErrors(in, targets, gathering, targets, programs);
  if (!sums) return tl::unexpected(sums.error());
  return readErrors(*sums).parts;
}

}  // namespace

Result<FrameStatistics> drawFrame(const FrameInput& in, const Targets& targets, ProgramStore& programs) {
  Gathering gathering = beginGathering(in, targets);
  std::vector<PartDifference> parts;
  const glm::vec4 zero(0);
  if (targets.contrasts) glClearTexImage(targets.contrasts.id(), 0, GL_RGBA, GL_FLOAT, &zero.x);
  // Where the error is wanted, the last estimates are made as a resting window makes them.
  for (int until = targets.before ? 1 : gathering.draws(); !gathering.complete();
       until = nextEstimate(gathering.done, gathering.draws())) {
    if (targets.before && gathering.done > 0) markBefore(targets, gathering);
    const int64_t rows = static_cast<int64_t>(until - gathering.done) * targets.height;
    if (Result<void> drawn = gatherRows(in, targets, gathering, rows, programs); !drawn)
      return tl::unexpected(drawn.error());
    if (!targets.before || gathering.before == 0) continue;
    const Result<PartDifference> part = partDifference(in, targets, gathering, programs);
    if (!part) return tl::unexpected(part.error());
    parts.push_back(*part);
    if (!targets.contrasts || !isContrast(gathering.done, gathering.draws())) continue;
    if (Result<void> added = addContrast(targets, gathering, programs); !added) return tl::unexpected(added.error());
  }
  FrameStatistics& statistics = gathering.statistics;
  if (targets.sum) statistics.passes.push_back("gather x " + std::to_string(gathering.draws()));
  statistics.rays = tracedRays(gathering.paths);
  statistics.parts = std::move(parts);
  if (in.difference) {
    beginPass(in, statistics, "add difference");
    if (Result<void> added = addDifference(in, targets, *in.difference, programs); !added)
      return tl::unexpected(added.error());
  }
  beginPass(in, statistics, "display");
  if (Result<void> result = drawDisplay(in, targets, gathering, targets, programs); !result)
    return tl::unexpected(result.error());
  endPass(in);
  return statistics;
}

}  // namespace facet::frame
