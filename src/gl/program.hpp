#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "gl/handle.hpp"

namespace facet::gl {

inline void destroyProgram(GLuint id) { glDeleteProgram(id); }

struct ShaderSource {
  GLenum stage = GL_VERTEX_SHADER;
  std::string text;
};

const char* stageName(GLenum stage);  // "fragment shader"

struct ProgramBinary {
  GLenum format = 0;
  std::vector<uint8_t> bytes;
};

class Program : public Handle<destroyProgram> {
 public:
  Program() = default;

  // Compiles and links. The error's problem is the driver's log, its place the stage (stageName).
  static Result<Program> build(const std::vector<ShaderSource>& stages, std::string_view label);
  // An empty Program where the driver no longer takes the binary.
  static Program fromBinary(const ProgramBinary& binary, std::string_view label);
  ProgramBinary binary() const;  // empty where the driver offers no format

  // Explicit uniform locations (shaders/layout.h); DSA, no binding needed.
  void set(GLint location, float v) const { glProgramUniform1f(id(), location, v); }
  void set(GLint location, int v) const { glProgramUniform1i(id(), location, v); }
  void set(GLint location, const glm::vec4& v) const { glProgramUniform4fv(id(), location, 1, &v.x); }
  void set(GLint location, const glm::mat4& v) const {
    glProgramUniformMatrix4fv(id(), location, 1, GL_FALSE, &v[0].x);
  }
};

}  // namespace facet::gl
