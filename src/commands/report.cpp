#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/write_tables.hpp"
#include "frame/session.hpp"
#include "report/topics.hpp"

namespace facet::commands {

namespace {

struct ReportArguments {
  std::string topic, format, output, environment, model, shaderDir;
};

// The topic of that name; none given: all of them.
Result<std::vector<const report::Topic*>> chosenTopics(const std::string& wanted) {
  std::vector<const report::Topic*> all;
  std::vector<std::string_view> names;
  for (const report::Topic& topic : report::reportTopics()) {
    if (topic.name == wanted) return std::vector{&topic};
    all.push_back(&topic);
    names.push_back(topic.name);
  }
  if (wanted.empty()) return all;
  return fail({}, inQuotes(wanted), "there is no such topic", suggestion(wanted, names));
}

// Of what goes to the terminal or into one file: by --format, else by the file's ending. Null: -o is a folder, because
// it is one, or ends in a slash, or has no ending.
Result<const TableFormat*> chosenFormat(const ReportArguments& arguments) {
  if (arguments.output.empty()) return tableFormat(arguments.format);
  const std::filesystem::path path(arguments.output);
  std::error_code error;
  if (std::filesystem::is_directory(path, error) || !path.has_filename()) {
    if (arguments.format.empty()) return nullptr;
    return fail(arguments.output, "--format", "a folder gets all formats", "leave --format out, or name a file");
  }
  if (!arguments.format.empty()) return tableFormat(arguments.format);
  const std::string extension = path.extension().string();
  if (extension.empty()) return nullptr;
  for (const TableFormat& format : tableFormats())
    if (extension == format.extension) return &format;
  return fail(arguments.output, "-o", "a report is no " + extension + " file",
              extension == ".svg" ? "name a folder: it gets the plots as SVG beside the tables"
                                  : "end it in .md, .csv or .json, or name a folder");
}

// report.md with the plots below the tables, report.csv, report.json, a file for each plot.
Result<void> writeFolder(const std::filesystem::path& folder, const report::Report& made) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fail(folder.string(), {}, "cannot be made: " + error.message(), "choose another folder");
  for (const TableFormat& format : tableFormats()) {
    std::string text = format.write(made.tables);
    if (format.write == report::markdown)
      for (const report::NamedPlot& plot : made.plots)
        text += "\n### " + plot.title + "\n\n![" + plot.title + "](" + plot.name + ".svg)\n";
    if (Result<void> r = writeText(folder / ("report" + std::string(format.extension)), text); !r) return r;
  }
  for (const report::NamedPlot& plot : made.plots)
    if (Result<void> r = writeText(folder / (plot.name + ".svg"), plot.svg); !r) return r;
  return {};
}

int runReport(const ReportArguments& arguments) {
  const auto topics = chosenTopics(arguments.topic);
  if (!topics) return badInput(topics.error());
  const Result<const TableFormat*> format = chosenFormat(arguments);
  if (!format) return badInput(format.error());
  report::ReportInput input;
  if (!arguments.environment.empty()) input.environment = arguments.environment;
  if (!arguments.model.empty()) input.model = arguments.model;
  input.shaderDir = arguments.shaderDir;
  input.progress = [](const std::string& what) { log::info(what); };
  std::unique_ptr<frame::Session> session;
  if (std::ranges::any_of(*topics, &report::Topic::needsOpenGL)) {
    Result<std::unique_ptr<frame::Session>> made = frame::Session::create({.shaderDir = arguments.shaderDir});
    if (!made) {
      log::error(describe(made.error()));
      return exitNoOpenGL;
    }
    session = std::move(*made);
    input.session = session.get();
  }
  std::vector<report::ReportPart> parts;
  for (const report::Topic* topic : *topics) parts.push_back(topic->make);
  const Result<report::Report> made = report::joined(parts, input);
  if (!made) return badInput(made.error());
  const report::Report& whole = *made;
  if (*format && arguments.output.empty()) {
    std::cout << (*format)->write(whole.tables) << std::flush;
    return exitGood;
  }
  const Result<void> written =
      *format ? writeText(arguments.output, (*format)->write(whole.tables)) : writeFolder(arguments.output, whole);
  return written ? exitGood : badInput(written.error());
}

}  // namespace

std::function<int()> addReport(CLI::App& app) {
  auto arguments = std::make_shared<ReportArguments>();
  std::string topics = "what it is about (all):";
  for (const report::Topic& topic : report::reportTopics())
    topics += (topics.back() == ':' ? " " : "; ") + std::string(topic.name) + " (" + std::string(topic.summary) + ")";
  app.add_option("TOPIC", arguments->topic, topics)->type_name("TOPIC");
  app.add_option("--env", arguments->environment, "the environment to measure with (builtin:studio)")
      ->type_name("FILE|builtin:NAME");
  app.add_option("MODEL,--model", arguments->model,
                 "the model of the pictures that are compared (builtin:spheres; frame: builtin:marbles; visibility: "
                 "builtin:poster)")
      ->type_name("MODEL");
  app.add_option("--format", arguments->format, "how tables are written (by the file's ending, else markdown)")
      ->type_name(alternatives(tableFormatNames()));
  app.add_option(
         "-o,--output", arguments->output,
         "a file (.md, .csv, .json) in the place of the terminal; a name without ending is a folder for all of them "
         "and the plots")
      ->type_name("PATH");
  app.add_option("--shader-dir", arguments->shaderDir, "read the shaders from here")->type_name("DIR");
  return [arguments] { return runReport(*arguments); };
}

}  // namespace facet::commands
