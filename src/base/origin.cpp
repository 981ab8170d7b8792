#include "base/origin.hpp"

#include <chrono>
#include <ctime>
#include <fstream>
#include <iterator>

#include "base/text.hpp"

namespace facet {

namespace {

std::string commandOfProcess() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  const std::string words{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  std::string line;
  for (size_t at = 0; at < words.size();) {
    const size_t end = std::min(words.find('\0', at), words.size());
    std::string word = words.substr(at, end - at);
    if (at == 0) word = "facet";  // not where it lies
    line += (line.empty() ? "" : " ") + shellWord(word);
    at = end + 1;
  }
  return line;
}

std::string dateNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

Origin originOfProcess() {
  return {.version = programVersion(),
          .commit = programCommit(),
          .renderer = {},
          .driver = {},
          .date = dateNow(),
          .command = commandOfProcess()};
}

std::vector<std::pair<std::string, std::string>> originFields(const Origin& origin) {
  return {{"facet", origin.version},
          {"commit", origin.commit},
          {"renderer", origin.renderer},
          {"driver", origin.driver},
          {"date", origin.date},
          {"command", origin.command},
          {"environment", origin.environment},
          {"model", origin.model},
          {"seed", origin.seed ? std::to_string(*origin.seed) : ""}};
}

}  // namespace facet
