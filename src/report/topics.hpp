#pragma once

// What `facet report` is about: tables and plots by topic, all of them measured or computed when asked for.

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "report/plot.hpp"
#include "report/table.hpp"

namespace facet::frame {
class Session;
}

namespace facet::report {

// One picture.
struct NamedPlot {
  std::string name;         // of its file, without .svg
  std::vector<Plot> plots;  // below each other; the first one's title is the picture's
};

struct Report {
  std::vector<Table> tables;
  std::vector<NamedPlot> plots;
};

struct ReportInput {
  std::string environment = "builtin:studio";  // a file, or "builtin:NAME"
  std::string model;                           // of pictures; empty: the topic's own
  std::optional<int> size, samples;  // of pictures along an edge [px], of the reference's pixels; none: the topic's own
  std::optional<int> repeat;         // frames that are timed; none: the topic's own
  frame::Session* session = nullptr;                                             // of topics that need OpenGL
  std::string shaderDir;                                                         // empty: the embedded shaders
  std::function<void(const std::string&)> progress = [](const std::string&) {};  // what is measured now
  std::function<void(const std::string&)> warn = [](const std::string&) {};      // perhaps the same several times
  std::function<void(size_t topics, size_t all)> measured = [](size_t, size_t) {};
};

using ReportPart = Result<Report> (*)(const ReportInput& input);
void append(Report& report, Report more);
// What several parts measure, in their order, in one.
Result<Report> joined(std::span<const ReportPart> parts, const ReportInput& input);

struct Topic {
  std::string_view name;  // as `facet report` takes it
  std::string_view summary;
  bool needsOpenGL = false;
  ReportPart make;
  std::string_view tables;           // that it makes, by spaces: a wrong name is told before anything is measured
  std::string_view usualModel = {};  // of its pictures; empty: it draws none
  bool underEnvironment = false;     // without OpenGL, too
};
bool makesTable(const Topic& topic, std::string_view table);
// Of the topics in their order, each of its usual model where input names none.
Result<Report> reportOf(std::span<const Topic* const> topics, const ReportInput& input);

std::span<const Topic> reportTopics();

}  // namespace facet::report
