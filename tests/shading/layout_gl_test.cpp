#include <catch2/catch.hpp>
#include <cstddef>

#include "gl/buffer.hpp"
#include "ibl/layers.hpp"
#include "layout.h"
#include "paths.h"
#include "shading/features.hpp"
#include "support/gpu.hpp"

using namespace facet;
using layout::FrameUniforms, layout::Instance, layout::LightUniforms, layout::MaterialUniforms;

namespace {

GLint property(GLuint program, GLenum interface, const std::string& name, GLenum what) {
  const GLuint index = glGetProgramResourceIndex(program, interface, name.c_str());
  INFO(name);
  REQUIRE(index != GL_INVALID_INDEX);
  GLint value = -1;
  glGetProgramResourceiv(program, interface, index, 1, &what, 1, nullptr, &value);
  return value;
}

struct Member {
  std::string name;
  size_t offset;
};

// All of them.
std::vector<Member> materialMembers(const std::string& head) {
  std::vector<Member> members;
  const auto addSlot = [&](const std::string& slot, size_t at) {
    members.push_back({slot + "u", at + offsetof(layout::SlotUniforms, u)});
    members.push_back({slot + "texCoord", at + offsetof(layout::SlotUniforms, texCoord)});
    members.push_back({slot + "v", at + offsetof(layout::SlotUniforms, v)});
    members.push_back({slot + "mostStretch", at + offsetof(layout::SlotUniforms, mostStretch)});
  };
#define MEMBER(name) members.push_back({head + #name, offsetof(MaterialUniforms, name)});
#define COPIED(type, name) MEMBER(name)
#define MADE COPIED
#define UNUSED MEMBER
#include "material_members.inc"
#undef COPIED
#undef MADE
#undef UNUSED
#undef MEMBER
#define TEXTURE_SLOT(slot, ...) addSlot(head + #slot "Slot.", offsetof(MaterialUniforms, slot##Slot));
#include "texture_slots.inc"
#undef TEXTURE_SLOT
  return members;
}

// The mesh program with everything in it that goes together: a measured BRDF takes all other materials' place, and what
// is traced is not drawn.
const gl::Program& fullProgram(shading::ProgramStore& store) {
  shading::VariantKey key;
  for (const shading::FeatureRow& row : shading::featureTable())
    if (row.role != shading::FeatureRole::measured && row.feature != shading::Feature::unlit &&
        row.feature != shading::Feature::paths)
      key.features |= shading::bitOf(row.feature);
  key.diffuse = static_cast<uint8_t>(optics::DiffuseModel::eon);  // which reads a roughness of its own
  const auto program = store.render("passes/mesh.vert.glsl", "passes/mesh.frag.glsl", shading::variantDefines(key));
  REQUIRE(program);
  return **program;
}

}  // namespace

TEST_CASE("Uniform blocks lie in memory as C++ lays them out") {
  shading::ProgramStore store = test::makeProgramStore();
  const GLuint id = fullProgram(store).id();
#define MEMBER(name) Member{"frame." #name, offsetof(FrameUniforms, name)}
  std::vector<Member> members = {MEMBER(clipFromWorld),
                                 MEMBER(worldFromClip),
                                 MEMBER(eye),
                                 MEMBER(towardsEye),
                                 MEMBER(environmentRotation),
                                 MEMBER(environmentScale),
                                 MEMBER(options),
                                 MEMBER(picture),
                                 MEMBER(distanceFromDepth),
                                 MEMBER(stored),
                                 MEMBER(backdrop),
                                 MEMBER(ground),
                                 MEMBER(blurredSun),
                                 MEMBER(blurredSunRadiance),
                                 MEMBER(screen)};
#undef MEMBER
  CHECK(property(id, GL_UNIFORM_BLOCK, "FrameBlock", GL_NUM_ACTIVE_VARIABLES) == GLint(members.size()));
  for (const Member& member : materialMembers("material.")) members.push_back(member);
  for (const Member& member : members) {
    INFO(member.name);
    CHECK(property(id, GL_UNIFORM, member.name, GL_OFFSET) == GLint(member.offset));
  }
  CHECK(property(id, GL_UNIFORM_BLOCK, "MaterialBlock", GL_NUM_ACTIVE_VARIABLES) == GLint(materialMembers("").size()));
  CHECK(property(id, GL_UNIFORM_BLOCK, "FrameBlock", GL_BUFFER_DATA_SIZE) == sizeof(FrameUniforms));
  CHECK(property(id, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_DATA_SIZE) == sizeof(MaterialUniforms));
  CHECK(property(id, GL_UNIFORM_BLOCK, "FrameBlock", GL_BUFFER_BINDING) == layout::frameBinding);
  CHECK(property(id, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_BINDING) == layout::materialBinding);
}

// What a pass does that finds its materials by index, with chunk and textures of its own.
TEST_CASE("Materials lie in a storage buffer as in a uniform block, and are read there by index and by name") {
  const std::string entry = "materials.comp.glsl";
  const auto reader = [&, embedded = shading::shaderReader()](const std::string& path) {
    if (path != entry) return embedded(path);
    return std::optional<std::string>(R"(#include "layout.h"
layout(local_size_x = 1) in;
layout(std430, binding = computeInputBinding) readonly buffer MaterialsBlock { MaterialUniforms materials[]; };
layout(std430, binding = computeOutputBinding) writeonly buffer OutputBlock { vec4 values[]; };
struct Varyings { vec3 normal; vec4 tangent; vec4 color; };
MaterialUniforms material;
#define ABSENT(slot) vec4 slot##Texel(Varyings v) { return vec4(1.0); }
#define TEXTURE_SLOT(name, DEFINE, words, texel) ABSENT(name)
#include "texture_slots.inc"
#undef TEXTURE_SLOT
#define MATERIAL_BY_INDEX
#include "material.glsl"
void main() {
  material = materials[gl_WorkGroupID.x];
  Varyings v = Varyings(vec3(0.0), vec4(0.0), vec4(1.0));
  values[gl_WorkGroupID.x] = vec4(materialMetallicRoughness(v), materialEmission(v).g, material.thicknessSlot.u.y);
})");
  };
  shading::ProgramStore store(reader, {}, "");
  const auto program = store.compute(entry);
  if (!program) FAIL(program.error().problem);
  const GLuint id = (*program)->id();
  for (const Member& member : materialMembers("materials[0].")) {
    INFO(member.name);
    CHECK(property(id, GL_BUFFER_VARIABLE, member.name, GL_OFFSET) == GLint(member.offset));
  }
  CHECK(property(id, GL_BUFFER_VARIABLE, "materials[0].ior", GL_TOP_LEVEL_ARRAY_STRIDE) == sizeof(MaterialUniforms));

  std::vector<MaterialUniforms> materials(3);
  for (int i = 0; i < 3; ++i) {
    MaterialUniforms& m = materials[size_t(i)];
    const auto value = float(i) / 4;
    m.metallicFactor = value, m.perceptualRoughnessFactor = 1 - value;
    m.emission = {-1, 10 + value, -1};
    m.thicknessSlot.u = {-1, 20 + value, -1};
  }
  const gl::Buffer in = gl::Buffer::of(materials, "materials");
  const gl::Buffer out(materials.size() * sizeof(glm::vec4), "values");
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, in.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeOutputBinding, out.id());
  glUseProgram(id);
  glDispatchCompute(3, 1, 1);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  const std::vector<glm::vec4> values = out.read<glm::vec4>(materials.size());
  for (int i = 0; i < 3; ++i) {
    const auto value = float(i) / 4;
    CHECK(values[size_t(i)] == glm::vec4(value, 1 - value, 10 + value, 20 + value));
  }
}

TEST_CASE("Storage blocks lie in memory as C++ lays them out") {
  shading::ProgramStore store = test::makeProgramStore();
  const GLuint id = fullProgram(store).id();
  const Member members[] = {
      {"instances[0].worldFromLocal", offsetof(Instance, worldFromLocal)},
      {"instances[0].normalFromLocal[0]", offsetof(Instance, normalFromLocal)},
      {"lights[0].position", offsetof(LightUniforms, position)},
      {"lights[0].direction", offsetof(LightUniforms, direction)},
      {"lights[0].color", offsetof(LightUniforms, color)},
      {"lights[0].cone", offsetof(LightUniforms, cone)},
      {"lights[0].profile", offsetof(LightUniforms, profile)},
  };
  for (const Member& member : members) {
    INFO(member.name);
    CHECK(property(id, GL_BUFFER_VARIABLE, member.name, GL_OFFSET) == GLint(member.offset));
  }
  const auto stride = [&](const char* name) {
    return property(id, GL_BUFFER_VARIABLE, name, GL_TOP_LEVEL_ARRAY_STRIDE);
  };
  CHECK(stride("instances[0].worldFromLocal") == sizeof(Instance));
  CHECK(stride("lights[0].position") == sizeof(LightUniforms));
  CHECK(property(id, GL_BUFFER_VARIABLE, "instances[0].normalFromLocal[0]", GL_ARRAY_STRIDE) == sizeof(glm::vec4));
  CHECK(property(id, GL_SHADER_STORAGE_BLOCK, "InstanceBlock", GL_BUFFER_BINDING) == layout::instanceBinding);
  CHECK(property(id, GL_SHADER_STORAGE_BLOCK, "LightBlock", GL_BUFFER_BINDING) == layout::lightBinding);
}

TEST_CASE("Attributes and textures have the places of the header") {
  shading::ProgramStore store = test::makeProgramStore();
  const GLuint id = fullProgram(store).id();
  const auto location = [&](const char* name) { return property(id, GL_PROGRAM_INPUT, name, GL_LOCATION); };
  CHECK(location("inPosition") == layout::positionLocation);
  CHECK(location("inNormal") == layout::normalLocation);
  CHECK(location("inTangent") == layout::tangentLocation);
  STATIC_REQUIRE(layout::texCoordSetCount == scene::maxTexCoordSets);
  for (int set = 0; set < layout::texCoordSetCount; ++set)
    CHECK(location(("inTexCoord" + std::to_string(set)).c_str()) == layout::texCoordLocation + set);
  CHECK(location("inColor") == layout::colorLocation);
  const auto unit = [&](const char* name) {
    GLint value = -1;
    glGetUniformiv(id, glGetUniformLocation(id, name), &value);
    return value;
  };
  STATIC_REQUIRE(layout::materialSlotCount == scene::textureSlotCount);
#define TEXTURE_SLOT(name, ...) CHECK(unit(#name "Texture") == int(scene::TextureSlot::name));
#include "texture_slots.inc"
#undef TEXTURE_SLOT
  CHECK(unit("dfgTable") == layout::dfgUnit);
  CHECK(unit("irradianceOverPi") == layout::irradianceUnit);
  CHECK(unit("mirrorLayers") == layout::mirrorLayersUnit);
  CHECK(unit("roughLayers") == layout::roughLayersUnit);
  CHECK(unit("tapsTable") == layout::tapsUnit);
  CHECK(unit("sheenAlbedoTable") == layout::sheenAlbedoUnit);
  CHECK(unit("behindColor") == layout::opaqueFrameUnit);
  CHECK(unit("behindDepth") == layout::opaqueDepthUnit);
}

TEST_CASE("The passes' uniforms and work groups are those of the header") {
  shading::ProgramStore store = test::makeProgramStore();
  struct Row {
    const char *pass, *uniform;
    int location;
  };
  const Row rows[] = {
      {"display.frag", "parameters", layout::displayParametersLocation},
      {"display.frag", "backdrop", layout::displayBackdropLocation},
      {"compare.frag", "parameters", layout::displayParametersLocation},
      {"compare.frag", "backdrop", layout::displayBackdropLocation},
      {"compare.frag", "comparison", layout::comparisonLocation},
      {"gather.frag", "share", layout::gatherShareLocation},
      {"outline.frag", "line", layout::outlineLineLocation},
      {"picture_difference.comp", "parameters", layout::displayParametersLocation},
      {"picture_difference.comp", "backdrop", layout::displayBackdropLocation},
      {"picture_difference.comp", "rows", layout::comparedRowsLocation},
      {"picture_error.comp", "parameters", layout::displayParametersLocation},
      {"picture_error.comp", "backdrop", layout::displayBackdropLocation},
      {"picture_error.comp", "parts", layout::errorPartsLocation},
      {"contrast_add.comp", "parts", layout::errorPartsLocation},
      {"error_view.frag", "parameters", layout::displayParametersLocation},
      {"error_view.frag", "backdrop", layout::displayBackdropLocation},
      {"error_view.frag", "parts", layout::errorPartsLocation},
      {"error_view.frag", "stops", layout::errorStopsLocation},
      {"behind_level.comp", "fineLevel", layout::behindFineLevelLocation},
      {"equirect_to_cube.comp", "taps", layout::cubeTapsLocation},
      {"equirect_to_cube.comp", "steepTaps", layout::cubeSteepTapsLocation},
      {"equirect_to_cube.comp", "steep", layout::cubeSteepLocation},
      {"equirect_to_cube.comp", "firstFace", layout::cubeFirstFaceLocation},
      {"blur.comp", "firstFace", layout::blurFirstFaceLocation},
      {"prefilter.comp", "cube", layout::layerCubeLocation},
      {"prefilter.comp", "firstFace", layout::layerFirstFaceLocation},
      {"mix.comp", "cube", layout::layerCubeLocation},
      {"mix.comp", "firstFace", layout::layerFirstFaceLocation},
      {"mix.comp", "count", layout::mixCountLocation},
      {"mix.comp", "weights[0]", layout::mixWeightsLocation},
      {"prefilter_cut.comp", "cube", layout::layerCubeLocation},
      {"prefilter_cut.comp", "face", layout::layerFirstFaceLocation},
      {"prefilter_cut.comp", "firstRow", layout::cutFirstRowLocation},
      {"prefilter_cut.comp", "treeSize", layout::cutTreeSizeLocation},
      {"prefilter_cut.comp", "parameters", layout::cutParametersLocation},
      {"cut_nodes.comp", "size", layout::nodesSizeLocation},
      {"cut_nodes.comp", "offset", layout::nodesOffsetLocation},
      {"cut_nodes.comp", "fineOffset", layout::nodesFineOffsetLocation},
      {"cube_to_cells.comp", "cellTexels", layout::cellTexelsLocation},
      {"zonal_sum.comp", "alpha2", layout::sumAlpha2Location},
      {"irradiance_riemann.comp", "stepAngle", layout::riemannStepLocation},
      {"dfg.comp", "radii", layout::dfgRadiiLocation},
      {"dfg_importance.comp", "samples", layout::dfgSamplesLocation},
      {"sheen_albedo.comp", "heights", layout::sheenHeightsLocation},
  };
  for (const Row& row : rows) {
    const std::string pass = row.pass, path = "passes/" + pass + ".glsl";
    const bool compute = pass.ends_with(".comp");
    const auto program = compute ? store.compute(path) : store.render("passes/fullscreen.vert.glsl", path);
    INFO(pass << " " << row.uniform);
    if (!program) FAIL(program.error().problem);
    CHECK(property((*program)->id(), GL_UNIFORM, row.uniform, GL_LOCATION) == row.location);
    if (!compute) continue;
    GLint size[3] = {};
    glGetProgramiv((*program)->id(), GL_COMPUTE_WORK_GROUP_SIZE, size);
    CHECK(size[0] == layout::groupSize);
    CHECK(size[1] == layout::groupSize);
  }
}

TEST_CASE("Paths lie in memory as C++ lays them out") {
  shading::ProgramStore store = test::makeProgramStore();
  const auto program = store.compute("passes/paths_begin.comp.glsl");
  REQUIRE(program);
  const GLuint id = (*program)->id();
#define MEMBER(name) \
  Member { "pathsShared." #name, offsetof(layout::PathUniforms, name) }
  for (const Member& member : {MEMBER(paths), MEMBER(classes), MEMBER(number), MEMBER(mostVertices), MEMBER(firstRow),
                               MEMBER(rows), MEMBER(lights), MEMBER(share), MEMBER(glowing), MEMBER(perGlow)}) {
    INFO(member.name);
    CHECK(property(id, GL_UNIFORM, member.name, GL_OFFSET) == GLint(member.offset));
  }
#undef MEMBER
  CHECK(property(id, GL_UNIFORM, "pathsShared.origins[0]", GL_OFFSET) == 0);
  CHECK(property(id, GL_UNIFORM, "pathsShared.directions[0]", GL_OFFSET) ==
        GLint(offsetof(layout::PathUniforms, directions)));
  CHECK(property(id, GL_UNIFORM_BLOCK, "PathUniformsBlock", GL_BUFFER_DATA_SIZE) == sizeof(layout::PathUniforms));
  CHECK(property(id, GL_UNIFORM_BLOCK, "PathUniformsBlock", GL_BUFFER_BINDING) == layout::pathsBinding);
#define MEMBER(name) \
  Member { "paths[0]." #name, offsetof(layout::PathState, name) }
  for (const Member& member :
       {MEMBER(origin), MEMBER(direction), MEMBER(throughput), MEMBER(radiance), MEMBER(lightOrigin),
        MEMBER(lightDirection), MEMBER(outerMedia), MEMBER(lightRadiance), MEMBER(triangle), MEMBER(instance),
        MEMBER(distance), MEMBER(vertices), MEMBER(weights), MEMBER(pixel), MEMBER(media)}) {
    INFO(member.name);
    CHECK(property(id, GL_BUFFER_VARIABLE, member.name, GL_OFFSET) == GLint(member.offset));
  }
#undef MEMBER
  CHECK(property(id, GL_BUFFER_VARIABLE, "paths[0].origin", GL_TOP_LEVEL_ARRAY_STRIDE) == sizeof(layout::PathState));
}
