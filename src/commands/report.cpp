#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/interrupt.hpp"
#include "base/log.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "commands/write_tables.hpp"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "report/topics.hpp"

namespace facet::commands {

namespace {

struct ReportArguments {
  std::string topic, table, format, output, environment, model, shaderDir;
  std::optional<int> size, samples, repeat;  // of pictures
  bool noSandbox = false;
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

std::vector<std::string_view> tablesOf(const std::vector<const report::Topic*>& topics) {
  std::vector<std::string_view> names;
  for (const report::Topic* topic : topics)
    for (const std::string_view name : split(topic->tables, ' ')) names.push_back(name);
  return names;
}

// Those of them that make the table; told before anything is measured.
Result<std::vector<const report::Topic*>> topicsOfTable(std::vector<const report::Topic*> topics,
                                                        const std::string& table) {
  std::vector<const report::Topic*> makers;
  for (const report::Topic* topic : topics)
    if (report::makesTable(*topic, table)) makers.push_back(topic);
  if (table.empty()) return topics;
  if (makers.empty())
    return fail({}, "--table", "there is no table " + inQuotes(table), suggestion(table, tablesOf(topics)));
  return makers;
}

// Of what goes to the terminal or into one file: by --format, else by the file's ending. Nothing: -o is a folder,
// because it is one, or ends in a slash, or has no ending.
Result<std::optional<TableFormat>> chosenFormat(const ReportArguments& arguments) {
  if (arguments.output.empty()) return tableFormat(arguments.format);
  const std::filesystem::path path(arguments.output);
  std::error_code error;
  if (std::filesystem::is_directory(path, error) || !path.has_filename()) {
    if (arguments.format.empty()) return std::nullopt;
    return fail(arguments.output, "--format", "a folder gets all formats", "leave --format out, or name a file");
  }
  if (!arguments.format.empty()) return tableFormat(arguments.format);
  const std::string extension = path.extension().string();
  if (extension.empty()) return std::nullopt;
  for (const TableFormatRow& row : tableFormats())
    if (extension == row.extension) return row.format;
  return fail(arguments.output, "-o", "a report is no " + extension + " file",
              extension == ".svg" ? "name a folder: it gets the plots as SVG beside the tables"
                                  : "end it in .md, .csv or .json, or name a folder");
}

Origin originOf(const report::ReportInput& input, const std::vector<const report::Topic*>& topics) {
  Origin origin = input.session ? gl::originOn(input.session->context()) : originOfProcess();
  if (input.session || std::ranges::any_of(topics, &report::Topic::underEnvironment))
    origin.environment = input.environment;
  if (!input.session) return origin;
  origin.model = input.model.empty() && topics.size() == 1 ? std::string(topics.front()->usualModel) : input.model;
  origin.seed = 0;
  return origin;
}

void confineTo(const ReportArguments& arguments, bool folder) {
  frame::PictureSettings settings;
  settings.sources.environment = arguments.environment, settings.sources.shaderDir = arguments.shaderDir;
  Needed needed;
  needPicture(needed, arguments.model, settings);
  folder ? needOutputFolder(needed, arguments.output) : needOutput(needed, arguments.output);
  confine(std::move(needed), true);
}

std::string measuredOf(size_t topics, size_t all) {
  return std::to_string(topics) + " of " + std::to_string(all) + " topics measured, and no report is written";
}

int runReport(const ReportArguments& arguments) {
  const auto asked = chosenTopics(arguments.topic);
  if (!asked) return badInput(asked.error());
  const auto topics = topicsOfTable(*asked, arguments.table);
  if (!topics) return badInput(topics.error());
  const Result<std::optional<TableFormat>> format = chosenFormat(arguments);
  if (!format) return badInput(format.error());
  report::ReportInput input;
  if (!arguments.environment.empty()) input.environment = arguments.environment;
  if (!arguments.model.empty()) input.model = arguments.model;
  input.shaderDir = arguments.shaderDir;
  input.size = arguments.size, input.samples = arguments.samples, input.repeat = arguments.repeat;
  input.progress = [](const std::string& what) { log::info(what); };
  std::set<std::string> told;
  input.warn = [&](const std::string& what) {
    if (told.insert(what).second) log::warning(what);
  };
  if (!arguments.noSandbox) keepDriverCacheApart();
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
  if (!arguments.noSandbox) confineTo(arguments, !*format);
  LastWords lastWords(measuredOf(0, topics->size()));
  if (!*format) {
    const std::vector<std::string_view> made =
        arguments.table.empty() ? tablesOf(*topics) : std::vector<std::string_view>{arguments.table};
    if (const Result<void> begun = beginReport(arguments.output, made); !begun) return badInput(begun.error());
  }
  input.measured = [&](size_t done, size_t all) { lastWords.change(measuredOf(done, all)); };
  Result<report::Report> made = report::reportOf(*topics, input);
  if (!made) return badInput(made.error());
  Result<std::vector<report::Table>> tables = chosenTables(std::move(made->tables), arguments.table);
  if (!tables) return badInput(tables.error());
  made->tables = std::move(*tables);
  const Origin origin = originOf(input, *topics);
  if (!*format) {
    const Result<void> written = writeReport(arguments.output, *made, origin);
    return written ? exitGood : badInput(written.error());
  }
  const Result<std::string> text = tablesText(**format, made->tables, origin);
  if (!text) return badInput(text.error());
  if (arguments.output.empty()) {
    std::cout << *text << std::flush;
    return exitGood;
  }
  const Result<void> written = writeText(arguments.output, *text);
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
  const auto whole = [&](const char* name, std::optional<int>& value, const char* help, int least, int most) {
    app.add_option(name, value, help)->type_name("N")->check(CLI::Range(least, most).description(""));
  };
  whole("--size", arguments->size, "of pictures, pixels along an edge (the topic's own, 48 to 512)", 1, 16384);
  whole("--samples", arguments->samples, "a pixel of the pictures that others are compared with (256 to 512)", 2, 4096);
  whole("--repeat", arguments->repeat, "further frames, for timing (3 or 4)", 1, 1000);
  app.add_option("--table", arguments->table, "only that one of its tables (all)")->type_name("TABLE");
  app.add_option("--format", arguments->format, "how tables are written (by the file's ending, else markdown)")
      ->type_name(alternatives(tableFormatNames()));
  app.add_option("-o,--output", arguments->output,
                 "a file (.md, .json, or .csv of one table) in the place of the terminal; a name without ending is a "
                 "folder for "
                 "all of them, each table as CSV, and the plots")
      ->type_name("PATH");
  app.add_option("--shader-dir", arguments->shaderDir, "read the shaders from here")->type_name("DIR");
  addNoSandbox(app, arguments->noSandbox);
  return [arguments] { return runReport(*arguments); };
}

}  // namespace facet::commands
