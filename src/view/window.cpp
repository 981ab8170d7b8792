#include "view/window.hpp"

#include <imgui.h>

#include "options/picture_options.hpp"
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>

#include "base/file_ending.hpp"
#include "base/log.hpp"
#include "frame/user_stores.hpp"
#include "gl/context.hpp"
#include "io/measured.hpp"
#include "io/sources.hpp"
#include "view/bring_up.hpp"
#include "view/browser.hpp"
#include "view/camera_control.hpp"
#include "view/camera_exchange.hpp"
#include "view/controls.hpp"
#include "view/edits.hpp"
#include "view/file_dialog.hpp"
#include "view/follow.hpp"
#include "view/imgui_session.hpp"
#include "view/input.hpp"
#include "view/inspector.hpp"
#include "view/large_picture.hpp"
#include "view/last.hpp"
#include "view/layout.hpp"
#include "view/letters.hpp"
#include "view/load_time.hpp"
#include "view/panel.hpp"
#include "view/playback.hpp"
#include "view/present.hpp"
#include "view/recent.hpp"
#include "view/screenshot.hpp"
#include "view/shader_watch.hpp"
#include "view/viewport.hpp"

namespace facet::view {

namespace {

// After something has happened ImGui needs a few frames until hovering, clicks and sizes have settled.
constexpr int settlingFrames = 3;
constexpr double busyWait = 0.03, timerWait = 0.02, stepWait = 0.004, idleWait = 10;  // seconds

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
  Bookmarks bookmarks;  // as they are in their file
  std::optional<FileDialog> dialog;
  LargePicture large;
  Letters letters;                              // of names that have been shown
  std::weak_ptr<const scene::Model> lettersOf;  // the last one whose names are among them
};

std::filesystem::path preferencesFile() {
  const std::filesystem::path folder = userConfigFolder();
  return folder.empty() ? folder : folder / "settings.json";
}

void keepPreferences(const ViewerState& state, const Preferences& before) {
  const std::filesystem::path file = preferencesFile();
  if (file.empty() || state.preferences == before) return;
  if (const Result<void> written = writePreferences(file, state.preferences); !written)
    log::warning(describe(written.error()));
}

// With which the next start may begin; the quality that was asked for, not what of it rests.
void keepLast(const ViewerState& state) {
  const std::filesystem::path file = lastFile();
  if (file.empty() || state.shown.model.empty()) return;
  frame::PictureSettings settings = commandSettings(state);
  settings.quality = state.settings.quality;
  if (const Result<void> written = writeLast(file, state.shown.model, state.secondModel, settings); !written)
    log::warning(describe(written.error()));
}

// What is on the screen, as a file.
void saveSession(ViewerState& state, const std::filesystem::path& file) {
  if (state.shown.model.empty()) return say(state, "there is nothing to keep yet");
  frame::PictureSettings settings = commandSettings(state);
  settings.quality = state.settings.quality;
  if (const Result<void> written = writeLast(file, state.shown.model, state.secondModel, settings); !written)
    return complain(state, written.error());
  say(state, "session written: " + file.string());
}

std::filesystem::path exportNameHere(const ViewerState& state) {
  std::error_code ignored;
  return exportName(state.shown.model, std::filesystem::current_path(ignored));
}

// What it is to be is said by the ending of its name.
void saveAs(const std::filesystem::path& file, ViewerState& state, Loader& loader) {
  const std::string ending = fileEnding(file);
  if (ending == ".facet") return saveSession(state, file);
  if (ending == ".glb") return startExport(state, loader, file);
  state.screenshotAsked = true, state.screenshotFile = file;
}

// The system's dialog: what is chosen to be opened is as if it were dropped.
void followDialog(Loop& loop, const Actions& actions, ViewerState& state, Loader& loader) {
  if ((actions.openFile || actions.saveAs) && !loop.dialog) {
    const std::filesystem::path shown = state.shown.model;
    std::error_code ignored;
    const bool file = shown.has_parent_path() && !state.shown.model.starts_with(io::builtinPrefix);
    Result<FileDialog> dialog =
        actions.saveAs ? FileDialog::save(newNameHere(".png"))
                       : FileDialog::open(file ? shown.parent_path() : std::filesystem::current_path(ignored));
    if (!dialog) return complain(state, dialog.error());
    loop.dialog.emplace(std::move(*dialog));
  }
  if (!loop.dialog) return;
  const std::optional<std::string> chosen = loop.dialog->poll();
  if (!chosen) return;
  const bool saves = loop.dialog->saves();
  loop.dialog.reset();
  if (chosen->empty()) return;
  loop.input.any = true;
  saves ? saveAs(*chosen, state, loader) : loop.input.dropped.push_back(*chosen);
}

void gatherLetters(Loop& loop, const ViewerState& state, bool listed) {
  if (state.shown.content && loop.lettersOf.lock() != state.shown.content)
    addLetters(*state.shown.content, loop.letters), loop.lettersOf = state.shown.content;
  if (listed)
    for (const Entry& entry : loop.browser.entries)
      addLetters(entry.name, loop.letters), addLetters(entry.place, loop.letters);
  addLetters(loop.browser.query, loop.letters), addLetters(state.status.text, loop.letters);
}

// asked: its button was pressed, which takes it back where it runs.
// True where something is to be told.
bool followLargePicture(LargePicture& large, bool asked, ViewerState& state) {
  if (asked && large.running()) {
    large.cancel();
    say(state, "the picture is not drawn");
  } else if (asked) {
    frame::PictureSettings settings = commandSettings(state);
    settings.quality = state.settings.quality;
    settings.frame.width = state.largeWidth, settings.frame.height = state.largeHeight;
    const Result<void> started = large.start(settings, state.shown.model, newNameHere(".png"));
    const std::string size = std::to_string(state.largeWidth) + " x " + std::to_string(state.largeHeight);
    started ? say(state, "a picture of " + size + " is drawn beside the window") : complain(state, started.error());
  }
  const std::optional<Result<std::string>> ended = large.poll();
  if (ended) *ended ? say(state, "picture written: " + **ended) : complain(state, ended->error());
  state.largePictureRuns = large.running();
  return asked || ended;
}

bool isDown(GLFWwindow* window, int key) { return glfwGetKey(window, key) == GLFW_PRESS; }

bool isHeld(const Loop& loop, const KeyMap& keys, Command command) {
  const auto chords = keys.find(command);
  if (chords == keys.end()) return false;
  return std::ranges::any_of(chords->second, [&](const Chord& chord) {
    return std::ranges::any_of(keysCalled(chord.key),
                               [&](int key) { return isDown(loop.window, key) && !loop.input.chorded.contains(key); });
  });
}

glm::dvec3 flightDirection(const Loop& loop, const KeyMap& keys) {
  if (loop.input.keyboardTaken) return glm::dvec3(0);
  const auto axis = [&](Command plus, Command minus) { return isHeld(loop, keys, plus) - isHeld(loop, keys, minus); };
  return {axis(Command::flyRight, Command::flyLeft), axis(Command::flyUp, Command::flyDown),
          axis(Command::flyForward, Command::flyBack)};
}

// Sleeps until there is something to do; seconds since the last time, at most a quarter, for flight.
double waitForEvents(Loop& loop, const Loader& loader, const Viewport& viewport, const ViewerState& state) {
  const bool watches = !loop.shaders.folder.empty() || !loop.followed.modelFiles.files.empty() ||
                       !loop.followed.environmentFiles.files.empty() || !loop.followed.measuredFiles.files.empty() ||
                       !viewport.second.watch.files.empty();
  const double idle = watches ? fileWatchSeconds : idleWait;
  if (loop.framesToDraw > 0 || !loop.input.hands.empty() || flightDirection(loop, state.keys) != glm::dvec3(0))
    glfwPollEvents();
  else
    glfwWaitEventsTimeout(atWork(viewport, state) || viewport.comingUp || loader.measured.running() ? stepWait
                          : loop.dialog || loop.large.running() || loader.running() || viewport.second.working() ||
                                  loader.fileCheck.running() || loader.metadata.running() || loader.exported.running()
                              ? busyWait
                          : viewport.clock.waiting() ? timerWait
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
  settings.frame.width = std::min(width, 16384);
  settings.frame.height = std::min(height, 16384);
}

void copyCommand(const std::string& command, ViewerState& state) {
  ImGui::SetClipboardText(command.c_str());
  say(state, "copied: " + command);
}

void applyPanel(const PanelResult& panel, Viewport& viewport, ViewerState& state, Input& input, Actions& actions) {
  const std::optional<scene::View> view = currentView(viewport, state);
  if ((panel.leaveFileCamera || panel.frameAll) && view) freeCamera(state, *view);
  if (panel.viewFrom && view) freeCamera(state, *view), state.camera = seenFrom(state.camera, *panel.viewFrom);
  if (panel.describeMaterial && viewport.scene)
    state.inspection.materialDetails = materialDetails(viewport, state.selection.material);
  actions.frameSelection |= panel.frameSelection;
  if (panel.frameAll) state.camera = framedAll(state.camera, state.shown.bounds, framingAspect(state));
  if (panel.copyCamera || actions.copyCamera) copyCamera(state);
  if (panel.pasteCamera || actions.pasteCamera) pasteCamera(state);
  if (panel.resetCamera) state.settings.viewpoint.camera.clear(), state.camera = state.startCamera;
  actions.screenshot |= panel.screenshot;
  if (!panel.model.empty()) actions.model = panel.model;
  if (!panel.secondModel.empty()) state.secondModel = panel.secondModel;
  if (!panel.addedModel.empty()) state.settings.sources.with.push_back(panel.addedModel);
  input.panels = panel.areas;
  const ImGuiIO& io = ImGui::GetIO();
  const double scale = state.settings.frame.width / std::max(1.0, static_cast<double>(io.DisplaySize.x));
  state.coveredLeft = panel.left * scale, state.coveredRight = panel.right * scale;
  input.mouseTaken = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  input.keyboardTaken = io.WantTextInput || io.WantCaptureKeyboard || input.mouseTaken;
}

void takeLoaded(Viewport& viewport, ViewerState& state, Loader& loader) {
  if (auto model = loader.model.take()) takeModel(viewport, state, std::move(*model));
  if (auto environment = loader.environment.take()) takeEnvironment(viewport, state, std::move(*environment));
  if (auto measured = loader.measured.take()) takeMeasured(viewport, state, std::move(*measured));
  if (auto fit = loader.fit.take()) takeFit(viewport, state, std::move(*fit));
  if (auto table = loader.table.take()) takeTable(state, std::move(*table));
  if (auto images = loader.images.take()) takeImages(viewport, state, std::move(*images));
  if (auto exported = loader.exported.take()) takeExport(state, std::move(*exported));
  if (auto checked = loader.fileCheck.take()) takeFileCheck(state, std::move(*checked));
  if (auto read = loader.metadata.take()) takeMetadata(state, std::move(*read));
}

void nameWhatLoads(const Loader& loader, const Viewport& viewport, const std::string& model, ViewerState& state) {
  state.fitting = loader.fit.running();
  state.loading.clear();
  if (loader.model.running())
    state.loading = model;
  else if (viewport.second.loader.running())
    state.loading = viewport.second.asked;
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
  const std::string of = samplesShown(viewport, state);
  std::filesystem::path file = std::exchange(state.screenshotFile, {});
  if (file.empty()) file = newNameHere(".png");
  const Result<void> written =
      writeScreenshot(file, viewport.targets, state.settings,
                      viewport.overlay.shown && state.overlaysInPictures ? &viewport.overlay.targets : nullptr);
  if (!written) return complain(state, written.error());
  state.status = {
      "screenshot" + (of.empty() ? of : " of " + of) + ": " + file.string() +
          (of.empty() ? of : withKeys("; of all once they are there", state.keys, Command::screenshotConverged)),
      false};
  log::info((of.empty() ? of : of + "; ") + "screenshot written: " + file.string());
}

// The one that waits for the picture to converge.
void followScreenshot(const Viewport& viewport, ViewerState& state) {
  if (!state.screenshotWaits) return;
  const std::string of = samplesShown(viewport, state);
  if (!of.empty() || viewport.comingUp || !state.loading.empty()) {
    state.status = {withKeys("the screenshot waits for the picture to converge: " + of + "; not at all", state.keys,
                             Command::escape),
                    false};
    return;
  }
  state.screenshotWaits = false;
  takeScreenshot(viewport, state);
}

// Clicks into the picture, what was asked of the selection, and its line.
void followSelection(Loop& loop, const Input& input, const Actions& actions, Viewport& viewport, ViewerState& state) {
  int width = 1, height = 1;
  glfwGetWindowSize(loop.window, &width, &height);
  for (const glm::dvec2& click : input.clicks) clickAt(viewport, state, click, {width, height});
  for (const glm::dvec2& click : input.doubleClicks) {
    clickAt(viewport, state, click, {width, height});
    const std::optional<scene::View> view = currentView(viewport, state);
    if (!view || !state.inspection.on) continue;
    freeCamera(state, *view);
    state.camera.target = state.inspection.hit.position;
  }
  if (actions.frameSelection) {
    const scene::Bounds bounds = selectionBounds(viewport, state);
    const std::optional<scene::View> view = currentView(viewport, state);
    if (view && !bounds.empty()) {
      freeCamera(state, *view);
      state.camera = framedAll(state.camera, bounds, framingAspect(state));
    }
  }
  const int before = state.inspection.nextChannel;
  inspectNext(viewport, state);
  if (state.inspection.nextChannel != before) loop.framesToDraw = std::max(loop.framesToDraw, 2);
}

void tellBrowser(Loop& loop, const ViewerState& state) {
  const std::string measured = state.shown.measured ? state.shown.measured->path : std::string();
  const std::string shown = state.shown.model + "\n" + state.shown.environment + "\n" + measured;
  if (loop.noted == shown) return;
  loop.noted = shown;
  if (state.shown.model.empty()) return;
  noteOpened(loop.browser, FileKind::model, state.shown.model);
  noteOpened(loop.browser, FileKind::environment, state.shown.environment);
  if (!measured.empty()) noteOpened(loop.browser, FileKind::brdf, measured);
}

void followFiles(Loop& loop, const Viewport& viewport, Loader& loader) {
  const FilesChanged changed = follow(loop.followed, viewport, loader, loop.last);
  if (changed.model) forgetThumbnail(loop.browser, loop.model = viewport.scene->source);
  if (changed.environment) forgetThumbnail(loop.browser, viewport.environments.shown->source);
  if (changed.measured) forgetThumbnail(loop.browser, viewport.shown.inputs.list.measured->facts.path);
}

// One turn of the loop. True while the window stays.
bool turn(Loop& loop, ImGuiSession& imgui, Viewport& viewport, ViewerState& state, Loader& loader) {
  const double seconds = waitForEvents(loop, loader, viewport, state);
  const Delivery delivery = deliver(loop.input.hands, loop.input.keyboard(), state.keys);
  loop.input.commands = delivery.commands;
  if (delivery.handsOver) loop.input.handingOver = settlingFrames;
  for (const Command command : delivery.commands)
    if (command == Command::search || command == Command::help) loop.input.textAwaited = settlingFrames + 1;
  const Input input = takeInput(loop.input);
  followFramebuffer(loop.window, state.settings);
  int width = 1, height = 1;
  glfwGetWindowSize(loop.window, &width, &height);
  const Flight flight{flightDirection(loop, state.keys) * seconds, isDown(loop.window, GLFW_KEY_LEFT_SHIFT)};
  Actions actions = control(input, flight, currentView(viewport, state), height, state);
  const bool wasLoading = loader.running() || viewport.second.working() || loader.fileCheck.running() ||
                          loader.metadata.running() || loader.exported.running() || viewport.comingUp ||
                          viewport.clock.waiting();
  takeLoaded(viewport, state, loader);
  followDialog(loop, actions, state, loader);
  if (actions.saveSession) saveSession(state, newNameHere(".facet"));
  const bool reloaded = shadersChanged(loop.shaders, loop.last);
  if (reloaded) reloadShaders(viewport, state);
  followFiles(loop, viewport, loader);
  followFileCheck(state, loader);
  followMetadata(state, loader);
  followLobe(state, loader);
  tellBrowser(loop, state);
  const bool collected = collect(loop.browser);
  if (const std::string only = takeDropped(loop.browser, state); !only.empty()) actions.model = only;
  if (state.databases.empty() || collected) state.databases = databases(loop.browser);
  if (input.any || !delivery.toPanels.empty() || loop.input.keyboard() == Keyboard::awaited || reloaded || collected ||
      flight.rightUpForward != glm::dvec3(0))
    loop.framesToDraw = settlingFrames;
  advance(state, seconds);
  if (state.turntable.on) {
    if (const std::optional<scene::View> view = currentView(viewport, state)) freeCamera(state, *view);
    state.camera = turntable(state.camera, seconds, state.turntable.degreesPerSecond);
  }
  const bool moves = state.turntable.on || (state.playback.playing && chosenDuration(state) > 0);
  if (wasLoading || moves) loop.framesToDraw = std::max(loop.framesToDraw, 1);

  gatherLetters(loop, state, collected);
  if (followStyle(imgui, state.preferences, loop.letters)) loop.framesToDraw = settlingFrames;
  bool pictureAsked = false;
  const bool begun =
      loop.framesToDraw > 0;  // else what comes up is shown in the next turn: panels are drawn once a frame
  if (begun) {
    beginFrame(imgui, delivery.toPanels);
    state.shown.view = currentView(viewport, state);
    PanelResult panel;
    drawBrowser(loop.browser, state, panel);
    drawPanel(state, panel);
    if ((panel.copyCommand || actions.copyCommand) && !state.shown.model.empty())
      copyCommand(options::commandLine(commandSettings(state), state.shown.model, "picture.png"), state);
    applyPanel(panel, viewport, state, loop.input, actions);
    pictureAsked = panel.largePicture;
    keepBookmarks(state, loop.bookmarks);
    if (panel.exportModel) startExport(state, loader, exportNameHere(state));
    followEdits(viewport, state, loader, ImGui::IsAnyItemActive());
    followTogether(viewport, state, loader);
    loop.input.handingOver = std::max(0, loop.input.handingOver - 1);
    loop.input.textAwaited = ImGui::GetIO().WantTextInput ? 0 : std::max(0, loop.input.textAwaited - 1);
  }
  loop.input.keyboardTaken |= state.searchAsked || loop.browser.focusing > 0;
  if (followLargePicture(loop.large, pictureAsked, state)) loop.framesToDraw = std::max(loop.framesToDraw, 2);
  if (!actions.model.empty()) {
    state.settings.sources.bump.clear(), state.settings.sources.with.clear();  // they belonged to the scene before
    loader.editable = false, loader.with.clear();
    startModel(loader, loop.model = actions.model);
  }
  if (actions.cancel) cancelLoading(viewport, state, loader);
  for (const std::string& folder : actions.folders) dropFolder(loop.browser, folder);
  if (bringUp(viewport, state, loader)) loop.framesToDraw = settlingFrames + 1;
  followSecond(viewport, state, loader);
  followFlip(viewport, state);
  nameWhatLoads(loader, viewport, loop.model, state);
  followSelection(loop, input, actions, viewport, state);
  if (!viewport.comparison.sums.empty()) loop.framesToDraw = std::max(loop.framesToDraw, 2);  // its figures come now
  if (drawViewport(viewport, state)) {
    loop.framesToDraw = std::max(loop.framesToDraw, 1);
    readRadianceThere(viewport, state);
  }
  if (updateOutline(viewport, state, imgui.scale)) loop.framesToDraw = std::max(loop.framesToDraw, 1);
  if (updateOverlay(viewport, state)) loop.framesToDraw = std::max(loop.framesToDraw, 1);
  state.screenshotAsked |= actions.screenshot;
  if (state.screenshotAsked && !viewport.moving.underWay) {
    state.screenshotAsked = false;
    takeScreenshot(viewport, state);
  }
  followScreenshot(viewport, state);
  if (begun) {
    present(loop.window, viewport, state);
    if (const Result<void> driver = gl::checkDriver("the window's picture");
        !driver && state.status.text != describe(driver.error()))
      complain(state, driver.error());
    noteGap(loop.load, !state.loading.empty());
    noteMeasuredShown(viewport);
    --loop.framesToDraw;
  }
  noteSlowTurn(loop.last);
  const std::chrono::duration<double> turnTook = std::chrono::steady_clock::now() - loop.last;
  loop.input.longestTurn = std::max(loop.input.longestTurn, turnTook.count());
  return !actions.quit && !glfwWindowShouldClose(loop.window);
}

std::string openGLText(const gl::ContextInfo& info) {
  const std::string extended = info.major == 4 && info.minor < 6 ? " with extensions" : "";
  return std::to_string(info.major) + "." + std::to_string(info.minor) + " core" + extended + ", " + info.renderer;
}

Viewport createViewport(const gl::ContextInfo& info, const WindowOptions& options) {
  const std::string& shaderDir = options.settings.sources.shaderDir;
  Viewport viewport(info, frame::userPrograms(info, shaderDir, options.diskCache));
  viewport.moving.turnMs = 40;
  viewport.tableCache = frame::userTables(info, shaderDir, options.diskCache);
  return viewport;
}

// What the options name, read beside the window.
void loadFirst(const WindowOptions& options, Loop& loop, Viewport& viewport, ViewerState& state, Loader& loader) {
  const frame::PictureSettings& settings = options.settings;
  startModel(loader, loop.model = options.model, Opening::first, {settings.sources.bump, settings.sources.bumpScale});
  if (!settings.sources.environment.empty())
    startEnvironment(loader, viewport.loadingEnvironment = settings.sources.environment);
  if (!settings.sources.brdf.empty())
    startMeasured(loader, viewport.measured.loading = frame::measuredSource(settings.sources));
  nameWhatLoads(loader, viewport, loop.model, state);
}

}  // namespace

std::vector<std::filesystem::path> writtenFolders() {
  std::error_code ignored;
  std::vector<std::filesystem::path> folders = {userConfigFolder(), lastFile().parent_path(),
                                                recentFile().parent_path(), std::filesystem::current_path(ignored)};
  std::erase_if(folders, [](const std::filesystem::path& folder) { return folder.empty(); });
  return folders;
}

Result<void> checkStart(const WindowOptions& options) {
  const frame::PictureSettings& settings = options.settings;
  if (Result<void> r = io::checkModelSource(options.model, {}, {settings.sources.bump, settings.sources.bumpScale}); !r)
    return r;
  for (const std::string& other : settings.sources.with)
    if (Result<void> r = io::checkModelSource(other); !r) return r;
  if (!options.secondModel.empty())
    if (Result<void> r = io::checkModelSource(options.secondModel, {}, {}); !r) return r;
  const std::string& environment = settings.sources.environment;
  if (!environment.empty() && environment != "none")
    if (Result<void> r = io::checkEnvironmentSource(environment); !r) return r;
  if (!settings.sources.brdf.empty())
    if (Result<std::string> path = io::resolveMeasured(settings.sources.brdf, settings.sources.brdfDir); !path)
      return tl::unexpected(path.error());
  return {};
}

Result<bool> runWindow(const WindowOptions& options) {
  Loader loader;  // first: what it still reads at the end is waited for after the window has gone
  loader.allowOutside = options.settings.sources.allowOutside;
  loader.editable = !options.settings.placement.arrangement.edits.empty();
  loader.with = options.settings.sources.with;
  ViewerState state;
  if (Result<Preferences> preferences = readPreferences(preferencesFile()))
    state.preferences = *preferences;
  else
    log::warning(describe(preferences.error()));
  const Preferences before = state.preferences;
  const bool sized = !options.sizeGiven && before.width > 0 && before.height > 0;
  Result<gl::WindowContext> context =
      gl::WindowContext::create(sized ? before.width : options.settings.frame.width,
                                sized ? before.height : options.settings.frame.height, "facet", options.glDebug);
  if (!context) return tl::unexpected(context.error());
  glfwSwapInterval(1);
  if (options.atWork) options.atWork();
  Loop loop;
  loop.window = context->window();
  loop.shaders = watchShaders(options.settings.sources.shaderDir);
  listen(loop.window, loop.input);
  ImGuiSession imgui(loop.window, state);
  listenToHands(loop.window);
  state.settings = options.settings;
  state.secondModel = options.secondModel;
  state.overlaysInPictures = options.settings.overlays.shown != 0;
  state.playback.playing = !state.settings.placement.animation.empty();
  state.environments = builtinEnvironmentSources();
  state.openGL = openGLText(context->info());
  if (Result<KeyMap> keys = readKeys(userConfigFolder() / "keys.json"))
    state.keys = std::move(*keys);
  else
    complain(state, keys.error());
  loop.bookmarks = loadBookmarks(state);
  Viewport viewport = createViewport(context->info(), options);
  const bool opensFolder = !options.modelNamed && options.folders.size() == 1;
  std::vector<std::string> folders;
  if (!opensFolder) folders = options.folders;
  for (const std::filesystem::path& folder : io::brdfFolders(state.settings.sources.brdfDir)) folders.push_back(folder);
  openBrowser(loop.browser, folders, options.diskCache ? thumbnailCache() : DiskCache{}, glfwPostEmptyEvent);
  if (opensFolder) dropFolder(loop.browser, options.folders.front());
  loadFirst(options, loop, viewport, state, loader);
  std::string title;
  while (turn(loop, imgui, viewport, state, loader)) {
    if (title == state.shown.model) continue;
    title = state.shown.model;
    glfwSetWindowTitle(loop.window, (title + " \xe2\x80\x93 facet").c_str());
  }
  if (!options.sizeGiven) glfwGetWindowSize(loop.window, &state.preferences.width, &state.preferences.height);
  keepPreferences(state, before);
  keepLast(state);
  glfwHideWindow(loop.window);
  return viewport.scene || !state.modelFailed;
}

}  // namespace facet::view
