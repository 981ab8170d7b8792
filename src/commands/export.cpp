#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "base/log.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/write_tables.hpp"
#include "io/sources.hpp"
#include "scene/builtin_scenes.hpp"

namespace facet::commands {

namespace {

struct ExportArguments {
  std::string scene, output;
};

int runExport(const ExportArguments& arguments) {
  if (!arguments.scene.starts_with(io::builtinPrefix))
    return badInput({{}, inQuotes(arguments.scene), "only built-in scenes are written", "give builtin:NAME"});
  if (!arguments.output.ends_with(".glb"))
    return badInput({arguments.output, "-o", "a built-in scene is binary glTF", "end the name in .glb"});
  const Result<std::vector<uint8_t>> glb = scene::builtinScene(arguments.scene);
  if (!glb) return badInput(glb.error());
  const Result<void> written = writeText(arguments.output, {reinterpret_cast<const char*>(glb->data()), glb->size()});
  if (!written) return badInput(written.error());
  log::info(arguments.output);
  return exitGood;
}

}  // namespace

std::function<int()> addExport(CLI::App& app) {
  auto arguments = std::make_shared<ExportArguments>();
  app.add_option("SCENE", arguments->scene, "a built-in scene (facet materials --list has them)")
      ->type_name("builtin:NAME")
      ->required();
  app.add_option("-o,--output", arguments->output, "the file")->type_name("OUT.glb")->required();
  return [arguments] { return runExport(*arguments); };
}

}  // namespace facet::commands
