#include "gl/context.hpp"

#include <epoxy/gl.h>

#include <algorithm>
#include <atomic>
#include <cstdio>

#include "base/log.hpp"

namespace facet::gl {

namespace {

std::atomic<int> debugErrors = 0;

void onDebugMessage(GLenum source, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* message,
                    const void*) {
  const std::string text = "OpenGL: " + std::string(message, static_cast<size_t>(length));
  if (source == GL_DEBUG_SOURCE_SHADER_COMPILER) {
    log::debug(text);  // Program::build reports the whole log
  } else if (type == GL_DEBUG_TYPE_ERROR) {
    ++debugErrors;
    log::error(text);
  } else if (severity == GL_DEBUG_SEVERITY_HIGH || severity == GL_DEBUG_SEVERITY_MEDIUM) {
    log::warning(text);
  } else {
    log::debug(text);
  }
}

std::string glString(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

// Extensions that 4.6 core includes and that the program uses; a 4.5 context has to bring them.
struct NeededExtension {
  const char* names[2];  // any one of these
};
constexpr NeededExtension neededExtensions[] = {
    {{"GL_ARB_shader_draw_parameters", nullptr}},
    {{"GL_ARB_texture_filter_anisotropic", "GL_EXT_texture_filter_anisotropic"}},
};

std::string missingExtensions() {
  std::string missing;
  for (const NeededExtension& needed : neededExtensions) {
    bool present = false;
    for (const char* name : needed.names) present = present || (name && epoxy_has_gl_extension(name));
    if (!present) missing += (missing.empty() ? "" : ", ") + std::string(needed.names[0]);
  }
  return missing;
}

constexpr const char* driver = "OpenGL";  // what errors of it name in place of a file

}  // namespace

Result<void> checkDriver(std::string_view doing) {
  bool memory = false, lost = glGetGraphicsResetStatus() != GL_NO_ERROR;
  GLenum other = GL_NO_ERROR;
  // A lost context may say so for ever.
  for (int i = 0; i < 8; ++i) {
    const GLenum error = glGetError();
    if (error == GL_NO_ERROR) break;
    memory = memory || error == GL_OUT_OF_MEMORY;
    lost = lost || error == GL_CONTEXT_LOST;
    if (error != GL_OUT_OF_MEMORY && error != GL_CONTEXT_LOST) other = error;
  }
  if (lost)
    return fail(driver, "", "the driver was reset while it worked on " + std::string(doing),
                "run facet again; if that happens often, update the graphics driver");
  if (memory)
    return fail(driver, "", "the driver's memory does not suffice for " + std::string(doing),
                "close other programs, draw a smaller picture, or take a smaller model");
  if (other != GL_NO_ERROR) {
    char code[16];
    std::snprintf(code, sizeof code, "0x%04X", other);
    log::warning("OpenGL reports the error " + std::string(code) + " after " + std::string(doing) +
                 "; the picture may be wrong.");
  }
  return {};
}

bool isOfDriver(const Error& error) { return error.file == driver; }

int debugErrorCount() { return debugErrors; }

Result<ContextInfo> adoptCurrentContext(const std::string& platform, bool debug) {
  ContextInfo info;
  info.platform = platform;
  info.vendor = glString(GL_VENDOR);
  info.renderer = glString(GL_RENDERER);
  info.version = glString(GL_VERSION);
  glGetIntegerv(GL_MAJOR_VERSION, &info.major);
  glGetIntegerv(GL_MINOR_VERSION, &info.minor);
  if (info.major < 4 || (info.major == 4 && info.minor < 5))
    return fail(platform, info.renderer, "offers OpenGL " + info.version + ", and 4.5 core is the least that works",
                "update the graphics driver");
  if (info.minor < 6) {
    const std::string missing = missingExtensions();
    if (!missing.empty())
      return fail(platform, info.renderer, "offers OpenGL " + info.version + " without " + missing,
                  "update the graphics driver");
  }
  if (debug) {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(onDebugMessage, nullptr);
  }
  GLint formats = 0;
  glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
  info.programBinaries = formats > 0;
  glGetIntegerv(GL_MAX_SAMPLES, &info.maxSamples);
  glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &info.maxAnisotropy);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const std::string found = platform + ": OpenGL " + info.version + ", " + info.renderer;
  if (info.minor < 6)
    log::info(found + ": 4.5 with the extensions in use, instead of 4.6");
  else
    log::debug(found);
  return info;
}

Origin originOn(const ContextInfo& info) {
  Origin origin = originOfProcess();
  origin.renderer = info.renderer, origin.driver = info.version;
  return origin;
}

bool drawsBySoftware() {
  const std::string renderer = glString(GL_RENDERER);
  constexpr const char* names[] = {"llvmpipe", "softpipe", "Software Rasterizer", "SwiftShader", "Basic Render", "SWR"};
  return std::ranges::any_of(names, [&](const char* name) { return renderer.find(name) != std::string::npos; });
}

}  // namespace facet::gl
