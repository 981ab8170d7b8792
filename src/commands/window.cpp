#include "view/window.hpp"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/picture_arguments.hpp"

namespace facet::commands {

namespace {

struct WindowArguments {
  PictureArguments picture;
  std::vector<std::string> sources;
  bool noCache = false, glDebug = false;
};

// One model at most, any number of folders.
Result<void> sortSources(const std::vector<std::string>& sources, view::WindowOptions& options) {
  bool named = false;
  std::error_code ignored;
  for (const std::string& source : sources) {
    if (std::filesystem::is_directory(source, ignored)) {
      options.folders.push_back(source);
    } else if (named) {
      return fail(source, "", "is the second model", "name one model, and folders to browse");
    } else {
      options.model = source;
      named = true;
    }
  }
  return {};
}

int runViewer(const WindowArguments& arguments) {
  view::WindowOptions options;
  options.settings.frame.width = 1280;
  options.settings.frame.height = 800;
  options.settings.quality.samples = 256;  // a resting picture converges
  if (Result<void> r = options::apply(arguments.picture, options.settings); !r) return badInput(r.error());
  options.sizeGiven = arguments.picture.contains("size");
  if (Result<void> r = sortSources(arguments.sources, options); !r) return badInput(r.error());
  options.diskCache = !arguments.noCache;
  options.glDebug = arguments.glDebug;
  if (Result<void> r = view::checkStart(options); !r) return badInput(r.error());
  const Result<bool> shown = view::runWindow(options);
  if (!shown) {
    log::error(describe(shown.error()));
    return exitNoOpenGL;
  }
  return *shown ? exitGood : exitBadInput;
}

}  // namespace

std::function<int()> addWindow(CLI::App& app) {
  auto arguments = std::make_shared<WindowArguments>();
  app.add_option("model", arguments->sources,
                 "a .gltf or .glb file, or builtin:NAME (builtin:poster); folders are browsed")
      ->type_name("MODEL|FOLDER");
  app.add_flag("--no-cache", arguments->noCache,
               "neither read nor write the caches of compiled shaders and of light tables");
  app.add_flag("--gl-debug", arguments->glDebug, "log OpenGL's debug messages");
  addPictureOptions(app, arguments->picture);
  return [arguments] { return runViewer(*arguments); };
}

}  // namespace facet::commands
