#include "view/window.hpp"

#include <CLI/CLI.hpp>
#include <memory>

#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/picture_options.hpp"

namespace facet::commands {

namespace {

struct WindowArguments {
  PictureArguments picture;
  std::string model;
  bool noCache = false, glDebug = false;
};

int runViewer(const WindowArguments& arguments) {
  view::WindowOptions options;
  options.settings.width = 1280;
  options.settings.height = 800;
  options.settings.samples = 256;  // a resting picture converges
  if (Result<void> r = apply(arguments.picture, options.settings); !r) return badInput(r.error());
  options.sizeGiven = arguments.picture.contains("size");
  if (!arguments.model.empty()) options.model = arguments.model;
  options.diskCache = !arguments.noCache;
  options.glDebug = arguments.glDebug;
  Result<view::Start> start = view::prepareStart(options);
  if (!start) return badInput(start.error());
  if (Result<void> shown = view::runWindow(options, std::move(*start)); !shown) {
    log::error(describe(shown.error()));
    return exitNoOpenGL;
  }
  return exitGood;
}

}  // namespace

std::function<int()> addWindow(CLI::App& app) {
  auto arguments = std::make_shared<WindowArguments>();
  app.add_option("model", arguments->model, "a .gltf or .glb file, or builtin:NAME (builtin:poster)")
      ->type_name("MODEL");
  app.add_flag("--no-cache", arguments->noCache, "neither read nor write the caches of compiled shaders and of light tables");
  app.add_flag("--gl-debug", arguments->glDebug, "log OpenGL's debug messages");
  addPictureOptions(app, arguments->picture);
  return [arguments] { return runViewer(*arguments); };
}

}  // namespace facet::commands
