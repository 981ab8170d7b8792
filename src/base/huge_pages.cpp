#include "base/huge_pages.hpp"

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

namespace facet {

namespace {

constexpr const char* tunablesName = "GLIBC_TUNABLES";
constexpr std::string_view hugePages = "glibc.malloc.hugetlb";

std::string modeHere() {
  std::ifstream file("/sys/kernel/mm/transparent_hugepage/enabled");
  return hugePageMode(std::string(std::istreambuf_iterator<char>(file), {}));
}

std::string_view tunablesHere() {
  const char* value = std::getenv(tunablesName);
  return value ? value : "";
}

}  // namespace

std::string hugePageMode(std::string_view text) {
  const size_t from = text.find('['), to = text.find(']');
  return from < to && to != text.npos ? std::string(text.substr(from + 1, to - from - 1)) : std::string();
}

std::string tunablesWithHugePages(std::string_view tunables) {
  if (tunables.find(hugePages) != tunables.npos) return {};
  return std::string(tunables) + (tunables.empty() ? "" : ":") + std::string(hugePages) + "=1";
}

void askForHugePages([[maybe_unused]] char** arguments) {
#ifndef __SANITIZE_ADDRESS__  // that has an allocator of its own
  const std::string tunables = tunablesWithHugePages(tunablesHere());
  if (tunables.empty() || modeHere() != "madvise") return;
  if (::setenv(tunablesName, tunables.c_str(), 1) == 0) ::execv("/proc/self/exe", arguments);
#endif
}

std::string hugePagesHere() {
  const std::string mode = modeHere();
  if (mode == "always") return mode;
  const bool asked = tunablesHere().find(std::string(hugePages) + "=1") != std::string_view::npos;
  return mode == "madvise" && asked ? "asked for" : "no";
}

}  // namespace facet
