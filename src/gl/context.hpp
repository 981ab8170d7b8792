#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/origin.hpp"

struct GLFWwindow;

namespace facet::gl {

// Debug builds ask for a debug context always, others on request.
#ifdef NDEBUG
inline constexpr bool debugBuild = false;
#else
inline constexpr bool debugBuild = true;
#endif

// What the current context is and may do.
struct ContextInfo {
  std::string platform;  // "EGL surfaceless", "EGL device", "EGL default display", "GLFW window"
  std::string vendor, renderer, version;
  int major = 0, minor = 0;
  int maxSamples = 1;
  float maxAnisotropy = 1;
  bool programBinaries = false;
};

// Of what is made now by this process on it.
Origin originOn(const ContextInfo& info);

// 4.6 core, or 4.5 core with the extensions in use; otherwise the error names what is missing.
// Call once with the new context current: sets the state that the whole program relies on (clip control 0..1, seamless
// cube maps, pixel alignment 1) and, with debug, routes KHR_debug messages into the log.
Result<ContextInfo> adoptCurrentContext(const std::string& platform, bool debug);

// OpenGL goes on after an error and tells of it when it is asked: whether since the last call the driver lacked memory
// or lost the context (the GPU was reset), so that what it drew or keeps is not to be used. `doing`: "the
// picture". Other errors are told as a warning.
Result<void> checkDriver(std::string_view doing);
// Such an error.
bool isOfDriver(const Error& error);

// The current context's driver draws on the CPU, as far as its name tells.
bool drawsBySoftware();

// Number of KHR_debug messages of type error since the process began; tests demand 0.
int debugErrorCount();

// A context without a window: EGL surfaceless, else EGL device, else EGL default display. Current on the creating
// thread. among: others in this process may use EGL, whose display stays open for them.
class HeadlessContext {
 public:
  static Result<HeadlessContext> create(bool debug, bool among = false);
  HeadlessContext(HeadlessContext&&) noexcept;
  HeadlessContext& operator=(HeadlessContext&&) noexcept;
  ~HeadlessContext();
  const ContextInfo& info() const { return info_; }

 private:
  HeadlessContext();
  struct Egl;
  std::unique_ptr<Egl> egl_;
  ContextInfo info_;
};

// A GLFW window with its context, current on the creating thread. One at a time.
class WindowContext {
 public:
  static Result<WindowContext> create(int width, int height, const std::string& title, bool debug);
  WindowContext(WindowContext&&) noexcept;
  WindowContext& operator=(WindowContext&&) noexcept;
  ~WindowContext();
  GLFWwindow* window() const { return window_; }
  const ContextInfo& info() const { return info_; }

 private:
  WindowContext() = default;
  GLFWwindow* window_ = nullptr;
  ContextInfo info_;
};

}  // namespace facet::gl
