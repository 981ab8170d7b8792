#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "io/bump.hpp"

namespace facet::commands {

namespace {

struct NormalMapArguments {
  std::string heights, output, scale = "0.02";
  bool wrap = false, noSandbox = false;
};

int runNormalMap(const NormalMapArguments& arguments) {
  const Result<double> scale = parseNumber(arguments.scale, -1000, 1000);
  if (!scale) return badInput({{}, "--scale", scale.error().problem, scale.error().remedy});
  if (!arguments.noSandbox) {
    Needed needed;
    needFiles(needed, arguments.heights);
    needOutput(needed, arguments.output);
    confine(std::move(needed), false);
  }
  const Result<scene::HeightMap> map = io::readHeights(arguments.heights, *scale);
  if (!map) return badInput(map.error());
  const Result<void> written = io::writePng(arguments.output, io::encodeNormals(*map, arguments.wrap));
  return written ? exitGood : badInput(written.error());
}

}  // namespace

std::function<int()> addNormalMap(CLI::App& app) {
  const auto arguments = std::make_shared<NormalMapArguments>();
  app.add_option("HEIGHT", arguments->heights, "a grey picture, 8 or 16 bit; white is high")
      ->type_name("HEIGHT.png")
      ->required();
  app.add_option("-o,--output", arguments->output, "the normal map: PNG, 8 bit, +Y up as glTF has it")
      ->required()
      ->type_name("NORMAL.png");
  app.add_option("--scale", arguments->scale, "height of white above black, in widths of the map (0.02)")
      ->type_name("S");
  app.add_flag("--wrap", arguments->wrap, "the map repeats: slopes at its borders look across to the other side");
  addNoSandbox(app, arguments->noSandbox);
  return [arguments] { return runNormalMap(*arguments); };
}

}  // namespace facet::commands
