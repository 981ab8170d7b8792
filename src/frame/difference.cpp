#include "frame/difference.hpp"

#include <algorithm>
#include <cmath>

#include "frame/gather.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

// Rows that are traced at once, and those beside them that smoothing looks at.
constexpr int64_t mostPixels = int64_t{1} << 19;
constexpr int margin = 16;

Result<const gl::Program*> filterProgram(const char* step, ProgramStore& programs) {
  return programs.compute("passes/difference_filter.comp.glsl", {{"STEP", step}});
}
Result<const gl::Program*> addProgram(ProgramStore& programs) {
  return programs.compute("passes/difference_add.comp.glsl");
}

GLenum imageFormat(const FrameInput& in) { return in.precise ? GL_RGBA32F : GL_RGBA16F; }

// Of some rows of the picture.
struct Sums {
  gl::Texture all, next;  // of imageFormat, arrays: differenceLayers, smoothedLayers
  gl::Texture distance;   // R32F
};

void clear(const gl::Texture& texture) {
  const glm::vec4 zero(0);
  glClearTexImage(texture.id(), 0, GL_RGBA, GL_FLOAT, &zero.x);
}

Sums makeSums(int width, int rows, GLenum format) {
  const auto layers = [&](int count, const char* label) {
    return gl::Texture(
        {.target = GL_TEXTURE_2D_ARRAY, .format = format, .width = width, .height = rows, .layers = count}, label);
  };
  Sums sums;
  sums.all = layers(layout::differenceLayers, "difference");
  sums.next = layers(layout::smoothedLayers, "difference, smoothed");
  sums.distance = gl::Texture({.format = GL_R32F, .width = width, .height = rows}, "first distances");
  clear(sums.all);
  const float zero = 0;
  glClearTexImage(sums.distance.id(), 0, GL_RED, GL_FLOAT, &zero);
  return sums;
}

void dispatch(const gl::Program& program, int width, int rows) {
  glUseProgram(program.id());
  glDispatchCompute(static_cast<GLuint>(layout::groupsFor(width, layout::groupSize)),
                    static_cast<GLuint>(layout::groupsFor(rows, layout::groupSize)), 1);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

void bindLayers(GLuint unit, const gl::Texture& texture, GLenum access) {
  glBindImageTexture(unit, texture.id(), 0, GL_TRUE, 0, access, texture.description().format);
}
void bindImages(const Sums& sums) {
  bindLayers(0, sums.all, GL_READ_WRITE);
  glBindImageTexture(1, sums.distance.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32F);
}

// Steps of twice the width each; fewer where many samples leave little noise.
int smoothingSteps(int samples) { return samples <= 8 ? 4 : samples <= 16 ? 2 : samples <= 64 ? 1 : 0; }
constexpr float sharpReach = 12;        // pixels, of lobes of alpha 1
constexpr int64_t mostPaths = 450'000;  // for each sample of a picture
// Of the share of light that is visible, by one sample; each step leaves half of it.
constexpr float shareNoise = 1.6f;

// What has been smoothed last.
Result<const gl::Texture*> smooth(const Sums& sums, int paths, int width, int rows, ProgramStore& store) {
  const auto step = filterProgram("1", store);
  if (!step) return tl::unexpected(step.error());
  sums.all.bind(1), sums.distance.bind(2);
  const gl::Texture *from = &sums.all, *to = &sums.next;
  const float noise = shareNoise / std::sqrt(static_cast<float>(paths));
  for (int i = 0; i < smoothingSteps(paths); ++i) {
    from->bind(0);
    bindLayers(0, *to, GL_WRITE_ONLY);
    (*step)->set(layout::differenceStepLocation,
                 glm::vec4(1 << i, sharpReach, i == 0 ? 1 : 0, noise / static_cast<float>(1 << i)));
    dispatch(**step, width, rows);
    std::swap(from, to);
  }
  return from;
}

// Pixels of the picture.
struct Region {
  int firstColumn = 0, firstRow = 0, columns = 0, rows = 0;
};

// Where the scene's bounds may be seen.
Region drawnRegion(const FrameInput& in) {
  const int width = in.settings.frame.width, height = in.settings.frame.height;
  const scene::Bounds& box = in.list.bounds;
  glm::dvec2 least(1), most(-1);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 at((corner & 1) != 0 ? box.max.x : box.min.x, (corner & 2) != 0 ? box.max.y : box.min.y,
                        (corner & 4) != 0 ? box.max.z : box.min.z);
    const glm::dvec4 clip = in.view.clipFromWorld * glm::dvec4(at, 1);
    if (!(clip.w > 0)) return {0, 0, width, height};
    least = glm::min(least, glm::dvec2(clip) / clip.w), most = glm::max(most, glm::dvec2(clip) / clip.w);
  }
  constexpr double padding = 2;  // pixels
  const auto pixel = [](double clip, int size, double pad) {
    return static_cast<int>(std::clamp((clip + 1) / 2 * size + pad, 0.0, static_cast<double>(size)));
  };
  Region region{pixel(least.x, width, -padding), pixel(least.y, height, -padding), 0, 0};
  region.columns = pixel(most.x, width, padding) - region.firstColumn;
  region.rows = pixel(most.y, height, padding) - region.firstRow;
  return region;
}

// A band of the region into the picture's difference.
Result<void> traceBand(const FrameInput& in, const Region& all, const Region& band, PathWork& work,
                       const gl::Texture& radiance, ProgramStore& store) {
  const auto putBack = filterProgram("2", store);
  if (!putBack) return tl::unexpected(putBack.error());
  const int samples = in.settings.quality.samples;
  const int paths = pathsOfPixel(samples, int64_t{all.columns} * all.rows);
  FrameInput rows = tracedInput(in);
  rows.firstRow = std::max(all.firstRow, band.firstRow - margin);
  const int count = std::min(all.firstRow + all.rows, band.firstRow + band.rows + margin) - rows.firstRow;
  const Sums sums = makeSums(band.columns, count, imageFormat(in));
  PathRows traced{0, count, PathUse::difference};
  traced.share = 1.0f / static_cast<float>(paths);
  traced.firstColumn = band.firstColumn, traced.columns = band.columns;
  const std::vector<glm::dvec2> offsets = jitter(samples, in.settings.quality.seed);
  for (int number = 0; number < paths; ++number) {
    bindImages(sums);
    traced.offset = offsets[static_cast<size_t>(number)];
    if (Result<void> r = tracePaths(rows, traced, work, number, store); !r) return r;
  }
  const gl::Buffer frame = gl::Buffer::of(std::vector{frameUniforms(rows, 0, 1, glm::dvec2(0))}, "frame");
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frame.id());
  const gl::Buffer common = pathUniformBuffer(rows, band.firstColumn, band.columns);
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::pathsBinding, common.id());
  const Result<const gl::Texture*> smoothed = smooth(sums, paths, band.columns, count, store);
  if (!smoothed) return tl::unexpected(smoothed.error());
  (*smoothed)->bind(0);
  glBindImageTexture(0, radiance.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, imageFormat(in));
  (*putBack)->set(layout::differenceStepLocation, glm::vec4(band.firstRow - rows.firstRow, band.rows, rows.firstRow,
                                                            smoothingSteps(paths) == 0 ? 1 : 0));
  dispatch(**putBack, band.columns, band.rows);
  return {};
}

}  // namespace

int pathsOfPixel(int samples, int64_t pixels) {
  int paths = samples;
  while (paths > 1 && pixels * paths > mostPaths * samples) paths = (paths + 1) / 2;
  return paths;
}

Result<Difference> traceDifference(const FrameInput& in, ProgramStore& store) {
  Difference out;
  out.radiance = gl::Texture(
      {.format = imageFormat(in), .width = in.settings.frame.width, .height = in.settings.frame.height}, "difference");
  clear(out.radiance);
  const Region all = drawnRegion(in);
  if (all.columns <= 0 || all.rows <= 0) return out;
  const int kept = static_cast<int>(std::clamp<int64_t>(mostPixels / all.columns, 2 * margin, all.rows));
  PathWork work;
  for (int row = 0; row < all.rows; row += kept) {
    const Region band{all.firstColumn, all.firstRow + row, all.columns, std::min(kept, all.rows - row)};
    if (Result<void> r = traceBand(in, all, band, work, out.radiance, store); !r) return tl::unexpected(r.error());
  }
  out.rays = tracedRays(work);
  return out;
}

Result<void> addDifference(const FrameInput& in, const Targets& targets, const Difference& difference,
                           ProgramStore& store) {
  const auto program = addProgram(store);
  if (!program) return tl::unexpected(program.error());
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  glBindImageTexture(0, targets.sum.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  difference.radiance.bind(0);
  glBindSampler(0, 0);
  (*program)->set(layout::differenceStepLocation, glm::vec4(in.firstRow, 0, 0, 0));
  dispatch(**program, targets.width, targets.height);
  return {};
}

std::vector<ProgramGetter> neededDifferencePrograms(const FrameInput& in, ProgramStore& programs) {
  std::vector<ProgramGetter> out = neededPathPrograms(tracedInput(in), PathUse::difference, programs);
  for (const char* step : {"1", "2"}) out.emplace_back([&programs, step] { return filterProgram(step, programs); });
  out.emplace_back([&programs] { return addProgram(programs); });
  return out;
}

}  // namespace facet::frame
