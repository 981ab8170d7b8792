#include "frame/frame.hpp"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <set>
#include <span>

#include "frame/behind.hpp"
#include "frame/visibility.hpp"
#include "scene/geometry.hpp"

namespace facet::frame {

namespace {

using scene::TextureSlot;
using shading::ProgramStore;

Result<const gl::Program*> meshProgram(const shading::VariantKey& key, ProgramStore& programs) {
  return programs.render("passes/mesh.vert.glsl", "passes/mesh.frag.glsl", shading::variantDefines(key));
}
Result<const gl::Program*> skyProgram(ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/sky.frag.glsl");
}
Result<const gl::Program*> displayProgram(ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/display.frag.glsl");
}
Result<const gl::Program*> gatherProgram(ProgramStore& programs) {
  return programs.render("passes/fullscreen.vert.glsl", "passes/gather.frag.glsl");
}

bool skyVisible(const FrameInput& in) {
  return in.settings.background == Background::environment && in.tables.background && in.list.features.channel == 0;
}

// Offsets within the pixel: the R2 sequence (Roberts 2018), which fills the square evenly for any count, shifted so
// that the offsets' mean is the pixel's centre.
std::vector<glm::dvec2> jitter(int count) {
  std::vector<glm::dvec2> offsets;
  glm::dvec2 mean(0);
  for (int i = 0; i < count; ++i) {
    offsets.push_back(glm::fract(0.5 + static_cast<double>(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532)));
    mean += offsets.back() / static_cast<double>(count);
  }
  for (glm::dvec2& offset : offsets) offset -= mean;
  return offsets;
}

layout::FrameUniforms frameUniforms(const FrameInput& in, int draw, int draws, const glm::dvec2& offsetPixels) {
  const scene::View& view = in.view;
  const glm::dmat4 shift = glm::translate(
      glm::dmat4(1), glm::dvec3(2 * offsetPixels.x / in.settings.width, 2 * offsetPixels.y / in.settings.height, 0));
  layout::FrameUniforms u{};
  u.clipFromWorld = glm::mat4(shift * view.clipFromWorld * glm::translate(glm::dmat4(1), in.list.origin));
  const double tanX = view.orthographic ? 0 : 1 / view.clipFromView[0][0];
  const double tanY = view.orthographic ? 0 : 1 / view.clipFromView[1][1];
  const glm::dvec3 skyForward = view.forward - view.right * (tanX * 2 * offsetPixels.x / in.settings.width) -
                                view.up * (tanY * 2 * offsetPixels.y / in.settings.height);
  u.worldFromClip = glm::mat4(glm::dmat4(glm::dvec4(view.right * tanX, 0), glm::dvec4(view.up * tanY, 0), glm::dvec4(0),
                                         glm::dvec4(skyForward, 0)));
  u.eye = glm::vec4(glm::vec3(view.eye - in.list.origin), view.orthographic ? 0.0f : 1.0f);
  u.towardsEye = glm::vec4(glm::vec3(-view.forward), 0);
  const float angle = glm::radians(in.settings.environmentRotationDeg);
  u.environmentRotation = glm::vec4(std::cos(angle), std::sin(angle), 0, 0);
  const float scale = in.tables.radianceScale * in.settings.environmentStrength;
  u.environmentScale = glm::vec4(scale, scale, 0, 0);
  u.options = glm::vec4(in.settings.occlusion, static_cast<float>(draw), static_cast<float>(draws), 0);
  u.picture = glm::vec4(in.settings.width, in.settings.height, in.firstRow,
                        static_cast<float>(view.clipFromView[1][1] * in.settings.height / 2));
  const glm::dmat4& p = view.clipFromView;
  u.distanceFromDepth = glm::vec4(p[2][2], p[3][2], p[2][3], p[3][3]);
  if (in.settings.background == Background::color)
    u.backdrop = glm::vec4(in.settings.backgroundColor * std::exp2(-in.settings.exposureStops), 1);
  return u;
}

void bindTables(const ibl::Tables& tables) {
  if (tables.dfg) tables.dfg.bind(layout::dfgUnit);
  if (tables.sheen) tables.sheen.bind(layout::sheenAlbedoUnit);
  if (tables.irradiance) tables.irradiance.bind(layout::irradianceUnit);
  if (tables.mirrorLayers) tables.mirrorLayers.bind(layout::mirrorLayersUnit);
  if (tables.roughLayers) tables.roughLayers.bind(layout::roughLayersUnit);
  if (tables.cube) tables.cube.bind(layout::environmentCubeUnit);
}

void bindMaterial(const FrameInput& in, const Draw& draw) {
  const auto index = static_cast<size_t>(draw.material);
  const scene::Material& material = in.list.materials[index];
  glBindBufferRange(GL_UNIFORM_BUFFER, layout::materialBinding, in.gpu.materials.id(),
                    static_cast<GLintptr>(index * in.gpu.materialStride), sizeof(layout::MaterialUniforms));
  for (const TextureSlot slot : scene::textureSlots) {
    if (!shading::samplesSlot({material, *draw.primitive, in.list.features}, slot)) continue;
    const BoundTexture bound = boundTexture(in.gpu, in.model, material, slot);
    glBindTextureUnit(static_cast<GLuint>(slot), bound.texture);
    glBindSampler(static_cast<GLuint>(slot), bound.sampler);
  }
}

uint64_t triangleCount(const GpuPrimitive& primitive) {
  switch (primitive.mode) {
    case GL_TRIANGLES:
      return static_cast<uint64_t>(primitive.count) / 3;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
      return static_cast<uint64_t>(std::max(0, primitive.count - 2));
    default:
      return 0;
  }
}

void issue(const FrameInput& in, const Draw& draw, FrameStatistics& statistics) {
  const GpuPrimitive& primitive = in.gpu.primitives.at(draw.primitive);
  glBindVertexArray(primitive.vertexArray.id());
  glFrontFace(draw.mirrored ? GL_CW : GL_CCW);
  if (primitive.influences)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::influenceBinding, primitive.influences.id());
  if (primitive.morphTargets)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::morphTargetBinding, primitive.morphTargets.id());
  const auto instances = static_cast<GLsizei>(draw.instanceCount);
  if (primitive.indexType == GL_NONE)
    glDrawArraysInstancedBaseInstance(primitive.mode, 0, primitive.count, instances, draw.firstInstance);
  else
    glDrawElementsInstancedBaseInstance(primitive.mode, primitive.count, primitive.indexType, nullptr, instances,
                                        draw.firstInstance);
  ++statistics.draws;
  statistics.instances += draw.instanceCount;
  statistics.triangles += triangleCount(primitive) * draw.instanceCount;
}

void setCulling(bool doubleSided) {
  if (doubleSided)
    glDisable(GL_CULL_FACE);
  else
    glEnable(GL_CULL_FACE);
}

// Draws a run of the list, changing program and material only where they change.
Result<void> drawSorted(const FrameInput& in, std::span<const Draw> draws, bool blended, ProgramStore& programs,
                        FrameStatistics& statistics) {
  const Draw* previous = nullptr;
  for (const Draw& draw : draws) {
    const bool sameProgram = previous && previous->key == draw.key;
    if (!sameProgram) {
      const auto program = meshProgram(draw.key, programs);
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
  statistics.passes.emplace_back("opaque");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  return drawSorted(in, visible.opaque, false, programs, statistics);
}

Result<void> drawSky(const FrameInput& in, ProgramStore& programs, FrameStatistics& statistics) {
  if (!skyVisible(in)) return {};
  const auto program = skyProgram(programs);
  if (!program) return tl::unexpected(program.error());
  statistics.passes.emplace_back("sky");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  in.tables.background.bind(layout::equirectUnit);
  glUseProgram((*program)->id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  return {};
}

Result<void> drawBlended(const FrameInput& in, std::span<const Draw> draws, const char* pass, ProgramStore& programs,
                         FrameStatistics& statistics) {
  if (draws.empty()) return {};
  statistics.passes.emplace_back(pass);
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
  if (Result<void> drawn = drawBlended(in, behind, "blend behind", programs, statistics); !drawn) return drawn;
  statistics.passes.emplace_back("copy behind");
  if (Result<void> copied = copyBehind(targets, programs); !copied) return copied;
  statistics.passes.emplace_back("transmit");
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  return drawSorted(in, visible.transmitting, false, programs, statistics);
}

// What lies in the rows that the targets hold.
VisibleDraws visibleRows(const FrameInput& in, const Targets& targets) {
  const auto clip = [&](int row) { return 2.0 * row / in.settings.height - 1; };
  constexpr double marginPixels = 2;  // offsets within the pixel; lines and points are one pixel wide
  return visibleDraws(in.list, in.view, {clip(in.firstRow), clip(in.firstRow + targets.height)},
                      2 * marginPixels / std::min(in.settings.width, in.settings.height));
}

void clearTargets(const FrameInput& in, const Targets& targets) {
  glm::vec4 clear(0, 0, 0, 1);
  // A colour is put behind the finished picture, so that neither exposure nor tone mapping changes it.
  if (in.settings.background != Background::environment) clear.a = 0;
  const float far = 0;
  glDepthMask(GL_TRUE);
  glClearNamedFramebufferfv(targets.drawn.id(), GL_COLOR, 0, &clear.x);
  glClearNamedFramebufferfv(targets.drawn.id(), GL_DEPTH, 0, &far);
}

// One draw of the scene into targets.color.
Result<FrameStatistics> drawScene(const FrameInput& in, const VisibleDraws& visible, const Targets& targets, int draw,
                                  int draws, const glm::dvec2& offsetPixels, ProgramStore& programs) {
  FrameStatistics statistics;
  const std::vector<layout::FrameUniforms> uniforms = {frameUniforms(in, draw, draws, offsetPixels)};
  const gl::Buffer frameBuffer = gl::Buffer::of(uniforms, "frame");
  glBindFramebuffer(GL_FRAMEBUFFER, targets.drawn.id());
  glViewport(0, -in.firstRow, in.settings.width, in.settings.height);
  clearTargets(in, targets);
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frameBuffer.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::instanceBinding, in.gpu.instances.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::lightBinding, in.gpu.lights.id());
  if (in.gpu.joints) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::jointBinding, in.gpu.joints.id());
  if (in.gpu.morphWeights)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::morphWeightBinding, in.gpu.morphWeights.id());
  bindTables(in.tables);
  glCullFace(GL_BACK);
  glBindVertexArray(targets.noAttributes.id());
  Result<void> drawn = drawOpaque(in, visible, programs, statistics);
  if (drawn) drawn = drawSky(in, programs, statistics);
  if (drawn) drawn = drawTransmitting(in, visible, targets, programs, statistics);
  const std::span<const Draw> before = std::span(visible.blended).subspan(visible.blendedBehind);
  if (drawn) drawn = drawBlended(in, before, "blend", programs, statistics);
  if (!drawn) return tl::unexpected(drawn.error());
  for (GLuint unit = 0; unit < layout::materialSlotCount; ++unit) glBindSampler(unit, 0);
  if (targets.samples > 1) {
    statistics.passes.emplace_back("resolve");
    glBlitNamedFramebuffer(targets.drawn.id(), targets.resolved.id(), 0, 0, targets.width, targets.height, 0, 0,
                           targets.width, targets.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  return statistics;
}

void drawFullscreen(const gl::Framebuffer& target, const Targets& targets, const gl::Texture& source,
                    const gl::Program& program) {
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glBindVertexArray(targets.noAttributes.id());
  glViewport(0, 0, targets.width, targets.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  source.bind(layout::sourceUnit);
  glUseProgram(program.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Result<void> drawDisplay(const FrameInput& in, const Targets& targets, ProgramStore& programs) {
  const auto program = displayProgram(programs);
  if (!program) return tl::unexpected(program.error());
  const int channel = in.list.features.channel;
  const bool shaded = channel == 0;
  const bool encode = shading::channelIsColor(channel);
  (*program)->set(0, glm::vec4(shaded ? std::exp2(in.settings.exposureStops) : 1.0f,
                               shaded ? static_cast<float>(in.settings.toneMapper) : 0.0f, encode ? 1.0f : 0.0f, 0));
  (*program)->set(1, glm::vec4(in.settings.backgroundColor, in.settings.background == Background::color ? 1.0f : 0.0f));
  drawFullscreen(targets.shown, targets, targets.sum ? targets.sum : targets.color, **program);
  return {};
}

// Adds targets.color / draws to the sum.
Result<void> gather(const Targets& targets, int draws, ProgramStore& programs) {
  const auto program = gatherProgram(programs);
  if (!program) return tl::unexpected(program.error());
  (*program)->set(0, 1.0f / static_cast<float>(draws));
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  drawFullscreen(targets.gathered, targets, targets.color, **program);
  glDisable(GL_BLEND);
  return {};
}

}  // namespace

int gatheredDraws(const PictureSettings& settings, const Targets& targets) {
  return targets.sum ? settings.samples : 1;
}

Result<void> preparePrograms(const FrameInput& in, ProgramStore& programs) {
  std::set<shading::VariantKey> keys;
  for (const std::vector<Draw>* draws : in.list.classes())
    for (const Draw& draw : *draws) keys.insert(draw.key);
  for (const shading::VariantKey& key : keys)
    if (const auto program = meshProgram(key, programs); !program) return tl::unexpected(program.error());
  if (!in.list.transmitting.empty())
    if (Result<void> prepared = prepareBehindPrograms(programs); !prepared) return prepared;
  if (skyVisible(in))
    if (const auto program = skyProgram(programs); !program) return tl::unexpected(program.error());
  const auto program = displayProgram(programs);
  if (!program) return tl::unexpected(program.error());
  return {};
}

Result<FrameStatistics> drawFrame(const FrameInput& in, const Targets& targets, ProgramStore& programs) {
  const int draws = gatheredDraws(in.settings, targets);
  FrameStatistics statistics;
  if (targets.sum) {
    const glm::vec4 zero(0);
    glClearNamedFramebufferfv(targets.gathered.id(), GL_COLOR, 0, &zero.x);
  }
  const VisibleDraws visible = visibleRows(in, targets);
  const gl::Buffer visibleBuffer = gl::Buffer::of(visible.instances, "visible instances");
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::visibleBinding, visibleBuffer.id());
  const std::vector<glm::dvec2> offsets = jitter(draws);
  for (int i = 0; i < draws; ++i) {
    Result<FrameStatistics> drawn =
        drawScene(in, visible, targets, i, draws, offsets[static_cast<size_t>(i)], programs);
    if (!drawn) return drawn;
    if (i == 0) statistics = std::move(*drawn), statistics.culled = visible.culled;
    if (targets.sum)
      if (Result<void> result = gather(targets, draws, programs); !result) return tl::unexpected(result.error());
  }
  if (targets.sum) statistics.passes.push_back("gather x " + std::to_string(draws));
  statistics.passes.emplace_back("display");
  if (Result<void> result = drawDisplay(in, targets, programs); !result) return tl::unexpected(result.error());
  return statistics;
}

}  // namespace facet::frame
