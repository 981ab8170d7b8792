#include "gl/program.hpp"

namespace facet::gl {

namespace {

void destroyShader(GLuint id) { glDeleteShader(id); }
using Shader = Handle<destroyShader>;

std::string shaderLog(GLuint id) {
  GLint length = 0;
  glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(length), '\0');
  if (length > 0) glGetShaderInfoLog(id, length, &length, log.data());
  log.resize(static_cast<size_t>(length));
  return log;
}

std::string programLog(GLuint id) {
  GLint length = 0;
  glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<size_t>(length), '\0');
  if (length > 0) glGetProgramInfoLog(id, length, &length, log.data());
  log.resize(static_cast<size_t>(length));
  return log;
}

// Labels name entry points and defines; OpenGL promises room for 255 characters.
void setLabel(GLuint program, std::string_view label) {
  const std::string_view start = label.substr(0, 255);
  glObjectLabel(GL_PROGRAM, program, static_cast<GLsizei>(start.size()), start.data());
}

}  // namespace

const char* stageName(GLenum stage) {
  switch (stage) {
    case GL_VERTEX_SHADER:
      return "vertex shader";
    case GL_FRAGMENT_SHADER:
      return "fragment shader";
    default:
      return "compute shader";
  }
}

Result<Program> Program::build(const std::vector<ShaderSource>& stages, std::string_view label) {
  std::vector<Shader> shaders;
  for (const ShaderSource& stage : stages) {
    const Shader& shader = shaders.emplace_back(glCreateShader(stage.stage));
    const char* text = stage.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint ok = GL_FALSE;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &ok);
    if (!ok) return fail(std::string(label), stageName(stage.stage), shaderLog(shader.id()));
  }
  Program program;
  static_cast<Handle&>(program) = Handle(glCreateProgram());
  glProgramParameteri(program.id(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
  for (const Shader& shader : shaders) glAttachShader(program.id(), shader.id());
  glLinkProgram(program.id());
  for (const Shader& shader : shaders) glDetachShader(program.id(), shader.id());
  GLint ok = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
  if (!ok) return fail(std::string(label), "link", programLog(program.id()));
  setLabel(program.id(), label);
  return program;
}

Program Program::fromBinary(const ProgramBinary& binary, std::string_view label) {
  Program program;
  static_cast<Handle&>(program) = Handle(glCreateProgram());
  glProgramBinary(program.id(), binary.format, binary.bytes.data(), static_cast<GLsizei>(binary.bytes.size()));
  GLint ok = GL_FALSE;
  glGetProgramiv(program.id(), GL_LINK_STATUS, &ok);
  if (!ok) return {};
  setLabel(program.id(), label);
  return program;
}

ProgramBinary Program::binary() const {
  GLint length = 0;
  glGetProgramiv(id(), GL_PROGRAM_BINARY_LENGTH, &length);
  ProgramBinary out;
  if (length <= 0) return out;
  out.bytes.resize(static_cast<size_t>(length));
  GLsizei written = 0;
  glGetProgramBinary(id(), length, &written, &out.format, out.bytes.data());
  out.bytes.resize(static_cast<size_t>(written));
  return out;
}

}  // namespace facet::gl
