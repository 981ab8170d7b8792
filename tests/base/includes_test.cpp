// Which folder of src/ may include which: data flows one way, and what is below knows nothing of what is above.

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path sourceFolder = fs::path(FACET_SOURCE_DIR) / "src";

// layout.h lies in shaders/: what GLSL and C++ read from one header.
const std::map<std::string, std::set<std::string>> allowed = {
    {"base", {}},
    {"optics", {"base"}},                                   // the truth: of nothing but numbers
    {"scene", {"base", "optics"}},                          // presets, directions of maps
    {"io", {"base", "optics", "scene"}},                    // measured BRDFs are optics'
    {"rays", {"base"}},                                     // triangles and boxes, whatever they are of
    {"gl", {"base"}},                                       // knows no scene
    {"shading", {"base", "optics", "scene", "gl"}},         // materials -> features -> programs
    {"ibl", {"base", "optics", "scene", "gl", "shading"}},  // an environment's tables: no files, no frame
    {"frame",
     {"base", "optics", "scene", "io", "rays", "gl", "shading", "ibl"}},  // reads what a picture's settings name
    {"compare", {"base", "optics", "io"}},                                // pictures, not how they came about
    {"selftest", {"base", "optics", "scene", "io", "gl", "shading", "ibl", "frame"}},
    {"report", {"base", "optics", "scene", "io", "gl", "shading", "ibl", "frame", "compare", "selftest"}},
    {"options", {"base", "optics", "io", "shading", "frame"}},  // the words that set what a picture reads
    {"library", {"base", "gl", "frame", "options"}},            // what other programs call
    // The window knows no command and no report.
    {"view", {"base", "optics", "scene", "io", "gl", "shading", "ibl", "frame", "compare", "options"}},
    {"commands",
     {"base", "optics", "scene", "io", "gl", "shading", "ibl", "frame", "compare", "selftest", "report", "options",
      "view"}},
};

std::string textOf(const fs::path& file) {
  std::stringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

std::vector<std::string> includesOf(const std::string& text) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("#include \"")) found.push_back(line.substr(10, line.find('"', 10) - 10));
  return found;
}

// By path below src/.
std::map<std::string, std::string> sources() {
  std::map<std::string, std::string> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(sourceFolder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".cpp" || extension == ".hpp")
      found[fs::relative(entry.path(), sourceFolder).generic_string()] = textOf(entry.path());
  }
  return found;
}

std::string folderOf(const std::string& path) {
  const size_t slash = path.find('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

// "optics/a.hpp includes scene/b.hpp"
std::vector<std::string> wrongIncludes(const std::map<std::string, std::string>& files) {
  std::vector<std::string> wrong;
  for (const auto& [path, text] : files) {
    const std::string from = folderOf(path);
    if (from.empty()) continue;  // main.cpp
    for (const std::string& include : includesOf(text)) {
      const std::string to = folderOf(include);
      if (to.empty() || to == from) continue;
      if (!allowed.contains(from) || !allowed.at(from).contains(to)) wrong.push_back(path + " includes " + include);
    }
  }
  return wrong;
}

// The first include of gl/ that a header reaches, as a chain; empty where there is none.
std::string wayToOpenGL(const std::map<std::string, std::string>& files, const std::string& header,
                        std::set<std::string>& seen) {
  for (const std::string& include : includesOf(files.at(header))) {
    if (folderOf(include) == "gl") return header + " -> " + include;
    if (!files.contains(include) || !seen.insert(include).second) continue;
    const std::string way = wayToOpenGL(files, include, seen);
    if (!way.empty()) return header + " -> " + way;
  }
  return {};
}

// What a header says before its first include.
bool promisesNoOpenGL(const std::string& text) {
  const std::string head = text.substr(0, text.find("#include"));
  return std::ranges::any_of(
      std::vector<std::string>{"no OpenGL", "No OpenGL", "nor OpenGL", "never calls OpenGL", "nor\n// OpenGL"},
      [&](const std::string& words) { return head.find(words) != std::string::npos; });
}

}  // namespace

TEST_CASE("No folder includes what is above it", "[base][includes]") {
  const std::map<std::string, std::string> files = sources();
  REQUIRE(files.size() > 300);
  CHECK(wrongIncludes(files) == std::vector<std::string>());
  for (const auto& [path, text] : files) {
    INFO(path);
    if (!folderOf(path).empty()) CHECK(allowed.contains(folderOf(path)));
  }
  // The arrows themselves have no cycle: whoever is allowed comes later in some order.
  std::set<std::string> placed;
  for (size_t round = 0; round < allowed.size(); ++round)
    for (const auto& [folder, below] : allowed)
      if (std::ranges::includes(placed, below)) placed.insert(folder);
  CHECK(placed.size() == allowed.size());
}

TEST_CASE("A wrong include is found", "[base][includes]") {
  std::map<std::string, std::string> files = sources();
  files["optics/reference.hpp"] += "\n#include \"scene/model.hpp\"\n";
  files["view/panel.cpp"] += "\n#include \"commands/jobs.hpp\"\n";
  CHECK(wrongIncludes(files) == std::vector<std::string>{"optics/reference.hpp includes scene/model.hpp",
                                                         "view/panel.cpp includes commands/jobs.hpp"});
}

TEST_CASE("What promises no OpenGL reaches none", "[base][includes]") {
  const std::map<std::string, std::string> files = sources();
  size_t promises = 0;
  for (const auto& [path, text] : files) {
    if (!path.ends_with(".hpp") || !promisesNoOpenGL(text)) continue;
    ++promises;
    std::set<std::string> seen;
    CHECK(wayToOpenGL(files, path, seen) == "");
  }
  CHECK(promises >= 9);
}

// A window's user reads these messages, too.
TEST_CASE("Below the commands nobody names an option of the command line", "[base][includes]") {
  const std::set<std::string> below = {"base", "optics", "scene", "io", "gl", "shading", "ibl", "frame", "view"};
  std::vector<std::string> named;
  for (const auto& [path, text] : sources()) {
    if (!below.contains(folderOf(path)) || path == "view/file_dialog.cpp") continue;  // that has another program's
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      const size_t quote = line.find('"'), comment = line.find("//");
      const size_t option = quote == std::string::npos ? quote : line.find("--", quote);
      if (option == std::string::npos || comment < option || option + 2 >= line.size()) continue;
      const char before = line[option - 1], after = line[option + 2];
      if ((before == '"' || before == ' ') && after >= 'a' && after <= 'z') named.push_back(path + ": " + line);
    }
  }
  CHECK(named == std::vector<std::string>());
}

// The date that a file says it was made on, the name of a screenshot and the time beside a message are told to people;
// what a sweep and the caches ask is when files were written. All else is measured with a clock that nobody sets.
TEST_CASE("No clock that people set decides anything", "[base][includes]") {
  const std::map<std::string, int> known = {{"base/origin.cpp", 2},
                                            {"base/disk_cache.cpp", 1},
                                            {"report/visibility.cpp", 1},
                                            {"view/screenshot.cpp", 1},
                                            {"view/viewer_state.cpp", 1}};
  std::map<std::string, int> found;
  for (const auto& [path, text] : sources())
    for (const std::string clock : {"system_clock", "high_resolution_clock", "file_time_type::clock", "file_clock",
                                    "utc_clock", "std::time(", "gettimeofday", "CLOCK_REALTIME"})
      for (size_t at = text.find(clock); at != std::string::npos; at = text.find(clock, at + 1)) ++found[path];
  CHECK(found == known);
}
