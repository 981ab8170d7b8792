#include "frame/frame.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <span>

#include "frame/behind.hpp"
#include "frame/blend_lists.hpp"
#include "frame/choose.hpp"
#include "frame/difference.hpp"
#include "frame/display_pass.hpp"
#include "frame/draw_calls.hpp"
#include "frame/fitted_gpu.hpp"
#include "frame/ground.hpp"
#include "frame/pass_clock.hpp"
#include "frame/paths.hpp"
#include "frame/scene_pass.hpp"
#include "frame/screen.hpp"
#include "frame/settings.hpp"
#include "optics/zonal.hpp"
#include "scene/geometry.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

Result<const gl::Program*> meshProgram(const shading::VariantKey& key, ProgramStore& programs) {
  return programs.render("passes/mesh.vert.glsl", "passes/mesh.frag.glsl", shading::variantDefines(key));
}
bool backgroundBlurred(const FrameInput& in) {
  return in.tables.blurred.cube && (in.settings.frame.backgroundBlur > 0 || !in.tables.background);
}
Result<const gl::Program*> skyProgram(const FrameInput& in, ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/sky.frag.glsl", backgroundDefines(in));
}
bool skyVisible(const FrameInput& in) {
  return in.settings.frame.background == Background::environment && (in.tables.background || backgroundBlurred(in)) &&
         (in.list.features.channel == 0 || shading::isChannel(in.list.features.channel, shading::Channel::background));
}

// Draws a run of the list, changing program and material only where they change.
Result<void> drawSorted(const FrameInput& in, std::span<const Draw> draws, bool blended, ProgramStore& programs,
                        FrameStatistics& statistics) {
  const Draw* previous = nullptr;
  for (const Draw& draw : draws) {
    const bool sameProgram = previous && previous->key == draw.key;
    if (!sameProgram) {
      const auto program =
          meshProgram(in.fitted ? shading::fittedKey(draw.key, in.list.features.models.diffuse) : draw.key, programs);
      if (!program) return tl::unexpected(program.error());
      glUseProgram((*program)->id());
    }
    // The slots that are read depend on the primitive's attributes too, which the key holds.
    if (!sameProgram || draw.material != previous->material) bindMaterial(in, draw);
    previous = &draw;
    if (blended && draw.doubleSided && scene::hasTriangles(draw.primitive->topology)) {
      // The far side of a closed shape first.
      glEnable(GL_CULL_FACE);
      glCullFace(GL_FRONT);
      issue(in, draw, statistics);
      glCullFace(GL_BACK);
      issue(in, draw, statistics);
      continue;
    }
    setCulling(draw.doubleSided);
    issue(in, draw, statistics);
  }
  return {};
}

Result<void> drawOpaque(const FrameInput& in, const VisibleDraws& visible, ProgramStore& programs,
                        FrameStatistics& statistics) {
  if (visible.opaque.empty()) return {};
  beginPass(in, statistics, "opaque");
  if (shading::isChannel(in.list.features.channel, shading::Channel::overdraw)) {
    glDisable(GL_DEPTH_TEST);  // all that there is, one over the other
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ZERO);
    Result<void> drawn = drawSorted(in, visible.opaque, false, programs, statistics);
    glDisable(GL_BLEND);
    return drawn;
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  return drawSorted(in, visible.opaque, false, programs, statistics);
}

Result<void> drawSky(const FrameInput& in, ProgramStore& programs, FrameStatistics& statistics) {
  if (!skyVisible(in)) return {};
  const auto program = skyProgram(in, programs);
  if (!program) return tl::unexpected(program.error());
  beginPass(in, statistics, "sky");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  if (in.tables.background) in.tables.background.bind(layout::equirectUnit);
  glUseProgram((*program)->id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return {};
}

Result<void> drawBlended(const FrameInput& in, std::span<const Draw> draws, const char* pass, const Targets& targets,
                         ProgramStore& programs, FrameStatistics& statistics) {
  if (draws.empty()) return {};
  if (targets.lists) {
    beginPass(in, statistics, pass + std::string(" by lists"));
    const Result<bool> listed = drawListed(in, draws, targets, programs, statistics);
    if (!listed) return tl::unexpected(listed.error());
    if (*listed) return {};
    beginPass(in, statistics, pass + std::string(" by object: lists are too long"));
  } else {
    beginPass(in, statistics, pass);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  Result<void> result = drawSorted(in, draws, true, programs, statistics);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  return result;
}

// What shines through, then the surfaces that show it. They hide each other: none is seen through another.
Result<void> drawTransmitting(const FrameInput& in, const VisibleDraws& visible, const Targets& targets,
                              ProgramStore& programs, FrameStatistics& statistics) {
  if (visible.transmitting.empty()) return {};
  const std::span<const Draw> behind = std::span(visible.blended).first(visible.blendedBehind);
  if (Result<void> drawn = drawBlended(in, behind, "blend behind", targets, programs, statistics); !drawn) return drawn;
  beginPass(in, statistics, "copy behind");
  if (Result<void> copied = copyBehind(targets, programs); !copied) return copied;
  beginPass(in, statistics, "transmit");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  return drawSorted(in, visible.transmitting, false, programs, statistics);
}

void clearTargets(const FrameInput& in, const Targets& targets) {
  glm::vec4 clear(0, 0, 0, 1);
  // A colour is put behind the finished picture, so that neither exposure nor tone mapping changes it.
  if (in.settings.frame.background != Background::environment || showsQuantity(in)) clear.a = 0;
  const float far = 0;
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(targets.drawn.id(), GL_COLOR, 0, &clear.x);
  glClearNamedFramebufferfv(targets.drawn.id(), GL_DEPTH, 0, &far);
}

// The sun of a blurred background, which its cube does without.
void setBlurredSun(const FrameInput& in, layout::FrameUniforms& u) {
  const ibl::BlurredBackground& blurred = in.tables.blurred;
  u.blurredSunRadiance.w = blurred.mapShare;
  if (!in.tables.sun) return;
  const scene::Sun& sun = *in.tables.sun;
  const double share = 1 - double{blurred.mapShare};
  const double alpha = optics::backgroundLightAlpha(double{blurred.perceptualRoughness} * blurred.perceptualRoughness,
                                                    share, sun.angularRadius);
  const double scale = share * optics::prefilterKernel(alpha, 0) * in.settings.frame.environmentStrength;
  u.blurredSun = glm::vec4(glm::vec3(sun.direction), static_cast<float>(alpha * alpha));
  u.blurredSunRadiance = glm::vec4(glm::vec3(sun.irradiance * scale), blurred.mapShare);
}

}  // namespace

void beginPass(const FrameInput& in, FrameStatistics& statistics, std::string pass) {
  if (in.clock) in.clock->begin(pass);
  statistics.passes.push_back(std::move(pass));
}

void endPass(const FrameInput& in) {
  if (in.clock) in.clock->end();
}

std::vector<shading::Define> backgroundDefines(const FrameInput& in) {
  std::vector<shading::Define> defines;
  if (!backgroundBlurred(in)) return defines;
  defines.push_back({"BACKGROUND_BLUR"});
  if (in.tables.blurred.mapShare > 0 && in.tables.background) defines.push_back({"BACKGROUND_MAP"});
  return defines;
}

void bindMeasured(const FrameInput& in) {
  if (in.list.features.measured == shading::Measured::none) return;
  const gl::Buffer* buffer = in.measured;
  if ((in.fitted || in.list.features.measuredFitted) && in.fittedModel) buffer = in.fittedModel;
  if (buffer) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, buffer->id());
}

void bindScene(const FrameInput& in) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::instanceBinding, in.gpu.instances.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::lightBinding, in.gpu.lights.id());
  if (in.gpu.profiles) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::profileBinding, in.gpu.profiles.id());
  if (in.gpu.joints) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::jointBinding, in.gpu.joints.id());
  if (in.gpu.morphWeights)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::morphWeightBinding, in.gpu.morphWeights.id());
}

layout::FrameUniforms frameUniforms(const FrameInput& in, int draw, int draws, const glm::dvec2& offsetPixels) {
  const scene::View& view = in.view;
  const glm::dmat4 shift = glm::translate(glm::dmat4(1), glm::dvec3(2 * offsetPixels.x / in.settings.frame.width,
                                                                    2 * offsetPixels.y / in.settings.frame.height, 0));
  layout::FrameUniforms u{};
  u.clipFromWorld = glm::mat4(shift * view.clipFromWorld * glm::translate(glm::dmat4(1), in.list.origin));
  const double tanX = view.orthographic ? 0 : 1 / view.clipFromView[0][0];
  const double tanY = view.orthographic ? 0 : 1 / view.clipFromView[1][1];
  const glm::dvec3 skyForward = view.forward - view.right * (tanX * 2 * offsetPixels.x / in.settings.frame.width) -
                                view.up * (tanY * 2 * offsetPixels.y / in.settings.frame.height);
  u.worldFromClip = glm::mat4(glm::dmat4(glm::dvec4(view.right * tanX, 0), glm::dvec4(view.up * tanY, 0), glm::dvec4(0),
                                         glm::dvec4(skyForward, 0)));
  u.eye = glm::vec4(glm::vec3(view.eye - in.list.origin), view.orthographic ? 0.0f : 1.0f);
  u.towardsEye = glm::vec4(glm::vec3(-view.forward), 0);
  const float angle = glm::radians(in.settings.frame.environmentRotationDeg);
  u.environmentRotation = glm::vec4(std::cos(angle), std::sin(angle), 0, 0);
  const float scale = in.tables.radianceScale * in.settings.frame.environmentStrength;
  u.environmentScale = glm::vec4(scale, 0, in.settings.frame.environmentStrength, 0);
  u.options = glm::vec4(in.settings.frame.occlusion, static_cast<float>(draw), static_cast<float>(draws),
                        static_cast<float>(in.settings.quality.seed));
  u.picture = glm::vec4(in.settings.frame.width, in.settings.frame.height, in.firstRow,
                        static_cast<float>(view.clipFromView[1][1] * in.settings.frame.height / 2));
  const glm::dmat4& p = view.clipFromView;
  u.distanceFromDepth = glm::vec4(p[2][2], p[3][2], p[2][3], p[3][3]);
  const float unit = radianceUnit(in.settings.display, in.list.features.channel);
  u.stored = glm::vec4(1 / unit, unit, largestStored(in.precise), in.precise ? 0 : quantityFactor(in));
  if (in.settings.frame.background == Background::color)
    u.backdrop = glm::vec4(backgroundColor(in.settings) * std::exp2(-in.settings.display.exposureStops), 1);
  if (in.tables.blurred.cube) setBlurredSun(in, u);
  if (in.ground) u.ground = in.ground->place;
  if (in.screen && in.screen->width > 0)
    u.screen = glm::vec4(static_cast<float>(in.screen->width) / static_cast<float>(in.settings.frame.width),
                         static_cast<float>(in.screen->height) / static_cast<float>(in.settings.frame.height),
                         std::max(static_cast<float>(in.list.bounds.radius()), 1e-30f), 0);
  return u;
}

Result<FrameStatistics> drawScene(const FrameInput& in, const VisibleDraws& visible, const Targets& targets, int draw,
                                  int draws, const glm::dvec2& offsetPixels, ProgramStore& programs) {
  FrameStatistics statistics;
  const std::vector<layout::FrameUniforms> uniforms = {frameUniforms(in, draw, draws, offsetPixels)};
  const gl::Buffer frameBuffer = gl::Buffer::of(uniforms, "frame");
  glBindFramebuffer(GL_FRAMEBUFFER, targets.drawn.id());
  glViewport(0, -in.firstRow, in.settings.frame.width, in.settings.frame.height);
  clearTargets(in, targets);
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frameBuffer.id());
  bindScene(in);
  bindScreen(in);
  bindMeasured(in);
  bindTables(in.tables);
  glCullFace(GL_BACK);
  glBindVertexArray(targets.noAttributes.id());
  Result<void> drawn = drawOpaque(in, visible, programs, statistics);
  if (drawn) drawn = drawSky(in, programs, statistics);
  if (drawn) drawn = drawGround(in, programs, statistics);
  if (drawn) drawn = drawTransmitting(in, visible, targets, programs, statistics);
  const std::span<const Draw> before = std::span(visible.blended).subspan(visible.blendedBehind);
  if (drawn) drawn = drawBlended(in, before, "blend", targets, programs, statistics);
  if (!drawn) return tl::unexpected(drawn.error());
  for (GLuint unit = 0; unit < layout::materialSlotCount; ++unit) glBindSampler(unit, 0);
  if (targets.samples > 1) {
    beginPass(in, statistics, "resolve");
    glBlitNamedFramebuffer(targets.drawn.id(), targets.resolved.id(), 0, 0, targets.width, targets.height, 0, 0,
                           targets.width, targets.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  endPass(in);
  return statistics;
}

namespace {

std::vector<ProgramGetter> neededPrograms(const FrameInput& in, ProgramStore& programs) {
  std::set<shading::VariantKey> keys;
  for (const std::vector<Draw>* draws : in.list.classes())
    for (const Draw& draw : *draws) keys.insert(draw.key);
  std::vector<ProgramGetter> needed;
  if (in.list.features.paths) {
    needed = neededPathPrograms(in, PathUse::picture, programs);
    if (in.ground) std::ranges::copy(neededGroundPrograms(in, programs), std::back_inserter(needed));
    needed.push_back([&] { return displayProgram(in, programs); });
    return needed;
  }
  if (in.list.features.difference) needed = neededDifferencePrograms(in, programs);
  if (in.ground) std::ranges::copy(neededGroundPrograms(in, programs), std::back_inserter(needed));
  std::ranges::copy(neededScreenPrograms(in, programs), std::back_inserter(needed));
  for (const shading::VariantKey& key : keys) needed.push_back([&, key] { return meshProgram(key, programs); });
  if (comparing(in))
    for (const shading::VariantKey& key : keys) {
      const shading::VariantKey fitted = shading::fittedKey(key, in.list.features.models.diffuse);
      if (fitted != key) needed.push_back([&, fitted] { return meshProgram(fitted, programs); });
    }
  std::ranges::copy(neededListPrograms(in, programs), std::back_inserter(needed));
  if (!in.list.transmitting.empty()) needed.push_back([&] { return behindProgram(programs); });
  if (skyVisible(in)) needed.push_back([&] { return skyProgram(in, programs); });
  needed.push_back([&] { return displayProgram(in, programs); });
  return needed;
}

}  // namespace

void bindTables(const ibl::Tables& tables) {
  if (tables.dfg) tables.dfg.bind(layout::dfgUnit);
  if (tables.taps) tables.taps.bind(layout::tapsUnit);
  if (tables.sheen) tables.sheen.bind(layout::sheenAlbedoUnit);
  if (tables.irradiance) tables.irradiance.bind(layout::irradianceUnit);
  if (tables.mirrorLayers) tables.mirrorLayers.bind(layout::mirrorLayersUnit);
  if (tables.roughLayers) tables.roughLayers.bind(layout::roughLayersUnit);
  if (tables.rest) tables.rest.bind(layout::environmentRestUnit);
  if (tables.lamps) tables.lamps.bind(layout::lampCubeUnit);
  if (tables.lampPoints) tables.lampPoints.bind(layout::lampPointsUnit);
  if (tables.blurred.cube) tables.blurred.cube.bind(layout::blurredBackgroundUnit);
}

Result<void> preparePrograms(const FrameInput& in, ProgramStore& programs) {
  for (const ProgramGetter& get : neededPrograms(in, programs))
    if (const auto program = get(); !program) return tl::unexpected(program.error());
  return {};
}

Result<bool> prepareNextProgram(const FrameInput& in, ProgramStore& programs) {
  const auto built = [&] { return programs.statistics().compiled + programs.statistics().fromDisk; };
  const int before = built();
  for (const ProgramGetter& get : neededPrograms(in, programs)) {
    if (const auto program = get(); !program) return tl::unexpected(program.error());
    if (built() != before) return false;
  }
  return true;
}

}  // namespace facet::frame
