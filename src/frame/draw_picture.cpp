// The prepared picture, drawn: in bands where it is large, once more with more samples where its error asks for that.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "constants.h"
#include "frame/blend_lists.hpp"
#include "frame/difference.hpp"
#include "frame/gather.hpp"
#include "frame/ground.hpp"
#include "frame/max_error.hpp"
#include "frame/overlay.hpp"
#include "frame/pass_clock.hpp"
#include "frame/picture.hpp"
#include "frame/screen.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

// The floor of a drawable that has one, as the whole wish asks for it.
Result<std::optional<GroundStatistics>> traceGround(const FrameInput& in, const Drawable& drawable,
                                                    shading::ProgramStore& programs, const gl::ContextInfo& context) {
  if (!drawable.ground) return std::optional<GroundStatistics>();
  const auto start = std::chrono::steady_clock::now();
  setTextureDetail(in.gpu, tracedDraws, in.settings.quality.textureFilter, context);
  if (Result<bool> done = continueGround(in, *drawable.ground, programs); !done) return tl::unexpected(done.error());
  glFinish();
  return GroundStatistics{drawable.ground->wish.size, drawable.ground->wish.samples, drawable.ground->rays,
                          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()};
}

// Rows of a band. Bands save memory and cost the geometry once more each: a few for scenes of little geometry, for
// others only where the targets of a large picture could not be had otherwise. A sample takes 12 bytes (RGBA16F and
// depth), 20 where it is precise; what is gathered has one at a time, and 20 bytes of sum and display. What shines
// through a surface may come from any row: a scene with such surfaces gets one band up to 4 GiB; beyond, what shines
// through ends at the band.
// A vertex is rounded where its band puts it, so that bands change the last digit of what is interpolated, and with it
// here and there a pixel. The window gathers its picture whole and draws the others in these very bands.
int bandRows(const PictureSettings& settings, const DrawList& list, const gl::ContextInfo& context, bool precise) {
  size_t corners = 0;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws)
      corners += std::max(draw.primitive->indices.size(), draw.primitive->positions.size()) * draw.instanceCount;
  const bool gather = converges(settings);
  size_t budget = corners < 300'000 && !gather ? size_t{4} << 20 : size_t{1} << 30;
  if (!list.transmitting.empty()) budget = size_t{4} << 30;
  const auto samples = static_cast<size_t>(std::min(settings.quality.samples, context.maxSamples));
  const size_t sampleBytes = precise ? 20 : 12, pixelBytes = gather ? sampleBytes + 20 : samples * sampleBytes;
  const size_t rows = budget / (static_cast<size_t>(settings.frame.width) * pixelBytes) / 16 * 16;
  return static_cast<int>(std::clamp<size_t>(rows, 16, static_cast<size_t>(std::max(16, settings.frame.height))));
}

// A band's pixels into the picture; firstRow counts from the bottom, data from the top.
template <class T>
void placeBand(std::vector<T>& picture, const std::vector<T>& band, size_t rowLength, int height, int firstRow) {
  const auto rows = static_cast<int>(band.size() / rowLength);
  const int kept = std::min(rows, height - firstRow);  // the last band may reach above the picture
  std::copy(band.end() - static_cast<ptrdiff_t>(static_cast<size_t>(kept) * rowLength), band.end(),
            picture.begin() + static_cast<ptrdiff_t>(static_cast<size_t>(height - firstRow - kept) * rowLength));
}

// As compare.frag.glsl does it with display values; the difference is not scaled.
void compareRadiance(io::RadianceImage& picture, const io::RadianceImage& fitted, const PictureSettings& settings) {
  const float split = settings.comparison.brdfSplit * static_cast<float>(picture.width);
  for (size_t i = 0; i < picture.pixels.size(); ++i) {
    glm::vec4& p = picture.pixels[i];
    const glm::vec4& f = fitted.pixels[i];
    if (settings.comparison.brdfCompare == BrdfCompare::difference)
      p = glm::vec4(glm::abs(glm::vec3(p) - glm::vec3(f)), 1);
    else if (static_cast<float>(i % static_cast<size_t>(picture.width)) + 0.5f >= split)
      p = f;
  }
}

// Of what is shown in 16 bits a channel.
Targets deepTargets(int width, int height) {
  Targets targets;
  targets.width = width, targets.height = height;
  targets.display = gl::Texture({.format = GL_RGBA16, .width = width, .height = height}, "display, 16 bits");
  targets.shown = gl::Framebuffer("shown in 16 bits");
  targets.shown.attach(GL_COLOR_ATTACHMENT0, targets.display);
  return targets;
}

// shown: what holds the display values.
void readBand(Picture& picture, const PictureRequest& request, const Targets& targets, const Targets& shown,
              const PictureSettings& settings, float unit, int firstRow) {
  const auto width = static_cast<size_t>(settings.frame.width), height = static_cast<size_t>(settings.frame.height);
  if (request.radiance) {
    io::RadianceImage band = readRadiance(targets, unit);
    if (targets.fitted) compareRadiance(band, readFitted(targets, unit), settings);
    if (settings.frame.background == Background::color)
      for (glm::vec4& p : band.pixels) p = glm::vec4(glm::vec3(p) + (1 - p.a) * backgroundColor(settings), 1);
    picture.radiance.width = settings.frame.width, picture.radiance.height = settings.frame.height;
    picture.radiance.pixels.resize(width * height);
    placeBand(picture.radiance.pixels, band.pixels, width, settings.frame.height, firstRow);
  }
  if (targets.contrasts) {
    const io::RadianceImage band = readStandardError(targets, settings.quality.samples, unit);
    picture.standardError.width = settings.frame.width, picture.standardError.height = settings.frame.height;
    picture.standardError.pixels.resize(width * height);
    placeBand(picture.standardError.pixels, band.pixels, width, settings.frame.height, firstRow);
  }
  if (request.display) {
    io::Pixels band = readDisplay(shown, settings.frame.background == Background::transparent);
    picture.display.width = settings.frame.width, picture.display.height = settings.frame.height;
    picture.display.channels = band.channels, picture.display.bytesPerSample = band.bytesPerSample;
    const size_t rowLength = width * static_cast<size_t>(band.channels * band.bytesPerSample);
    picture.display.data.resize(rowLength * height);
    placeBand(picture.display.data, band.data, rowLength, settings.frame.height, firstRow);
  }
}

// limit: the largest that the targets hold.
void countExtremes(const io::RadianceImage& image, float limit, PictureStatistics& statistics) {
  for (const glm::vec4& p : image.pixels) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || !std::isfinite(p.w))
      ++statistics.nonFinitePixels;
    else if (std::max({p.x, p.y, p.z}) >= limit)
      ++statistics.clampedPixels;
  }
}

std::map<std::string, int> variantsOf(const DrawList& list) {
  std::map<shading::VariantKey, int> draws;
  for (const std::vector<Draw>* drawn : list.classes())
    for (const Draw& draw : *drawn) ++draws[draw.key];
  std::map<std::string, int> variants;
  for (const auto& [key, count] : draws) variants[shading::variantName(key)] += count;
  return variants;
}

struct DrawnFrame {
  FrameStatistics statistics;  // of all bands
  double milliseconds = 0;     // waited for
};

// A band's work onto that of the bands before.
void add(FrameStatistics& sum, FrameStatistics band) {
  auto place = sum.passes.begin();  // a pass that no band has had yet follows the one before it
  for (std::string& pass : band.passes) {
    const auto known = std::find(place, sum.passes.end(), pass);
    place = known != sum.passes.end() ? known : sum.passes.insert(place, std::move(pass));
    ++place;
  }
  sum.draws += band.draws;
  sum.instances += band.instances;
  sum.triangles += band.triangles;
  sum.culled += band.culled;
  sum.rays += band.rays;
  sum.parts.resize(band.parts.size());
  for (size_t i = 0; i < band.parts.size(); ++i) {
    PartDifference& part = sum.parts[i];
    part.first = band.parts[i].first, part.next = band.parts[i].next;
    part.squares += band.parts[i].squares, part.fourths += band.parts[i].fourths, part.values += band.parts[i].values;
  }
}

// All bands; each goes to `read` when it is drawn.
using ReadBand = std::function<Result<void>(const FrameInput& band)>;
Result<DrawnFrame> drawBands(FrameInput in, Screen* screen, const Targets& targets, shading::ProgramStore& programs,
                             const gl::ContextInfo& context, const ReadBand& read) {
  DrawnFrame frame;
  FrameStatistics before;
  auto start = std::chrono::steady_clock::now();
  const auto wait = [&] {
    glFinish();
    const auto now = std::chrono::steady_clock::now();
    frame.milliseconds += std::chrono::duration<double, std::milli>(now - std::exchange(start, now)).count();
  };
  if (screen)
    if (Result<void> r = prepareScreen(in, *screen, programs, before); !r) return tl::unexpected(r.error());
  std::optional<Difference> difference;
  if (in.list.features.difference) {
    beginPass(in, before, "trace difference");
    setTextureDetail(in.gpu, tracedDraws, in.settings.quality.textureFilter, context);
    Result<Difference> traced = traceDifference(in, programs);
    setTextureDetail(in.gpu, gatheredDraws(in.settings, targets), in.settings.quality.textureFilter, context);
    if (!traced) return tl::unexpected(traced.error());
    difference = std::move(*traced);
    in.difference = &*difference;
    endPass(in);
    before.rays = difference->rays;
  }
  wait();
  for (in.firstRow = 0; in.firstRow < in.settings.frame.height; in.firstRow += targets.height) {
    start = std::chrono::steady_clock::now();
    Result<FrameStatistics> drawn = drawFrame(in, targets, programs);
    if (!drawn) return tl::unexpected(drawn.error());
    wait();
    add(frame.statistics, std::move(*drawn));
    if (Result<void> r = read ? read(in) : Result<void>(); !r) return tl::unexpected(r.error());
  }
  before.passes.insert(before.passes.end(), frame.statistics.passes.begin(), frame.statistics.passes.end());
  frame.statistics.passes = std::move(before.passes);
  frame.statistics.draws += before.draws, frame.statistics.instances += before.instances;
  frame.statistics.triangles += before.triangles, frame.statistics.rays += before.rays;
  return frame;
}

// For as many samples as the settings ask for, or for any number while the error decides.
Targets pictureTargets(const PictureSettings& settings, const gl::ContextInfo& context, int rows, bool corrected,
                       bool estimate, bool contrasts, bool precise) {
  Targets targets = createTargets(settings, context, rows, precise, corrected);
  if (estimate)
    targets.before =
        gl::Texture({.format = GL_RGBA32F, .width = settings.frame.width, .height = rows}, "first samples");
  if (contrasts)
    targets.contrasts = gl::Texture({.format = GL_RGBA32F, .width = settings.frame.width, .height = rows}, "contrasts");
  return targets;
}

}  // namespace

Targets createTargets(const PictureSettings& settings, const gl::ContextInfo& context, int rows, bool precise,
                      bool corrected) {
  const bool gather = converges(settings) || corrected;
  return createTargets(settings.frame.width, rows > 0 ? rows : settings.frame.height,
                       gather ? 1 : std::min(settings.quality.samples, context.maxSamples), gather, precise);
}

SlicedPicture beginSlices(const FrameInput& in, const gl::ContextInfo& context, bool inBands) {
  SlicedPicture out;
  const int height = in.settings.frame.height;
  out.bandRows =
      inBands && !converges(in.settings) ? std::min(height, bandRows(in.settings, in.list, context, false)) : height;
  if (out.bandRows == height) return out;
  out.band = createTargets(in.settings, context, out.bandRows);
  prepareBehind(out.band, in.list);
  prepareComparison(out.band, in.list);
  prepareBlendLists(out.band, in.list, in.settings);
  return out;
}

Result<bool> drawSlice(FrameInput in, const Targets& targets, SlicedPicture& picture, int64_t rows,
                       shading::ProgramStore& programs) {
  const FrameSettings& frame = in.settings.frame;
  in.firstRow = picture.firstRow;
  const Targets& drawn = picture.band.color ? picture.band : targets;
  if (!picture.gathering) picture.gathering = beginGathering(in, drawn);
  Gathering& gathering = *picture.gathering;
  if (Result<void> r = gatherRows(in, drawn, gathering, rows, programs); !r) return tl::unexpected(r.error());
  if (!gathering.complete()) return false;
  beginPass(in, gathering.statistics, "display");
  if (Result<void> r = drawDisplay(in, drawn, gathering, drawn, programs); !r) return tl::unexpected(r.error());
  endPass(in);
  const auto copy = [&](const gl::Texture& from, const gl::Texture& to) {
    if (from)
      glCopyImageSubData(from.id(), GL_TEXTURE_2D, 0, 0, 0, 0, to.id(), GL_TEXTURE_2D, 0, 0, in.firstRow, 0,
                         frame.width, std::min(picture.bandRows, frame.height - in.firstRow), 1);
  };
  copy(picture.band.color, targets.color);
  copy(picture.band.fitted, targets.fitted);
  copy(picture.band.display, targets.display);
  add(picture.statistics, std::move(gathering.statistics));
  picture.gathering.reset();
  picture.firstRow += picture.bandRows;
  return picture.firstRow >= frame.height;
}

Result<FrameStatistics> drawInBands(const FrameInput& in, const Targets& targets, shading::ProgramStore& programs,
                                    const gl::ContextInfo& context) {
  SlicedPicture picture = beginSlices(in, context, true);
  for (;;) {
    const Result<bool> whole = drawSlice(in, targets, picture, picture.bandRows, programs);
    if (!whole) return tl::unexpected(whole.error());
    if (*whole) return std::move(picture.statistics);
  }
}

namespace {

// Once for all frames of an animation.
scene::Bounds framingOf(const Drawable& drawable, const PictureSettings& settings) {
  const scene::Bounds& poseBounds = drawable.list.bounds;
  const Viewpoint& viewpoint = settings.viewpoint;
  const Placement& placement = settings.placement;
  const bool viewGiven = !viewpoint.camera.empty() ||
                         (viewpoint.target && viewpoint.orbit && (viewpoint.orbit->radius || viewpoint.viewHeight));
  if (viewGiven) return poseBounds;
  return animatedBounds(*drawable.scene, drawable.inputs.list.scene, placement, poseBounds);
}

// So many rows of lines at once: 128 MB.
constexpr int64_t mostOverlayPixels = int64_t{1} << 24;

// Lines over what is shown.
Result<void> addOverlay(const FrameInput& in, const Drawable& drawable, Picture& picture,
                        shading::ProgramStore& programs) {
  const shading::ProgramStatistics before = programs.statistics();
  const Result<OverlayLines> lines = overlayLines(drawable, in.settings);
  if (!lines) return tl::unexpected(lines.error());
  picture.statistics.gridSpacing = lines->gridSpacing;
  picture.statistics.overlayRemark = lines->remark;
  const FrameSettings& frame = in.settings.frame;
  const auto rows =
      static_cast<int>(std::min<int64_t>(frame.height, std::max<int64_t>(1, mostOverlayPixels / frame.width)));
  const OverlayTargets targets = createOverlayTargets(frame.width, rows);
  FrameInput band = in;
  for (band.firstRow = 0; band.firstRow < frame.height; band.firstRow += rows) {
    if (Result<void> r = drawOverlay(band, drawable, *lines, targets, programs); !r) return r;
    layOver(targets, band.firstRow, picture.display);
  }
  picture.statistics.programsCompiled += programs.statistics().compiled - before.compiled;
  picture.statistics.programsFromDisk += programs.statistics().fromDisk - before.fromDisk;
  return {};
}

}  // namespace

Result<Picture> drawPicture(const PictureSettings& asked, const PictureRequest& request, const Drawable& drawable,
                            PictureStatistics statisticsBefore, shading::ProgramStore& programs,
                            const gl::ContextInfo& context, Stages& stages) {
  Picture picture;
  picture.statistics = std::move(statisticsBefore);
  PictureStatistics& statistics = picture.statistics;
  const DrawList& list = drawable.list;
  PictureSettings settings = asked.quality.maxError ? withSamples(asked, firstSamples(asked)) : asked;
  const Result<scene::View> view = chooseView(settings.viewpoint, aspectOf(settings.frame), drawable.scene->source,
                                              drawable.scene->model(), list, framingOf(drawable, settings));
  if (!view) return tl::unexpected(view.error());
  PassClock clock;
  FrameInput input = frameInput(drawable, *view, settings);
  if (request.passTimes) input.clock = &clock;
  const GpuScene& gpu = drawable.scene->gpu;
  const bool precise = request.precise();
  const float unit = radianceUnit(settings.display, list.features.channel);
  const int rows = std::min(bandRows(settings, list, context, precise), settings.frame.height);
  const bool converging = converges(settings) && !list.features.difference;
  // Of a comparison the fitted model's share has another error.
  const bool contrasts = request.standardError && converging && !list.compared;
  const bool estimate = asked.quality.maxError || (request.estimate && converging) || contrasts;
  Targets targets = pictureTargets(settings, context, rows, list.features.difference, estimate, contrasts, precise);
  std::optional<Targets> deep;
  if (request.display && request.deep) deep = deepTargets(settings.frame.width, rows);
  prepareBehind(targets, list);
  prepareComparison(targets, list);
  prepareBlendLists(targets, list, settings);
  statistics.bands = (settings.frame.height + rows - 1) / rows;
  if (estimate)
    if (Result<void> r = prepareGatherPrograms(programs); !r) return tl::unexpected(r.error());

  Result<std::optional<GroundStatistics>> ground =
      traceGround(frameInput(drawable, *view, asked), drawable, programs, context);
  if (!ground) return tl::unexpected(ground.error());
  statistics.ground = std::move(*ground);
  if (statistics.ground) stages.mark("light on the floor");
  for (int samples = settings.quality.samples; samples > 0;) {
    settings.quality.samples = samples;
    setTextureDetail(gpu, list.features.paths ? tracedDraws : gatheredDraws(settings, targets),
                     settings.quality.textureFilter, context);
    std::vector<ComparisonSums> comparison;
    clock.take();  // of the attempt before
    Result<DrawnFrame> drawn = drawBands(
        input, drawable.screen.get(), targets, programs, context, [&](const FrameInput& band) -> Result<void> {
          stages.mark("first frame");
          if (deep)
            if (Result<void> r = showPicture(band, targets, 1, *deep, programs); !r) return r;
          readBand(picture, request, targets, deep ? *deep : targets, settings, unit, band.firstRow);
          if (comparing(band)) {
            Result<ComparisonSums> sums = sumComparison(band, targets, 1, programs);
            if (!sums) return tl::unexpected(sums.error());
            comparison.push_back(std::move(*sums));
          }
          stages.mark("read back");
          return {};
        });
    if (!drawn) return tl::unexpected(drawn.error());
    statistics.frame = std::move(drawn->statistics);
    statistics.frameMs = {drawn->milliseconds};
    if (!comparison.empty()) statistics.comparison = readComparison(comparison);
    samples = 0;
    if (!asked.quality.maxError) continue;
    statistics.attempts.push_back(
        {settings.quality.samples, errorEstimate(statistics.frame.parts), drawn->milliseconds});
    samples = nextSamples(asked, statistics.attempts);
  }
  for (int i = 0; i < request.repeat; ++i) {
    clock.take();
    const Result<DrawnFrame> drawn = drawBands(input, drawable.screen.get(), targets, programs, context, {});
    if (!drawn) return tl::unexpected(drawn.error());
    statistics.frameMs.push_back(drawn->milliseconds);
    stages.mark("repeated frames");
  }
  if (settings.overlays.shown != 0 && request.display) {
    if (Result<void> r = addOverlay(input, drawable, picture, programs); !r) return tl::unexpected(r.error());
    stages.mark("overlay");
  }
  statistics.passTimes = clock.take();
  statistics.range = rangeShown(list, *view, settings.display);
  statistics.visibility = chosenVisibility(asked, list);
  if (drawable.paths)
    statistics.traced = {drawable.paths->triangleCount, drawable.paths->bytes(), drawable.paths->buildMs};
  statistics.textureBytes = gpu.textureBytes();
  statistics.geometryBytes = gpu.geometryBytes();
  statistics.tableBytes = drawable.environment->tables.bytes();
  statistics.targetBytes =
      targetBytes(targets) + (deep ? targetBytes(*deep) : 0) + (drawable.screen ? drawable.screen->bytes() : 0);
  statistics.variants = variantsOf(list);
  if (request.radiance) countExtremes(picture.radiance, unit * largestStored(precise), statistics);
  return picture;
}

}  // namespace facet::frame
