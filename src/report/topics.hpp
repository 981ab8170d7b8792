#pragma once

// What `facet report` is about: tables and plots by topic, all of them measured or computed when asked for.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "report/table.hpp"

namespace facet::frame {
class Session;
}

namespace facet::report {

// An SVG picture.
struct NamedPlot {
  std::string name;   // of its file, without .svg
  std::string title;  // a line above it
  std::string svg;
};

struct Report {
  std::vector<Table> tables;
  std::vector<NamedPlot> plots;
};

struct ReportInput {
  std::string environment = "builtin:studio";                                    // a file, or "builtin:NAME"
  std::string model;                                                             // of pictures; empty: the topic's own
  frame::Session* session = nullptr;                                             // of topics that need OpenGL
  std::string shaderDir;                                                         // empty: the embedded shaders
  std::function<void(const std::string&)> progress = [](const std::string&) {};  // what is measured now
};

// Of the topics that show materials and light, unless another is asked for.
inline constexpr const char* usualModel = "builtin:spheres";
inline std::string modelOr(const ReportInput& input, const char* usual) {
  return input.model.empty() ? usual : input.model;
}

// What several parts measure, in their order, in one.
using ReportPart = Result<Report> (*)(const ReportInput& input);
Result<Report> joined(std::span<const ReportPart> parts, const ReportInput& input);

struct Topic {
  std::string_view name;  // as `facet report` takes it
  std::string_view summary;
  bool needsOpenGL = false;
  ReportPart make;
};
std::span<const Topic> reportTopics();

}  // namespace facet::report
