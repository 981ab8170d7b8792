#include <catch2/catch.hpp>
#include <cstddef>

#include "ibl/layers.hpp"
#include "layout.h"
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
  const char* name;
  size_t offset;
};

// The mesh program with everything in it that goes together: a measured BRDF takes all other materials' place.
const gl::Program& fullProgram(shading::ProgramStore& store) {
  shading::VariantKey key;
  const auto table = shading::featureTable();
  for (size_t i = 0; i < table.size(); ++i)
    if (const std::string define = table[i].define; define != "UNLIT" && define != "MERL_BRDF" &&
                                                    define != "UTIA_BRDF" && define != "MEASURED_NEAREST" &&
                                                    define != "FITTED_BRDF")
      key.features |= uint64_t{1} << i;
  const auto program = store.render("passes/mesh.vert.glsl", "passes/mesh.frag.glsl", shading::variantDefines(key));
  REQUIRE(program);
  return **program;
}

}  // namespace

TEST_CASE("Uniform blocks lie in memory as C++ lays them out") {
  shading::ProgramStore store = test::makeProgramStore();
  const GLuint id = fullProgram(store).id();
  const Member members[] = {
      {"frame.clipFromWorld", offsetof(FrameUniforms, clipFromWorld)},
      {"frame.worldFromClip", offsetof(FrameUniforms, worldFromClip)},
      {"frame.eye", offsetof(FrameUniforms, eye)},
      {"frame.towardsEye", offsetof(FrameUniforms, towardsEye)},
      {"frame.environmentRotation", offsetof(FrameUniforms, environmentRotation)},
      {"frame.environmentScale", offsetof(FrameUniforms, environmentScale)},
      {"frame.options", offsetof(FrameUniforms, options)},
      {"material.baseColorFactor", offsetof(MaterialUniforms, baseColorFactor)},
      {"material.emissiveFactor", offsetof(MaterialUniforms, emissiveFactor)},
      {"material.factors", offsetof(MaterialUniforms, factors)},
      {"material.scales", offsetof(MaterialUniforms, scales)},
      {"material.specularGlossiness", offsetof(MaterialUniforms, specularGlossiness)},
      {"material.texCoordSets[0]", offsetof(MaterialUniforms, texCoordSets)},
      {"material.texCoordRows[0]", offsetof(MaterialUniforms, texCoordRows)},
  };
  for (const Member& member : members) {
    INFO(member.name);
    CHECK(property(id, GL_UNIFORM, member.name, GL_OFFSET) == GLint(member.offset));
  }
  CHECK(property(id, GL_UNIFORM, "material.texCoordSets[0]", GL_ARRAY_STRIDE) == sizeof(glm::vec4));
  CHECK(property(id, GL_UNIFORM, "material.texCoordRows[0]", GL_ARRAY_SIZE) == 38);
  CHECK(property(id, GL_UNIFORM_BLOCK, "FrameBlock", GL_BUFFER_DATA_SIZE) == sizeof(FrameUniforms));
  CHECK(property(id, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_DATA_SIZE) == sizeof(MaterialUniforms));
  CHECK(property(id, GL_UNIFORM_BLOCK, "FrameBlock", GL_BUFFER_BINDING) == layout::frameBinding);
  CHECK(property(id, GL_UNIFORM_BLOCK, "MaterialBlock", GL_BUFFER_BINDING) == layout::materialBinding);
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
  CHECK(unit("baseColorTexture") == int(scene::TextureSlot::baseColor));
  CHECK(unit("metallicRoughnessTexture") == int(scene::TextureSlot::metallicRoughness));
  CHECK(unit("normalTexture") == int(scene::TextureSlot::normal));
  CHECK(unit("occlusionTexture") == int(scene::TextureSlot::occlusion));
  CHECK(unit("emissiveTexture") == int(scene::TextureSlot::emissive));
  CHECK(unit("dfgTable") == layout::dfgUnit);
  CHECK(unit("irradianceOverPi") == layout::irradianceUnit);
  CHECK(unit("mirrorLayers") == layout::mirrorLayersUnit);
  CHECK(unit("roughLayers") == layout::roughLayersUnit);
}
