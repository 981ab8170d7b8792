#include "selftest/light_probe.hpp"

#include <algorithm>

#include "frame/frame.hpp"
#include "gl/buffer.hpp"
#include "layout.h"
#include "optics/mapping.hpp"

namespace facet::selftest {

Result<std::vector<glm::vec4>> probeLight(const ibl::Tables& tables, const shading::ShaderReader& reader,
                                          const std::vector<shading::Define>& defines, const std::string& body,
                                          std::span<const glm::vec4> inputs, int width, int outputs,
                                          const std::vector<std::string>& chunks, const ProbedDraw& draw) {
  layout::FrameUniforms frame{};
  frame.environmentRotation = glm::vec4(1, 0, 0, 0);
  frame.environmentScale = glm::vec4(tables.radianceScale, tables.radianceScale, 1, 0);
  frame.stored = glm::vec4(1, 1, 65504, 0);
  frame.options = glm::vec4(1, draw.index, draw.draws, draw.seed);
  const gl::Buffer uniforms = gl::Buffer::of(std::vector{frame}, "frame");
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, uniforms.id());
  frame::bindTables(tables);
  std::vector<shading::Define> all = defines;
  all.push_back({"SAMPLED_PIXEL", "uvec2(gl_GlobalInvocationID.x, 0)"});
  return runProbe({chunks, body, width, outputs, all}, inputs, reader);
}

std::vector<glm::vec4> readCubeLevel(const gl::Texture& cube, int level) {
  const auto size = static_cast<size_t>(std::max(1, cube.description().width >> level));
  std::vector<glm::vec4> texels(6 * size * size);
  glGetTextureImage(cube.id(), level, GL_RGBA, GL_FLOAT, static_cast<GLsizei>(texels.size() * sizeof(glm::vec4)),
                    texels.data());
  return texels;
}

glm::dvec3 cubeFlux(const ibl::Tables& tables, int level) {
  const int size = std::max(1, tables.cube.description().width >> level);
  const std::vector<glm::vec4> texels = readCubeLevel(tables.cube, level);
  glm::dvec3 sum(0);
  for (size_t i = 0; i < texels.size(); ++i) {
    const auto s = static_cast<size_t>(size);
    sum +=
        glm::dvec3(texels[i]) * optics::cubeTexelSolidAngle(static_cast<int>(i % s), static_cast<int>(i / s % s), size);
  }
  return sum * static_cast<double>(tables.radianceScale);
}

}  // namespace facet::selftest
