#include "support/skip.hpp"

#include <filesystem>
#include <iostream>

namespace facet::test {

namespace {
bool wasSkipped = false;
}

void skip(const std::string& reason) {
  wasSkipped = true;
  std::cout << "skipped: " << reason << std::endl;
}

bool skipped() { return wasSkipped; }

std::string sharedFile(const std::string& relative) {
  const std::filesystem::path path = std::filesystem::path(FACET_SHARED_DIR) / relative;
  if (std::filesystem::exists(path)) return path.string();
  skip("shared test data not found: " + relative);
  return {};
}

}  // namespace facet::test
