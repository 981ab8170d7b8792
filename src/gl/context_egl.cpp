#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <cstring>
#include <vector>

#include "gl/context.hpp"

namespace facet::gl {

struct HeadlessContext::Egl {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  bool among = false;

  ~Egl() {
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
    if (!among) eglTerminate(display);
  }
};

namespace {

struct Candidate {
  const char* platform;
  EGLDisplay display;
};

bool hasExtension(const char* list, const char* name) { return list && std::strstr(list, name) != nullptr; }

// In order of preference: Mesa's surfaceless platform needs no display server and no device file, a device display no
// display server.
std::vector<Candidate> candidates() {
  std::vector<Candidate> out;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (hasExtension(client, "EGL_EXT_platform_base")) {
    if (hasExtension(client, "EGL_MESA_platform_surfaceless"))
      out.push_back(
          {"EGL surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
    if (hasExtension(client, "EGL_EXT_platform_device") && hasExtension(client, "EGL_EXT_device_enumeration")) {
      EGLDeviceEXT devices[16];
      EGLint count = 0;
      if (eglQueryDevicesEXT(16, devices, &count))
        for (EGLint i = 0; i < count; ++i)
          out.push_back({"EGL device", eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr)});
    }
  }
  out.push_back({"EGL default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
  return out;
}

// tellsReset: a driver that is reset says so, and what follows does nothing, instead of whatever it would do.
EGLContext createContext(EGLDisplay display, int minor, bool debug, bool tellsReset) {
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               4,
                               EGL_CONTEXT_MINOR_VERSION,
                               minor,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_CONTEXT_OPENGL_DEBUG,
                               debug ? EGL_TRUE : EGL_FALSE,
                               tellsReset ? EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY : EGL_NONE,
                               EGL_LOSE_CONTEXT_ON_RESET,
                               EGL_NONE};
  return eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
}

std::string hex(EGLint code) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%04X", static_cast<unsigned>(code));
  return text;
}

}  // namespace

HeadlessContext::HeadlessContext() : egl_(std::make_unique<Egl>()) {}
HeadlessContext::HeadlessContext(HeadlessContext&&) noexcept = default;
HeadlessContext& HeadlessContext::operator=(HeadlessContext&&) noexcept = default;
HeadlessContext::~HeadlessContext() = default;

Result<HeadlessContext> HeadlessContext::create(bool debug, bool among) {
  debug = debug || debugBuild;
  std::string tried;
  for (const Candidate& candidate : candidates()) {
    HeadlessContext out;
    out.egl_->among = among;
    const auto note = [&](const std::string& text) {
      tried += (tried.empty() ? "" : ", ") + std::string(candidate.platform) + " " + text;
    };
    if (candidate.display == EGL_NO_DISPLAY || !eglInitialize(candidate.display, nullptr, nullptr)) {
      note("does not start");
      continue;
    }
    out.egl_->display = candidate.display;
    const char* extensions = eglQueryString(candidate.display, EGL_EXTENSIONS);
    if (!eglBindAPI(EGL_OPENGL_API) || !hasExtension(extensions, "EGL_KHR_surfaceless_context") ||
        !hasExtension(extensions, "EGL_KHR_no_config_context")) {
      note("has no OpenGL context without a surface");
      continue;
    }
    const bool robust = hasExtension(extensions, "EGL_EXT_create_context_robustness");
    for (const bool tellsReset : {true, false})
      for (const int minor : {6, 5})
        if (out.egl_->context == EGL_NO_CONTEXT && (robust || !tellsReset))
          out.egl_->context = createContext(candidate.display, minor, debug, tellsReset);
    if (out.egl_->context == EGL_NO_CONTEXT ||
        !eglMakeCurrent(candidate.display, EGL_NO_SURFACE, EGL_NO_SURFACE, out.egl_->context)) {
      note("refuses OpenGL 4.6 and 4.5 core (EGL error " + hex(eglGetError()) + ")");
      continue;
    }
    Result<ContextInfo> info = adoptCurrentContext(candidate.platform, debug);
    if (!info) {
      note(info.error().place + " " + info.error().problem);
      continue;
    }
    out.info_ = *info;
    return out;
  }
  return fail("OpenGL", "", "no headless context could be made: " + tried,
              "install a driver with OpenGL 4.5 or later (Debian: libegl1 and libgl1-mesa-dri)");
}

}  // namespace facet::gl
