#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "gl/context.hpp"

namespace facet::gl {

namespace {

std::string glfwProblem() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

GLFWwindow* createWindow(int width, int height, const std::string& title, int minor, bool debug) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, minor);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, debug ? GLFW_TRUE : GLFW_FALSE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the frame has its own targets; the window only shows the result
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "facet");  // by which a desktop finds icon and name
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "facet");
#ifdef GLFW_WAYLAND_APP_ID
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "facet");
#endif
  return glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
}

}  // namespace

WindowContext::WindowContext(WindowContext&& other) noexcept
    : window_(std::exchange(other.window_, nullptr)), info_(std::move(other.info_)) {}

WindowContext& WindowContext::operator=(WindowContext&& other) noexcept {
  std::swap(window_, other.window_);
  std::swap(info_, other.info_);
  return *this;
}

WindowContext::~WindowContext() {
  if (window_ == nullptr) return;
  glfwDestroyWindow(window_);
  glfwTerminate();
}

Result<WindowContext> WindowContext::create(int width, int height, const std::string& title, bool debug) {
  debug = debug || debugBuild;
  if (!glfwInit())
    return fail("window", "", "no display could be opened: " + glfwProblem(),
                "set DISPLAY or WAYLAND_DISPLAY, or use 'facet render', which needs no display");
  WindowContext out;
  out.window_ = createWindow(width, height, title, 6, debug);
  if (out.window_ == nullptr) out.window_ = createWindow(width, height, title, 5, debug);
  if (out.window_ == nullptr) {
    const std::string problem = glfwProblem();
    glfwTerminate();
    return fail("window", "", "OpenGL 4.6 and 4.5 core are refused: " + problem, "update the graphics driver");
  }
  glfwMakeContextCurrent(out.window_);
  Result<ContextInfo> info = adoptCurrentContext("GLFW window", debug);
  if (!info) return tl::unexpected(info.error());
  out.info_ = *info;
  return out;
}

}  // namespace facet::gl
