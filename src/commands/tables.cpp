#include <CLI/CLI.hpp>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/write_tables.hpp"
#include "frame/settings.hpp"
#include "gl/context.hpp"
#include "io/sources.hpp"
#include "report/table_images.hpp"
#include "shading/programs.hpp"

namespace facet::commands {

namespace {

struct TablesArguments {
  std::string environment = "builtin:studio", output, format, shaderDir;
  bool noSandbox = false;
};

int runTables(const TablesArguments& arguments) {
  const Result<TableFormat> format = tableFormat(arguments.format);
  if (!format) return badInput(format.error());
  if (!arguments.noSandbox) keepDriverCacheApart();
  const Result<gl::HeadlessContext> context = gl::HeadlessContext::create(false);
  if (!context) {
    log::error(describe(context.error()));
    return exitNoOpenGL;
  }
  if (!arguments.noSandbox) {
    frame::PictureSettings settings;
    settings.sources.environment = arguments.environment, settings.sources.shaderDir = arguments.shaderDir;
    Needed needed;
    needPicture(needed, {}, settings);
    needOutputFolder(needed, arguments.output);
    confine(std::move(needed), false);
  }
  Notes notes;
  const Result<scene::Environment> environment = io::loadEnvironmentSource(arguments.environment, notes);
  if (!environment) return badInput(environment.error());
  for (const Note& note : notes)
    if (note.severity == Note::Severity::warning) log::warning(arguments.environment + ": " + note.text);
  shading::ProgramStore programs(shading::shaderReader(arguments.shaderDir), {}, {});
  const Result<std::vector<report::TableImage>> images = report::tableImages(*environment, programs);
  if (!images) return badInput(images.error());
  if (const Result<void> good = gl::checkDriver("the tables"); !good) return badInput(good.error());

  const std::filesystem::path folder = arguments.output;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return badInput({folder.string(), {}, "cannot be made: " + error.message(), "choose another folder"});
  Origin origin = gl::originOn(context->info());
  origin.environment = arguments.environment;
  Origin ofPictures = origin;
  ofPictures.date.clear();
  LastWords lastWords("no table was written");
  for (size_t i = 0; i < images->size(); ++i) {
    const report::TableImage& image = (*images)[i];
    if (const Result<void> r = io::writeExr(folder / (image.name + ".exr"), image.image, ofPictures); !r)
      return badInput(r.error());
    lastWords.change(std::to_string(i + 1) + " of " + std::to_string(images->size()) + " tables written");
  }
  const Result<std::string> text = tablesText(*format, {report::tableImagesTable(*images)}, origin);
  if (!text) return badInput(text.error());
  std::cout << *text << std::flush;
  return exitGood;
}

}  // namespace

std::function<int()> addTables(CLI::App& app) {
  auto arguments = std::make_shared<TablesArguments>();
  app.add_option("--env", arguments->environment, "the environment to filter (builtin:studio)")
      ->type_name("FILE|builtin:NAME");
  app.add_option("-o,--output", arguments->output, "a folder, which gets an EXR for each table")
      ->type_name("DIR")
      ->required();
  app.add_option("--format", arguments->format, "how the list of them is written (markdown)")
      ->type_name(alternatives(tableFormatNames()));
  app.add_option("--shader-dir", arguments->shaderDir, "read the shaders from here")->type_name("DIR");
  addNoSandbox(app, arguments->noSandbox);
  return [arguments] { return runTables(*arguments); };
}

}  // namespace facet::commands
