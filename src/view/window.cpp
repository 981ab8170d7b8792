#include "view/window.hpp"

#include <epoxy/gl.h>
#include <imgui.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/log.hpp"
#include "gl/context.hpp"
#include "io/measured.hpp"
#include "view/browser.hpp"
#include "view/camera_control.hpp"
#include "view/controls.hpp"
#include "view/follow.hpp"
#include "view/input.hpp"
#include "view/inspector.hpp"
#include "view/layout.hpp"
#include "view/panel.hpp"
#include "view/playback.hpp"
#include "view/screenshot.hpp"
#include "view/shader_watch.hpp"
#include "view/style.hpp"
#include "view/viewport.hpp"

namespace facet::view {

namespace {

// Dear ImGui's context and backends, which end in the reverse order.
struct ImGuiSession {
  std::string layoutFile;  // read by the first frame, written now and then and at the end

  ImGuiSession(GLFWwindow* window, float scale, ViewerState& state) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    if (const std::filesystem::path folder = userConfigFolder(); !folder.empty()) {
      std::error_code ignored;
      std::filesystem::create_directories(folder, ignored);
      layoutFile = (folder / "imgui.ini").string();
    }
    ImGui::GetIO().IniFilename = layoutFile.empty() ? nullptr : layoutFile.c_str();
    rememberLayout(state);
    applyStyle(state.preferences.theme, scale);
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
  }
  ~ImGuiSession() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
  }
  ImGuiSession(const ImGuiSession&) = delete;
  ImGuiSession& operator=(const ImGuiSession&) = delete;
};

// After something has happened ImGui needs a few frames until hovering, clicks and sizes have settled.
constexpr int settlingFrames = 3;
constexpr double busyWait = 0.05, timerWait = 0.02, stepWait = 0.004, idleWait = 10;  // seconds

// How well the window answers while something loads.
struct LoadTime {
  bool running = false;
  std::chrono::steady_clock::time_point frame;  // the last one on the screen
  double longestGap = 0;                        // milliseconds between two
};

// The loop's own data; what it shows is in ViewerState and Viewport.
struct Loop {
  GLFWwindow* window = nullptr;
  Input input;
  int framesToDraw = settlingFrames;
  std::chrono::steady_clock::time_point last = std::chrono::steady_clock::now();
  ShaderWatch shaders;
  Followed followed;
  Browser browser;
  std::string model;  // what the loader reads
  std::string noted;  // model and environment that the browser was told last
  LoadTime load;
  float scale = 1;  // that the style has
  Theme theme = Theme::dark;
};

// The user's, else the monitor's.
float contentScale(GLFWwindow* window, const Preferences& preferences) {
  if (preferences.scale > 0) return preferences.scale;
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::clamp(std::max(x, y), 1.0f, 4.0f);
}

std::filesystem::path preferencesFile() {
  const std::filesystem::path folder = userConfigFolder();
  return folder.empty() ? folder : folder / "settings.json";
}

// Theme and scale may have changed, the latter because the window has been moved to another monitor, too.
void followStyle(Loop& loop, ViewerState& state) {
  const float scale = contentScale(loop.window, state.preferences);
  if (scale == loop.scale && state.preferences.theme == loop.theme) return;
  applyStyle(state.preferences.theme, scale);
  ImGui_ImplOpenGL3_DestroyFontsTexture();  // made anew by the next frame
  loop.scale = scale;
  loop.theme = state.preferences.theme;
  loop.framesToDraw = settlingFrames;
}

void keepPreferences(const ViewerState& state, const Preferences& before) {
  const std::filesystem::path file = preferencesFile();
  if (file.empty() || state.preferences == before) return;
  if (const Result<void> written = writePreferences(file, state.preferences); !written)
    log::warning(describe(written.error()));
}

bool isDown(GLFWwindow* window, int key) { return glfwGetKey(window, key) == GLFW_PRESS; }

glm::dvec3 flightDirection(const Loop& loop) {
  if (loop.input.keyboardTaken || isDown(loop.window, GLFW_KEY_LEFT_CONTROL)) return glm::dvec3(0);
  const auto axis = [&](int plus, int minus) { return isDown(loop.window, plus) - isDown(loop.window, minus); };
  return {axis(GLFW_KEY_D, GLFW_KEY_A), axis(GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN), axis(GLFW_KEY_W, GLFW_KEY_S)};
}

// Sleeps until there is something to do; seconds since the last time, at most a quarter, for flight.
double waitForEvents(Loop& loop, const Loader& loader, const Viewport& viewport, const ViewerState& state) {
  const bool watches = !loop.shaders.folder.empty() || !loop.followed.modelFiles.files.empty() ||
                       !loop.followed.environmentFiles.files.empty() || !loop.followed.measuredFiles.files.empty();
  const double idle = watches ? fileWatchSeconds : idleWait;
  if (loop.framesToDraw > 0 || flightDirection(loop) != glm::dvec3(0))
    glfwPollEvents();
  else
    glfwWaitEventsTimeout(atWork(viewport, state) || viewport.comingUp || loader.measured.running() ? stepWait
                          : loader.running()                                                        ? busyWait
                          : viewport.clock.waiting()                                                ? timerWait
                                                                                                    : idle);
  const auto now = std::chrono::steady_clock::now();
  const double seconds = std::chrono::duration<double>(now - loop.last).count();
  loop.last = now;
  return std::min(seconds, 0.25);
}

void followFramebuffer(GLFWwindow* window, frame::PictureSettings& settings) {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  if (width < 1 || height < 1) return;  // minimised
  settings.width = std::min(width, 16384);
  settings.height = std::min(height, 16384);
}

// The display picture has been through the sRGB curve already: it is copied as it is.
void copyToWindow(const frame::Targets& targets) {
  glDisable(GL_FRAMEBUFFER_SRGB);
  glBlitNamedFramebuffer(targets.shown.id(), 0, 0, 0, targets.width, targets.height, 0, 0, targets.width,
                         targets.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

// A picture of the window's size, blended by its straight alpha.
void layOver(const gl::Texture& picture) {
  const auto name = static_cast<uintptr_t>(picture.id());
  ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(name), {0, 0}, ImGui::GetIO().DisplaySize,
                                           {0, 1}, {1, 0});
}

// Behind a transparent picture: checks, over which ImGui blends the display picture's straight alpha.
void drawOverChecks(const frame::Targets& targets) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  constexpr float step = 16;
  draw.AddRectFilled({0, 0}, size, IM_COL32(92, 92, 92, 255));
  for (int y = 0; static_cast<float>(y) * step < size.y; ++y)
    for (int x = y % 2; static_cast<float>(x) * step < size.x; x += 2) {
      const ImVec2 at(static_cast<float>(x) * step, static_cast<float>(y) * step);
      draw.AddRectFilled(at, {at.x + step, at.y + step}, IM_COL32(112, 112, 112, 255));
    }
  layOver(targets.display);
}

void drawWindow(Loop& loop, const Viewport& viewport, const ViewerState& state) {
  const bool transparent = state.settings.background == frame::Background::transparent;
  if (viewport.targets.shown && transparent) drawOverChecks(viewport.targets);
  if (viewport.outline.shown) layOver(viewport.outline.line);
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(loop.window, &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  constexpr float grey[] = {0.1f, 0.1f, 0.1f, 1};
  glClearNamedFramebufferfv(0, GL_COLOR, 0, grey);
  if (viewport.targets.shown && !transparent) copyToWindow(viewport.targets);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(loop.window);
}

void applyPanel(const PanelResult& panel, Viewport& viewport, ViewerState& state, Input& input, Actions& actions) {
  const std::optional<scene::View> view = currentView(viewport, state);
  const double aspect = static_cast<double>(state.settings.width) / state.settings.height;
  if ((panel.leaveFileCamera || panel.frameAll) && view) freeCamera(state, *view);
  if (panel.viewFrom && view) freeCamera(state, *view), state.camera = seenFrom(state.camera, *panel.viewFrom);
  if (panel.describeMaterial && viewport.scene)
    state.inspection.materialDetails = materialDetails(viewport, state.selection.material);
  actions.frameSelection |= panel.frameSelection;
  if (panel.frameAll) state.camera = framedAll(state.camera, state.shown.bounds, aspect);
  if (panel.resetCamera) state.settings.camera.clear(), state.camera = state.startCamera;
  actions.screenshot |= panel.screenshot;
  if (!panel.model.empty()) actions.model = panel.model;
  input.panels = panel.areas;
  const ImGuiIO& io = ImGui::GetIO();
  input.mouseTaken = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  input.keyboardTaken = io.WantTextInput || io.WantCaptureKeyboard || input.mouseTaken;
}

void takeLoaded(Viewport& viewport, ViewerState& state, Loader& loader) {
  if (auto model = loader.model.take()) takeModel(viewport, state, std::move(*model));
  if (auto environment = loader.environment.take()) takeEnvironment(viewport, state, std::move(*environment));
  if (auto measured = loader.measured.take()) takeMeasured(viewport, state, std::move(*measured));
  if (auto fit = loader.fit.take()) takeFit(viewport, state, std::move(*fit));
  if (auto images = loader.images.take()) takeImages(viewport, state, std::move(*images));
}

void nameWhatLoads(const Loader& loader, const Viewport& viewport, const std::string& model, ViewerState& state) {
  state.fitting = loader.fit.running();
  state.loading.clear();
  if (loader.model.running())
    state.loading = model;
  else if (loader.images.running())
    state.loading = "images of " + (viewport.next ? viewport.next : viewport.scene)->loaded->model.name;
  else if (loader.environment.running())
    state.loading = viewport.loadingEnvironment;
  else if (loader.measured.running())
    state.loading = viewport.measured.loading.name;
  else if (viewport.comingUp)
    state.loading = (viewport.next ? viewport.next : viewport.scene)->source;
}

void takeScreenshot(const Viewport& viewport, ViewerState& state) {
  if (!viewport.targets.shown) return;
  const Result<std::string> written = writeScreenshot(viewport.targets, state.settings);
  state.status = written ? Status{"screenshot: " + *written, false} : Status{describe(written.error()), true};
  written ? log::info("screenshot written: " + *written) : log::error(state.status.text);
}

// Clicks into the picture, what was asked of the selection, and its line.
void followSelection(Loop& loop, const Input& input, const Actions& actions, Viewport& viewport, ViewerState& state) {
  int width = 1, height = 1;
  glfwGetWindowSize(loop.window, &width, &height);
  for (const glm::dvec2& click : input.clicks) clickAt(viewport, state, click, {width, height});
  if (actions.frameSelection) {
    const scene::Bounds bounds = selectionBounds(viewport, state);
    const std::optional<scene::View> view = currentView(viewport, state);
    if (view && !bounds.empty()) {
      freeCamera(state, *view);
      state.camera = framedAll(state.camera, bounds, static_cast<double>(state.settings.width) / state.settings.height);
    }
  }
  const int before = state.inspection.nextChannel;
  inspectNext(viewport, state);
  if (state.inspection.nextChannel != before) loop.framesToDraw = std::max(loop.framesToDraw, 2);
}

// Told once everything is there: the longest time between two frames until then, and that to the first new frame.
void noteGap(Loop& loop, bool loading) {
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double, std::milli> gap = now - loop.load.frame;
  if (loop.load.running && loading) loop.load.longestGap = std::max(loop.load.longestGap, gap.count());
  if (loop.load.running && !loading)
    log::debug("loaded; the longest gap between frames was " + std::to_string(std::lround(loop.load.longestGap)) +
               " ms, the first new one took " + std::to_string(std::lround(gap.count())) + " ms");
  if (!loading) loop.load.longestGap = 0;
  loop.load.running = loading;
  loop.load.frame = now;
}

void tellBrowser(Loop& loop, const ViewerState& state) {
  const std::string measured = state.shown.measured ? state.shown.measured->path : std::string();
  const std::string shown = state.shown.model + "\n" + state.shown.environment + "\n" + measured;
  if (loop.noted == shown) return;
  loop.noted = shown;
  noteOpened(loop.browser, FileKind::model, state.shown.model);
  noteOpened(loop.browser, FileKind::environment, state.shown.environment);
  if (!measured.empty()) noteOpened(loop.browser, FileKind::brdf, measured);
}

void followFiles(Loop& loop, const Viewport& viewport, Loader& loader) {
  const FilesChanged changed = follow(loop.followed, viewport, loader, loop.last);
  if (changed.model) forgetThumbnail(loop.browser, loop.model = viewport.scene->source);
  if (changed.environment) forgetThumbnail(loop.browser, viewport.environments.shown->source);
  if (changed.measured) forgetThumbnail(loop.browser, viewport.built.measured->facts.path);
}

// From the choice of a measured BRDF to its first frame on the screen.
void noteMeasuredShown(Viewport& viewport) {
  if (!viewport.measured.asked || viewport.built.brdf != viewport.measured.asked->source) return;
  const std::chrono::duration<double, std::milli> spent =
      std::chrono::steady_clock::now() - viewport.measured.asked->since;
  viewport.measured.asked.reset();
  log::debug("measured BRDF on the screen after " + std::to_string(std::lround(spent.count())) +
             " ms: " + viewport.built.measured->facts.name);
}

// How long the window did not answer, where that could be felt.
void noteSlowTurn(std::chrono::steady_clock::time_point start) {
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  if (spent.count() > 50) log::debug("turn of " + std::to_string(std::lround(spent.count())) + " ms");
}

// One turn of the loop. True while the window stays.
bool turn(Loop& loop, Viewport& viewport, ViewerState& state, Loader& loader) {
  const double seconds = waitForEvents(loop, loader, viewport, state);
  const Input input = takeInput(loop.input);
  followFramebuffer(loop.window, state.settings);
  int width = 1, height = 1;
  glfwGetWindowSize(loop.window, &width, &height);
  const Flight flight{flightDirection(loop) * seconds, isDown(loop.window, GLFW_KEY_LEFT_SHIFT)};
  Actions actions = control(input, flight, currentView(viewport, state), height, state);
  const bool wasLoading = loader.running() || viewport.comingUp || viewport.clock.waiting();
  takeLoaded(viewport, state, loader);
  const bool reloaded = shadersChanged(loop.shaders, loop.last);
  if (reloaded) reloadShaders(viewport, state);
  followFiles(loop, viewport, loader);
  tellBrowser(loop, state);
  const bool collected = collect(loop.browser);
  if (state.databases.empty() || collected) state.databases = databases(loop.browser);
  if (input.any || reloaded || collected || flight.rightUpForward != glm::dvec3(0)) loop.framesToDraw = settlingFrames;
  advance(state, seconds);
  if (state.turntable.on) {
    if (const std::optional<scene::View> view = currentView(viewport, state)) freeCamera(state, *view);
    state.camera = turntable(state.camera, seconds, state.turntable.degreesPerSecond);
  }
  const bool moves = state.turntable.on || (state.playback.playing && chosenDuration(state) > 0);
  if (wasLoading || moves) loop.framesToDraw = std::max(loop.framesToDraw, 1);

  followStyle(loop, state);
  if (loop.framesToDraw > 0) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    PanelResult panel;
    drawBrowser(loop.browser, state, panel);
    drawPanel(state, panel);
    applyPanel(panel, viewport, state, loop.input, actions);
  }
  loop.input.keyboardTaken |= state.searchAsked || loop.browser.focusing > 0;
  if (!actions.model.empty()) {
    state.settings.bump.clear();  // it belonged to the scene before
    startModel(loader, loop.model = actions.model);
  }
  if (actions.cancel) cancelLoading(viewport, state, loader);
  for (const std::string& folder : actions.folders) browseFolder(loop.browser, folder);
  if (bringUp(viewport, state, loader)) loop.framesToDraw = settlingFrames + 1;
  nameWhatLoads(loader, viewport, loop.model, state);
  followSelection(loop, input, actions, viewport, state);
  if (!viewport.comparison.sums.empty()) loop.framesToDraw = std::max(loop.framesToDraw, 2);  // its figures come now
  if (drawViewport(viewport, state)) {
    loop.framesToDraw = std::max(loop.framesToDraw, 1);
    readRadianceThere(viewport, state);
  }
  if (updateOutline(viewport, state, loop.scale)) loop.framesToDraw = std::max(loop.framesToDraw, 1);
  if (actions.screenshot) takeScreenshot(viewport, state);
  if (loop.framesToDraw > 0) {
    drawWindow(loop, viewport, state);
    noteGap(loop, !state.loading.empty());
    noteMeasuredShown(viewport);
    --loop.framesToDraw;
  }
  noteSlowTurn(loop.last);
  return !actions.quit && !glfwWindowShouldClose(loop.window);
}

std::string openGLText(const gl::ContextInfo& info) {
  const std::string extended = info.major == 4 && info.minor < 6 ? " with extensions" : "";
  return std::to_string(info.major) + "." + std::to_string(info.minor) + " core" + extended + ", " + info.renderer;
}

Viewport createViewport(const gl::ContextInfo& info, const WindowOptions& options) {
  const bool cached = options.diskCache && info.programBinaries;
  const std::string driver = info.vendor + "\n" + info.renderer + "\n" + info.version;
  Viewport viewport(info, shading::ProgramStore(shading::shaderReader(options.settings.shaderDir),
                                                cached ? userCacheFolder() : std::filesystem::path(), driver));
  // Shaders of the user's may make other tables.
  if (options.diskCache && options.settings.shaderDir.empty()) viewport.tableCache = ibl::userTableCache(driver);
  return viewport;
}

}  // namespace

Result<Start> prepareStart(const WindowOptions& options) {
  Loader loader;
  startModel(loader, options.model, {options.settings.bump, options.settings.bumpScale});
  const frame::PictureSettings& settings = options.settings;
  if (!settings.environment.empty()) startEnvironment(loader, settings.environment);
  if (!settings.brdf.empty()) startMeasured(loader, frame::measuredSource(settings));
  ModelLoaded loaded = *loader.model.take(true);
  if (!loaded.model) return tl::unexpected(loaded.model.error());
  const scene::Model& model = (*loaded.model)->model;
  const Result<int> index = frame::chooseScene(settings, model);
  if (!index) return tl::unexpected(index.error());
  if (const Result<scene::Pose> pose = frame::choosePose(settings, model); !pose) return tl::unexpected(pose.error());
  if (const Result<int> variant = frame::chooseVariant(settings, model); !variant)
    return tl::unexpected(variant.error());
  if (settings.environment.empty())
    startEnvironment(loader, frame::chooseEnvironment(settings, options.model, model, *index));
  if (!settings.camera.empty()) {
    const frame::DrawList list = frame::buildDrawList(model, *index, frame::drawOptions(settings, false));
    if (Result<scene::View> view = frame::chooseView(settings, options.model, model, list, list.bounds); !view)
      return tl::unexpected(view.error());
  }
  EnvironmentLoaded environment = *loader.environment.take(true);
  if (!environment.environment) return tl::unexpected(environment.environment.error());
  std::optional<MeasuredLoaded> measured;
  if (loader.measured.running()) measured = loader.measured.take(true);
  if (measured && !measured->read) return tl::unexpected(measured->read.error());
  return Start{std::move(loaded), std::move(environment), std::move(measured)};
}

Result<void> runWindow(const WindowOptions& options, Start start) {
  Loader loader;  // first: what it still reads at the end is waited for after the window has gone
  ViewerState state;
  if (Result<Preferences> preferences = readPreferences(preferencesFile()))
    state.preferences = *preferences;
  else
    log::warning(describe(preferences.error()));
  const Preferences before = state.preferences;
  const bool sized = !options.sizeGiven && before.width > 0 && before.height > 0;
  Result<gl::WindowContext> context =
      gl::WindowContext::create(sized ? before.width : options.settings.width,
                                sized ? before.height : options.settings.height, "facet", options.glDebug);
  if (!context) return tl::unexpected(context.error());
  glfwSwapInterval(1);
  Loop loop;
  loop.window = context->window();
  loop.shaders = watchShaders(options.settings.shaderDir);
  listen(loop.window, loop.input);
  loop.scale = contentScale(loop.window, state.preferences);
  loop.theme = state.preferences.theme;
  const ImGuiSession imgui(loop.window, loop.scale, state);
  state.settings = options.settings;
  state.playback.playing = !state.settings.animation.empty();
  state.environments = builtinEnvironmentSources();
  state.openGL = openGLText(context->info());
  Viewport viewport = createViewport(context->info(), options);
  loop.model = options.model;
  std::vector<std::string> folders = options.folders;
  for (const std::filesystem::path& folder : io::brdfFolders(state.settings.brdfDir)) folders.push_back(folder);
  openBrowser(loop.browser, folders, options.diskCache ? thumbnailCache() : DiskCache{}, glfwPostEmptyEvent);
  takeModel(viewport, state, std::move(start.model));
  takeEnvironment(viewport, state, std::move(start.environment));
  if (start.measured) takeMeasured(viewport, state, std::move(*start.measured));
  std::string title;
  while (turn(loop, viewport, state, loader)) {
    if (title == state.shown.model) continue;
    title = state.shown.model;
    glfwSetWindowTitle(loop.window, (title + " \xe2\x80\x93 facet").c_str());
  }
  if (!options.sizeGiven) glfwGetWindowSize(loop.window, &state.preferences.width, &state.preferences.height);
  keepPreferences(state, before);
  glfwHideWindow(loop.window);
  return {};
}

}  // namespace facet::view
