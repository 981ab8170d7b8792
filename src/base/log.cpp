#include "base/log.hpp"

#include <atomic>
#include <cstdio>
#include <string>

namespace facet::log {

namespace {
std::atomic<Level> threshold = Level::info;
const char* prefix(Level level) {
  switch (level) {
    case Level::error:
      return "error: ";
    case Level::warning:
      return "warning: ";
    case Level::debug:
      return "debug: ";
    default:
      return "";
  }
}
}  // namespace

void setLevel(Level value) { threshold = value; }
Level level() { return threshold; }

void write(Level level, std::string_view text) {
  if (level > threshold) return;
  std::string line = "facet: ";
  line += prefix(level);
  line += text;
  line += '\n';
  std::fwrite(line.data(), 1, line.size(), stderr);  // one call, so that lines of several threads do not mix
}

}  // namespace facet::log
