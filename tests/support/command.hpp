#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace facet::test {

struct Outcome {
  int status = -1;   // exit status; -1: it did not end by itself
  std::string text;  // standard output and standard error, as they came
};

// Runs the built facet with these words.
Outcome runFacet(const std::vector<std::string>& words);

// Runs a line of shell.
Outcome runShell(const std::string& line);

// A folder of its own that goes away with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  std::string write(const std::string& name, const std::string& content) const;  // returns its path

 private:
  std::filesystem::path path_;
};

}  // namespace facet::test
