#include "report/light_probe.hpp"

#include "frame/frame.hpp"
#include "gl/buffer.hpp"
#include "layout.h"

namespace facet::report {

Result<std::vector<glm::vec4>> probeLight(const ibl::Tables& tables, const shading::ShaderReader& reader,
                                          const std::vector<shading::Define>& defines, const std::string& body,
                                          std::span<const glm::vec4> inputs, int width, int outputs) {
  layout::FrameUniforms frame{};
  frame.environmentRotation = glm::vec4(1, 0, 0, 0);
  frame.environmentScale = glm::vec4(tables.radianceScale, tables.radianceScale, 0, 0);
  frame.options = glm::vec4(1, 0, 1, 0);
  const gl::Buffer uniforms = gl::Buffer::of(std::vector{frame}, "frame");
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, uniforms.id());
  frame::bindTables(tables);
  return runProbe({{"image_light.glsl", "dfg_table.glsl"}, body, width, outputs, defines}, inputs, reader);
}

}  // namespace facet::report
