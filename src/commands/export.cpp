#include "frame/export.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <string>

#include "base/log.hpp"
#include "base/text.hpp"
#include "base/whole_file.hpp"
#include "commands/commands.hpp"
#include "commands/picture_arguments.hpp"
#include "commands/write_tables.hpp"
#include "frame/settings.hpp"
#include "io/gltf_edited.hpp"

namespace facet::commands {

namespace {

constexpr std::array<std::string_view, 7> changing = {
    "set", "only", "model-up", "model-rotation", "model-position", "model-scale", "allow-outside"};

struct ExportArguments {
  std::string model, output;
  PictureArguments picture;
};

Result<void> exportModel(const ExportArguments& arguments) {
  frame::PictureSettings settings;
  if (Result<void> r = options::apply(arguments.picture, settings); !r) return r;
  Notes notes;
  const io::Limits limits{.allowOutside = settings.sources.allowOutside};
  const Result<std::vector<uint8_t>> glb =
      frame::exportGlb(arguments.model, settings.placement.arrangement, notes, limits);
  if (!glb) return tl::unexpected(glb.error());
  for (const Note& note : notes) log::warning(options::describe(arguments.model, note));
  return writeOutputFile(arguments.output, std::as_bytes(std::span(*glb)));
}

int runExport(const ExportArguments& arguments) {
  if (!arguments.output.ends_with(".glb") && arguments.output != "-")
    return badInput({arguments.output, "-o", "what is written is binary glTF", "end the name in .glb"});
  if (const Result<void> written = exportModel(arguments); !written) return badInput(written.error());
  log::info(arguments.output);
  return exitGood;
}

}  // namespace

std::function<int()> addExport(CLI::App& app) {
  auto arguments = std::make_shared<ExportArguments>();
  app.add_option("MODEL", arguments->model, "a .gltf or .glb file, or a built-in scene (facet materials --list)")
      ->type_name("FILE|builtin:NAME")
      ->required();
  app.add_option("-o,--output", arguments->output, "the file; - for standard output")->type_name("OUT.glb")->required();
  addPictureOptions(app, arguments->picture, changing);
  return [arguments] { return runExport(*arguments); };
}

}  // namespace facet::commands
