#include <CLI/CLI.hpp>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "base/nearest.hpp"
#include "commands/commands.hpp"
#include "commands/option_text.hpp"
#include "report/models.hpp"

namespace facet::commands {

namespace {

struct ReportArguments {
  std::string topic, format = "markdown", output;
};

using Write = std::string (*)(const std::vector<report::Table>&);
constexpr std::pair<std::string_view, Write> formats[] = {
    {"markdown", report::markdown}, {"csv", report::csv}, {"json", report::json}};

int runReport(const ReportArguments& arguments) {
  std::vector<std::string_view> names;
  const report::Topic* topic = nullptr;
  for (const report::Topic& candidate : report::reportTopics()) {
    names.push_back(candidate.name);
    if (candidate.name == arguments.topic) topic = &candidate;
  }
  if (!topic)
    return badInput({{}, inQuotes(arguments.topic), "there is no such topic", suggestion(arguments.topic, names)});
  std::vector<std::string_view> formatNames;
  Write write = nullptr;
  for (const auto& [name, function] : formats) {
    formatNames.push_back(name);
    if (name == arguments.format) write = function;
  }
  if (!write)
    return badInput(
        {{}, "--format", inQuotes(arguments.format) + " is not known", suggestion(arguments.format, formatNames)});
  const std::string text = write(topic->make());
  if (arguments.output.empty()) {
    std::cout << text << std::flush;
    return exitGood;
  }
  std::ofstream file(arguments.output, std::ios::binary);
  file << text;
  file.close();
  if (!file) return badInput({arguments.output, {}, "cannot be written", "choose a folder that exists and is yours"});
  return exitGood;
}

}  // namespace

std::function<int()> addReport(CLI::App& app) {
  auto arguments = std::make_shared<ReportArguments>();
  std::string topics = "what it is about:";
  for (const report::Topic& topic : report::reportTopics())
    topics += (topics.back() == ':' ? " " : "; ") + std::string(topic.name) + " (" + std::string(topic.summary) + ")";
  app.add_option("topic", arguments->topic, topics)->required()->type_name("TOPIC");
  app.add_option("--format", arguments->format, "markdown, csv or json (markdown)")->type_name("NAME");
  app.add_option("-o,--output", arguments->output, "a file in the place of the terminal")->type_name("FILE");
  return [arguments] { return runReport(*arguments); };
}

}  // namespace facet::commands
