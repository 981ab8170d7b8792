#include "view/window.hpp"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/config_file.hpp"
#include "commands/confine.hpp"
#include "commands/picture_arguments.hpp"
#include "io/sources.hpp"
#include "view/last.hpp"

namespace facet::commands {

namespace {

struct WindowArguments {
  PictureArguments picture;
  std::vector<std::string> sources;
  std::string config;
  bool noCache = false, glDebug = false, last = false, noSandbox = false;
};

bool isSession(const std::string& source) { return std::filesystem::path(source).extension() == ".facet"; }

// Two models at most, which are shown beside each other; any number of folders.
Result<void> sortSources(const std::vector<std::string>& sources, view::WindowOptions& options) {
  std::error_code ignored;
  for (const std::string& source : sources) {
    if (std::filesystem::is_directory(source, ignored)) {
      options.folders.push_back(source);
    } else if (isSession(source)) {
      return fail(source, "", "is a session, which has its own model", "name nothing beside it");
    } else if (source == io::standardInput) {
      return fail("-", "", "is standard input, which a window could not read again", "name a file");
    } else if (!options.secondModel.empty()) {
      return fail(source, "", "is the third model", "name one model or two, and folders to browse");
    } else if (options.modelNamed) {
      options.secondModel = source;
    } else {
      options.model = source;
      options.modelNamed = true;
    }
  }
  return {};
}

// What was shown when the window was closed last, or was kept as a session.
Result<void> applyLast(const std::string& file, view::WindowOptions& options) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return fail(file, "", "is not there", "close a window on a model first, or keep a session with Ctrl+S");
  const nlohmann::json last = nlohmann::json::parse(stream, nullptr, false);
  const auto isText = [&](const char* key) { return last.contains(key) && last[key].is_string(); };
  if (!last.is_object() || !isText("folder") || !isText("model") || !last.contains("picture") ||
      !last["picture"].is_object())
    return fail(file, "", "is not what a window has written", "delete it");
  const std::string folder = last["folder"];
  const auto there = [&](const std::string& model) {
    return model.starts_with("builtin:") ? model : (std::filesystem::path(folder) / model).string();
  };
  options.modelNamed = true;
  options.model = there(last["model"]);
  if (isText("second")) options.secondModel = there(last["second"]);
  return applyObject(last["picture"], {}, folder, file, "/picture", options.settings);
}

// Folders that are not there yet are made: what does not exist cannot be allowed.
void confineWindow(bool ownCache) {
  Needed needed{.read = {}, .written = view::writtenFolders(), .window = true};
  std::error_code ignored;
  for (const std::filesystem::path& folder : needed.written) std::filesystem::create_directories(folder, ignored);
  needed.written.push_back(std::filesystem::temp_directory_path(ignored));  // previews
  if (const char* display = std::getenv("XDG_RUNTIME_DIR")) needed.written.emplace_back(display);
  confine(std::move(needed), ownCache);
}

int runViewer(const WindowArguments& arguments) {
  view::WindowOptions options;
  options.settings.frame.width = 1280;
  options.settings.frame.height = 800;
  options.settings.quality.samples = 256;  // a resting picture converges
  bool restored = false;                   // with settings of its own, which the usual file of options leaves alone
  const bool asItWas = arguments.sources.empty() && arguments.picture.empty() && view::startsWithLast();
  const bool session = arguments.sources.size() == 1 && isSession(arguments.sources.front());
  if (session || arguments.last || asItWas) {
    view::WindowOptions last = options;
    Result<void> r = applyLast(session ? arguments.sources.front() : view::lastFile().string(), last);
    if (r) r = view::checkStart(last);
    if (!r && (session || arguments.last)) return badInput(r.error());
    if (r) options = last, restored = true;
    if (!r && std::filesystem::exists(view::lastFile())) log::warning(describe(r.error()));
  }
  if (!session)
    if (Result<void> r = sortSources(arguments.sources, options); !r) return badInput(r.error());
  PictureArguments given = arguments.picture;
  std::filesystem::path config = arguments.config;
  if (config.empty() && !restored) config = usualConfig();
  if (!config.empty() && config != "none")
    if (Result<void> r = applyConfig(config, options.model, given); !r) return badInput(r.error());
  if (Result<void> r = options::apply(given, options.settings); !r) return badInput(r.error());
  frame::Sources& sources = options.settings.sources;  // the window goes by one name for file and layer
  sources.environment = io::withLayer(sources.environment, std::exchange(sources.environmentLayer, {}));
  options.sizeGiven = given.contains("size");
  options.diskCache = !arguments.noCache;
  options.glDebug = arguments.glDebug;
  if (!arguments.noSandbox) {
    keepDriverCacheApart();
    options.atWork = [ownCache = options.diskCache] { confineWindow(ownCache); };
  }
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
  app.add_option(
         "MODEL", arguments->sources,
         "a .gltf or .glb file, or builtin:NAME (builtin:poster), two of them beside each other; folders are browsed; "
         "or a session (.facet)")
      ->type_name("MODEL|FOLDER");
  addConfig(app, arguments->config, " ($XDG_CONFIG_HOME/facet/config, where there is one)");
  app.add_flag("--last", arguments->last,
               "what was shown when the window was closed last, with its camera and settings");
  app.add_flag("--no-cache", arguments->noCache,
               "neither read nor write the caches of compiled shaders and of light tables");
  app.add_flag("--gl-debug", arguments->glDebug, "log OpenGL's debug messages");
  addNoSandbox(app, arguments->noSandbox);
  addPictureOptions(app, arguments->picture);
  return [arguments] { return runViewer(*arguments); };
}

}  // namespace facet::commands
