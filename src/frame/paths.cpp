#include "frame/paths.hpp"

#include <algorithm>
#include <chrono>

#include "frame/ground.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"
#include "paths.h"
#include "rays.h"

namespace facet::frame {

namespace {

using shading::Define;
using shading::ProgramStore;

// Paths that are under way at once.
constexpr int64_t mostPaths = int64_t{1} << 19;

BufferTexture bufferTexture(std::span<const std::byte> data, GLenum format, const char* label) {
  BufferTexture out{gl::Buffer(data, label), {}};
  out.texture = gl::Texture::ofBuffer(out.buffer.id(), format, label);
  return out;
}

// What all programs of a scene are compiled with.
std::vector<Define> commonDefines(const FrameInput& in, PathUse use) {
  if (use == PathUse::ground) return {{"GROUND"}};
  std::vector<Define> defines;
  if (use == PathUse::difference) defines.push_back({"DIFFERENCE"});
  if (use == PathUse::difference && in.precise) defines.push_back({"PRECISE"});
  return defines;
}
// Where a picture is corrected such light is no part of what is drawn.
bool looksAtGlow(const FrameInput& in, PathUse use) {
  return use == PathUse::picture && !in.paths->list.glowing.empty();
}
std::vector<Define> sceneDefines(const FrameInput& in, PathUse use) {
  std::vector<Define> defines = commonDefines(in, use);
  if (in.list.features.environment) defines.push_back({"HAS_ENVIRONMENT"});
  if (in.paths->list.lights > 0) defines.push_back({"HAS_PUNCTUAL_LIGHTS"});
  if (in.list.features.lightProfiles) defines.push_back({"LIGHT_PROFILES"});
  if (looksAtGlow(in, use)) defines.push_back({"GLOWING"});
  if (!in.paths->list.scene.placements.empty()) defines.push_back({"RAY_PLACEMENTS"});
  if (in.paths->list.scene.holed) defines.push_back({"RAY_HOLES"});
  return defines;
}

bool seesBackground(const FrameInput& in) {
  return in.list.features.environment && in.settings.frame.background == Background::environment;
}

std::vector<Define> missDefines(const FrameInput& in, PathUse use) {
  std::vector<Define> defines = sceneDefines(in, use);
  if (in.ground && use == PathUse::picture) defines.push_back({"GROUND_SEEN"});
  if (seesBackground(in)) {
    defines.push_back({"BACKGROUND"});
    if (use == PathUse::picture) std::ranges::copy(backgroundDefines(in), std::back_inserter(defines));
  }
  return defines;
}

std::vector<Define> classDefines(const FrameInput& in, const PathClass& shaded, PathUse use) {
  std::vector<Define> defines =
      shading::variantDefines(in.fitted ? shading::fittedKey(shaded.key, in.list.features.models.diffuse) : shaded.key);
  for (const Define& define : commonDefines(in, use)) defines.push_back(define);
  if (use == PathUse::picture && in.settings.quality.caustics == Caustics::soft) defines.push_back({"SOFT_CAUSTICS"});
  const bool sun = static_cast<int>(in.list.lights.size()) > in.paths->list.lights;
  if (use == PathUse::difference && sun && in.list.features.environment) defines.push_back({"PATH_SUN"});
  if (!in.paths->list.scene.placements.empty()) defines.push_back({"RAY_PLACEMENTS"});
  if (in.paths->list.media) defines.push_back({"SCENE_MEDIA"});
  if (looksAtGlow(in, use)) defines.push_back({"GLOWING"});
  const bool passed = shading::usesFeature(shaded.key, shading::Feature::transmission) ||
                      shading::usesFeature(shaded.key, shading::Feature::diffuseTransmission);
  if (passed && use == PathUse::picture && seesBackground(in))
    std::ranges::copy(backgroundDefines(in), std::back_inserter(defines));
  return defines;
}

// By what they do. ProgramGetter, or what it gives.
template <class T>
struct PathPrograms {
  std::array<T, 3> plans;
  T begin, meet, sort, miss, light;
  std::vector<T> classes;
  T end;  // of pictures
};

PathPrograms<ProgramGetter> programGetters(const FrameInput& in, PathUse use, ProgramStore& store) {
  const auto getter = [&](const char* name, std::vector<Define> defines) {
    return [&store, entry = "passes/paths_" + std::string(name) + ".comp.glsl", defines = std::move(defines)] {
      return store.compute(entry, defines);
    };
  };
  const std::vector<Define> common = commonDefines(in, use), ofScene = sceneDefines(in, use);
  PathPrograms<ProgramGetter> out;
  for (size_t step = 0; step < out.plans.size(); ++step) {
    std::vector<Define> defines = common;
    defines.push_back({"STEP", std::to_string(step)});
    out.plans[step] = getter("plan", std::move(defines));
  }
  out.begin = use == PathUse::ground ? getter("ground", ofScene) : getter("begin", common);
  out.meet = getter("meet", ofScene), out.sort = getter("sort", common), out.light = getter("light", ofScene);
  out.miss = getter("miss", missDefines(in, use));
  for (const PathClass& shaded : in.paths->list.classes)
    out.classes.emplace_back(getter("shade", classDefines(in, shaded, use)));
  if (use == PathUse::picture) out.end = getter("end", {});  // else paths leave their light where they find it
  return out;
}

using Programs = PathPrograms<const gl::Program*>;

Result<Programs> pathPrograms(const FrameInput& in, PathUse use, ProgramStore& store) {
  const PathPrograms<ProgramGetter> getters = programGetters(in, use, store);
  Programs out{};
  out.classes.resize(getters.classes.size());
  std::optional<Error> failed;
  const auto make = [&](const ProgramGetter& get, const gl::Program*& program) {
    if (failed || !get) return;
    const Result<const gl::Program*> made = get();
    made ? void(program = *made) : void(failed = made.error());
  };
  for (size_t i = 0; i < out.plans.size(); ++i) make(getters.plans[i], out.plans[i]);
  make(getters.begin, out.begin), make(getters.meet, out.meet), make(getters.sort, out.sort);
  make(getters.miss, out.miss), make(getters.light, out.light), make(getters.end, out.end);
  for (size_t i = 0; i < out.classes.size(); ++i) make(getters.classes[i], out.classes[i]);
  if (failed) return tl::unexpected(*failed);
  return out;
}

// As many paths as the rows have pixels.
void makeRoom(PathWork& work, size_t paths, size_t classes) {
  if (work.paths >= paths) return;
  work = {};
  work.paths = paths;
  work.states = gl::Buffer(paths * sizeof(layout::PathState), "paths");
  work.work = gl::Buffer((layout::workClasses + 3 * classes + layout::workLists * paths) * sizeof(uint32_t),
                         "lists of paths", true);
  const std::array<uint32_t, 2> none = {0, 0};
  work.work.update(std::as_bytes(std::span(none)), layout::workRays * sizeof(uint32_t));
  work.groups = gl::Buffer((layout::groupsClasses + classes) * 3 * sizeof(uint32_t), "groups of paths");
}

void barrier() {
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void dispatch(const gl::Program& program, size_t invocations) {
  glUseProgram(program.id());
  glDispatchCompute(static_cast<GLuint>(layout::groupsFor(static_cast<int>(invocations), layout::groupInvocations)), 1,
                    1);
  barrier();
}
void dispatchCounted(const gl::Program& program, uint32_t group) {
  glUseProgram(program.id());
  glDispatchComputeIndirect(static_cast<GLintptr>(group * 3 * sizeof(uint32_t)));
}

// A texture's alpha behind those that are there; its first texel.
struct Alphas {
  struct Source {
    GLuint texture;
    uint32_t first, width, height;
  };
  std::vector<Source> sources;
  uint32_t texels = 0;

  const Source& of(GLuint texture) {
    for (const Source& source : sources)
      if (source.texture == texture) return source;
    GLint width = 0, height = 0;
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_WIDTH, &width);
    glGetTextureLevelParameteriv(texture, 0, GL_TEXTURE_HEIGHT, &height);
    sources.push_back({texture, texels, static_cast<uint32_t>(width), static_cast<uint32_t>(height)});
    texels += (sources.back().width * sources.back().height + 3) / 4 * 4;
    return sources.back();
  }
};

uint32_t wrapOf(scene::Wrap wrap) {
  return wrap == scene::Wrap::clampToEdge      ? layout::wrapClamp
         : wrap == scene::Wrap::mirroredRepeat ? layout::wrapMirror
                                               : layout::wrapRepeat;
}

// What of the materials lets rays pass.
Result<void> addHoles(PathScene& out, const DrawList& list, const scene::Model& model, const GpuScene& gpu,
                      ProgramStore& programs) {
  std::vector<layout::RayHoles> holes;
  Alphas alphas;
  for (size_t i = 0; i < list.materials.size(); ++i) {
    const scene::Material& material = list.materials[i];
    layout::RayHoles& h = holes.emplace_back();
    h = {};
    h.masked = material.alphaMode == scene::AlphaMode::mask ? 1 : 0;
    if (material.alphaMode == scene::AlphaMode::opaque || !material.baseColor) continue;
    const scene::Texture& texture = model.textures[static_cast<size_t>(material.baseColor.texture)];
    const Alphas::Source& source =
        alphas.of(boundTexture(gpu, model, material, scene::TextureSlot::baseColor, list.maskThresholds[i]).texture);
    h.first = source.first, h.width = source.width, h.height = source.height;
    h.wrapS = wrapOf(texture.sampler.wrapS), h.wrapT = wrapOf(texture.sampler.wrapT);
    h.nearest = texture.sampler.magFilter == scene::Filter::nearest ? 1 : 0;
  }
  const auto program = programs.compute("passes/hole_alpha.comp.glsl");
  if (!program) return tl::unexpected(program.error());
  out.holes = gl::Buffer::of(holes, "holes");
  out.alpha.buffer = gl::Buffer(std::max<size_t>(alphas.texels, 4), "alpha for rays");
  out.alpha.texture = gl::Texture::ofBuffer(out.alpha.buffer.id(), GL_R8, "alpha for rays");
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.alpha.buffer.id());
  glBindSampler(layout::sourceUnit, 0);
  for (const Alphas::Source& source : alphas.sources) {
    glBindTextureUnit(layout::sourceUnit, source.texture);
    glProgramUniform1ui((*program)->id(), layout::holesFirstLocation, source.first);
    dispatch(**program, (static_cast<size_t>(source.width) * source.height + 3) / 4);
  }
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
  return {};
}

void setCamera(const FrameInput& in, layout::PathUniforms& uniforms) {
  const scene::View& view = in.view;
  const double x = 1 / view.clipFromView[0][0], y = 1 / view.clipFromView[1][1];
  const glm::dvec3 right = view.right * x, up = view.up * y;
  uniforms.origins[0] = glm::vec4(glm::vec3(view.eye - in.list.origin), static_cast<float>(view.zNear));
  uniforms.directions[0] = glm::vec4(glm::vec3(view.forward), 0);
  glm::vec4* const across = view.orthographic ? uniforms.origins : uniforms.directions;
  across[1] = glm::vec4(glm::vec3(right), 0), across[2] = glm::vec4(glm::vec3(up), 0);
}

layout::PathUniforms pathUniforms(const FrameInput& in, const PathWork& work, int number, float share) {
  layout::PathUniforms uniforms{};
  setCamera(in, uniforms);
  uniforms.paths = static_cast<uint32_t>(work.paths);
  uniforms.classes = static_cast<uint32_t>(in.paths->list.classes.size() + 1);
  uniforms.number = static_cast<uint32_t>(number);
  uniforms.mostVertices = static_cast<uint32_t>(in.settings.quality.bounces);
  uniforms.lights = static_cast<uint32_t>(in.paths->list.lights);
  uniforms.glowing = static_cast<uint32_t>(in.paths->list.glowing.size());
  if (in.paths->list.glow > 0) uniforms.perGlow = static_cast<float>(1 / in.paths->list.glow);
  uniforms.share = share;
  return uniforms;
}

void bindClass(const FrameInput& in, const PathClass& shaded) {
  if (shaded.material < 0) return;
  bindTextures(in, shaded.material, *shaded.primitive);
}

void bindScene(const FrameInput& in, const PathWork& work) {
  const PathScene& scene = *in.paths;
  scene.nodes.texture.bind(layout::rayNodesUnit);
  scene.triangles.texture.bind(layout::rayTrianglesUnit);
  if (scene.glowing.texture) scene.glowing.texture.bind(layout::glowingUnit);
  if (scene.holes) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::rayHolesBinding, scene.holes.id());
  if (scene.alpha.texture) scene.alpha.texture.bind(layout::rayAlphaUnit);
  if (scene.placements.texture) scene.placements.texture.bind(layout::rayPlacementsUnit);
  bindSceneBuffers(scene.buffers);
  bindTables(in.tables);
  bindMeasured(in);
  if (in.tables.background) in.tables.background.bind(layout::equirectUnit);
  if (in.tables.texels) in.tables.texels.bind(layout::environmentTexelsUnit);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::instanceBinding, scene.instances.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::lightBinding, in.gpu.lights.id());
  if (in.gpu.profiles) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::profileBinding, in.gpu.profiles.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, work.states.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, work.work.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::pathGroupsBinding, work.groups.id());
  glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, work.groups.id());
}

// One sample of some rows, few enough that all of their paths are under way at once.
void traceRows(const FrameInput& in, PathUse use, const PathWork& work, const Programs& programs,
               layout::PathUniforms uniforms, int firstRow, int rows) {
  const size_t paths = static_cast<size_t>(rows) * uniforms.columns;
  uniforms.firstRow = static_cast<uint32_t>(firstRow + in.firstRow), uniforms.rows = static_cast<uint32_t>(rows);
  const gl::Buffer common = gl::Buffer::of(std::vector{uniforms}, "path uniforms");
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::pathsBinding, common.id());
  const bool atSurface = use == PathUse::ground;  // where paths begin, one has been met
  const std::array<uint32_t, 4> counts = {0, static_cast<uint32_t>(paths), 0, atSurface ? 1u : 0u};
  work.work.update(std::as_bytes(std::span(counts)));
  dispatch(*programs.begin, paths);
  const auto plan = [&](size_t step) { dispatch(*programs.plans[step], 1); };
  const auto seeLights = [&] {
    plan(2);
    dispatchCounted(*programs.light, layout::groupsLights);
    barrier();
  };
  if (atSurface) seeLights();
  for (int vertex = 0; vertex <= in.settings.quality.bounces; ++vertex) {
    plan(0);
    dispatchCounted(*programs.meet, layout::groupsActive);
    barrier();
    plan(1);
    dispatchCounted(*programs.sort, layout::groupsActive);
    barrier();
    dispatchCounted(*programs.miss, layout::groupsClasses + layout::missClass);
    for (size_t i = 0; i < programs.classes.size(); ++i) {
      bindClass(in, in.paths->list.classes[i]);
      glProgramUniform1ui(programs.classes[i]->id(), layout::pathsClassLocation, static_cast<GLuint>(i + 1));
      dispatchCounted(*programs.classes[i], static_cast<uint32_t>(layout::groupsClasses + i + 1));
    }
    barrier();
    seeLights();
  }
  if (programs.end) dispatch(*programs.end, paths);
}

}  // namespace

size_t PathScene::bytes() const {
  return nodes.buffer.bytes() + triangles.buffer.bytes() + placements.buffer.bytes() + buffers.bytes() +
         instances.bytes();
}

PathTrees pathTrees(const DrawList& list) {
  const auto start = std::chrono::steady_clock::now();
  PathTrees out;
  if (!list.features.paths) {
    out.drawn = list;
    setFeatures(*out.drawn, pathFeatures(list.features));
  }
  out.list = tracedList(out.drawn ? *out.drawn : list);
  out.buildMs = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return out;
}

Result<PathScene> pathScene(PathTrees trees, const DrawList& list, const scene::Model& model, const GpuScene& gpu,
                            shading::ProgramStore& programs) {
  PathScene out;
  out.drawn = std::move(trees.drawn), out.list = std::move(trees.list), out.buildMs = trees.buildMs;
  rays::TracedScene& scene = out.list.scene;
  out.triangleCount = static_cast<int>(scene.triangles.size());
  out.nodes = bufferTexture(std::as_bytes(std::span(scene.nodes)), GL_RGBA32UI, "ray nodes");
  out.triangles = bufferTexture(std::as_bytes(std::span(scene.triangles)), GL_RGBA32UI, "ray triangles");
  if (!scene.placements.empty())
    out.placements = bufferTexture(std::as_bytes(std::span(scene.placements)), GL_RGBA32UI, "ray placements");
  if (!out.list.glowing.empty())
    out.glowing = bufferTexture(std::as_bytes(std::span(out.list.glowing)), GL_RGBA32F, "glowing triangles");
  out.buffers = sceneBuffers(out.list.parts, list.materials, false);
  out.instances = gl::Buffer::of(out.list.instances, "path instances");
  if (scene.holed)
    if (Result<void> made = addHoles(out, list, model, gpu, programs); !made) return tl::unexpected(made.error());
  scene.nodes = {}, scene.triangles = {};
  out.list.deformed.clear(), out.list.parts = {}, out.list.instances = {};
  return out;
}

std::vector<ProgramGetter> neededPathPrograms(const FrameInput& in, PathUse use, shading::ProgramStore& programs) {
  PathPrograms<ProgramGetter> getters = programGetters(in, use, programs);
  std::vector<ProgramGetter> out(getters.plans.begin(), getters.plans.end());
  for (ProgramGetter* get : {&getters.begin, &getters.meet, &getters.sort, &getters.miss, &getters.light, &getters.end})
    if (*get) out.push_back(std::move(*get));
  std::ranges::move(getters.classes, std::back_inserter(out));
  return out;
}

Result<void> tracePaths(const FrameInput& in, const PathRows& rows, PathWork& work, int number, ProgramStore& store) {
  const Result<Programs> programs = pathPrograms(in, rows.use, store);
  if (!programs) return tl::unexpected(programs.error());
  const int width = rows.columns > 0 ? rows.columns : in.settings.frame.width;
  const int count = rows.use == PathUse::ground
                        ? rows.count
                        : std::min(rows.count, in.settings.frame.height - in.firstRow - rows.first);
  const int atOnce =
      static_cast<int>(std::clamp<int64_t>((rows.sum ? mostPaths : mostPaths / 4) / width, 1, std::max(count, 1)));
  makeRoom(work, static_cast<size_t>(atOnce) * static_cast<size_t>(width), in.paths->list.classes.size() + 1);
  const gl::Buffer frame = gl::Buffer::of(std::vector{frameUniforms(in, number, 1, glm::dvec2(0))}, "frame");
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frame.id());
  bindScene(in, work);
  if (in.ground) in.ground->shares.bind(layout::groundUnit);
  glProgramUniform1ui(programs->miss->id(), layout::pathsClassLocation, layout::missClass);
  layout::PathUniforms uniforms = pathUniforms(in, work, number, rows.share);
  uniforms.offset = glm::vec2(rows.offset + 0.5);
  uniforms.firstColumn = static_cast<uint32_t>(rows.firstColumn), uniforms.columns = static_cast<uint32_t>(width);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
  if (rows.sum) glBindImageTexture(0, rows.sum->id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_RGBA32F);
  for (int row = 0; row < count; row += atOnce)
    traceRows(in, rows.use, work, *programs, uniforms, rows.first + row, std::min(atOnce, count - row));
  for (GLuint unit = 0; unit < layout::materialSlotCount; ++unit) glBindSampler(unit, 0);
  glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT |
                  GL_TEXTURE_UPDATE_BARRIER_BIT);
  return {};
}

FrameInput tracedInput(const FrameInput& in) {
  if (!in.paths->drawn) return in;
  FrameInput traced{in.model, *in.paths->drawn, in.gpu, in.tables, in.view, in.settings};
  traced.measured = in.measured, traced.fittedModel = in.fittedModel, traced.paths = in.paths;
  traced.firstRow = in.firstRow, traced.precise = in.precise, traced.ground = in.ground;
  return traced;
}

gl::Buffer pathUniformBuffer(const FrameInput& in, int firstColumn, int columns) {
  layout::PathUniforms uniforms{};
  setCamera(in, uniforms);
  uniforms.firstColumn = static_cast<uint32_t>(firstColumn), uniforms.columns = static_cast<uint32_t>(columns);
  return gl::Buffer::of(std::vector{uniforms}, "path uniforms");
}

uint64_t tracedRays(const PathWork& work) {
  if (!work.work) return 0;
  std::array<uint32_t, 2> words{};
  glGetNamedBufferSubData(work.work.id(), layout::workRays * sizeof(uint32_t), sizeof words, words.data());
  return words[0] | static_cast<uint64_t>(words[1]) << 32;
}

}  // namespace facet::frame
