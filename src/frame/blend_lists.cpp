#include "frame/blend_lists.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <set>

#include "blend_lists.h"
#include "frame/display_pass.hpp"
#include "frame/draw_calls.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

constexpr size_t nodeBytes = 32;
constexpr uint32_t nothing = 0xffffffffu;

Result<const gl::Program*> keepProgram(const shading::VariantKey& key, ProgramStore& programs) {
  std::vector<shading::Define> defines = shading::variantDefines(key);
  defines.push_back({"BLEND_LISTS"});
  return programs.render("passes/mesh.vert.glsl", "passes/mesh.frag.glsl", defines);
}
Result<const gl::Program*> resolveProgram(int samples, ProgramStore& programs) {
  std::vector<shading::Define> defines;
  if (samples > 1) defines.push_back({"SAMPLES", std::to_string(samples)});
  return programs.render("passes/fullscreen.vert.glsl", "passes/blend_resolve.frag.glsl", defines);
}

shading::VariantKey keyOf(const FrameInput& in, const Draw& draw) {
  return in.fitted ? shading::fittedKey(draw.key, in.list.features.models.diffuse) : draw.key;
}

// Fills the lists; how many nodes that takes, whether or not there was room.
Result<uint32_t> keep(const FrameInput& in, std::span<const Draw> draws, const BlendLists& lists,
                      ProgramStore& programs, FrameStatistics& statistics) {
  glClearNamedBufferData(lists.heads.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &nothing);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::blendHeadsBinding, lists.heads.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::blendNodesBinding, lists.nodes.id());
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  for (size_t i = 0; i < draws.size(); ++i) {
    const auto program = keepProgram(keyOf(in, draws[i]), programs);
    if (!program) {
      glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
      return tl::unexpected(program.error());
    }
    glUseProgram((*program)->id());
    glProgramUniform1ui((*program)->id(), layout::blendOrderLocation, static_cast<uint32_t>(i) << 20);
    bindMaterial(in, draws[i]);
    setCulling(draws[i].doubleSided);
    issue(in, draws[i], statistics);
  }
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
  return lists.heads.read<uint32_t>(1)[0] + 1;
}

}  // namespace

bool listsAvailable() { return epoxy_has_gl_extension("GL_ARB_post_depth_coverage"); }

void prepareBlendLists(Targets& targets, const DrawList& list, const PictureSettings& settings) {
  const bool wanted = settings.quality.blending == Blending::lists && !list.blended.empty() && listsAvailable();
  if (!wanted) {
    targets.lists = {};
    return;
  }
  if (targets.lists) return;
  targets.lists = std::make_unique<BlendLists>();
  const size_t pixels = static_cast<size_t>(targets.width) * static_cast<size_t>(targets.height);
  targets.lists->heads = gl::Buffer((1 + pixels) * sizeof(uint32_t), "lists of blended surfaces", true);
  targets.lists->capacity = static_cast<uint32_t>(std::max<size_t>(pixels, 1024));
  targets.lists->nodes = gl::Buffer(targets.lists->capacity * nodeBytes, "blended surfaces");
}

std::vector<ProgramGetter> neededListPrograms(const FrameInput& in, ProgramStore& programs) {
  std::vector<ProgramGetter> needed;
  if (in.settings.quality.blending != Blending::lists || in.list.blended.empty() || !listsAvailable()) return needed;
  std::set<shading::VariantKey> keys;
  for (const Draw& draw : in.list.blended) keys.insert(draw.key);
  for (const shading::VariantKey& key : keys)
    needed.emplace_back([&programs, key] { return keepProgram(key, programs); });
  return needed;
}

Result<bool> drawListed(const FrameInput& in, std::span<const Draw> draws, const Targets& targets,
                        ProgramStore& programs, FrameStatistics& statistics) {
  BlendLists& lists = *targets.lists;
  GLint64 most = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GEQUAL);
  glDepthMask(GL_FALSE);
  for (;;) {
    const FrameStatistics before = statistics;
    const Result<uint32_t> nodes = keep(in, draws, lists, programs, statistics);
    if (!nodes) return tl::unexpected(nodes.error());
    if (*nodes <= lists.capacity) break;
    statistics = before;  // once more, with room for all
    if (*nodes * uint64_t{nodeBytes} > static_cast<uint64_t>(most)) return false;
    lists.capacity = *nodes + *nodes / 8;
    if (lists.capacity * uint64_t{nodeBytes} > static_cast<uint64_t>(most)) lists.capacity = *nodes;
    lists.nodes = {};
    lists.nodes = gl::Buffer(lists.capacity * nodeBytes, "blended surfaces");
  }
  const auto resolve = resolveProgram(targets.samples, programs);
  if (!resolve) return tl::unexpected(resolve.error());
  (*resolve)->set(GLint{layout::blendWidthLocation}, targets.width);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glUseProgram((*resolve)->id());
  glViewport(0, 0, targets.width, targets.height);
  glBindVertexArray(targets.noAttributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glViewport(0, -in.firstRow, in.settings.frame.width, in.settings.frame.height);
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  return true;
}

}  // namespace facet::frame
