// Files that were made to do harm, clocks that are set, drivers that refuse whatever is asked for: as a user meets
// them.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/skip.hpp"

using namespace facet;
using test::Outcome;

namespace {

namespace fs = std::filesystem;

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

struct Spent {
  Outcome outcome;
  double seconds = 0;  // of the processor, which other programs do not lengthen
  double megabytes = 0;
};

// In a process of its own, since what children took is told of all of them together.
Spent spentOn(const std::vector<std::string>& words) {
  const test::TemporaryFolder folder;
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    Spent spent;
    spent.outcome = test::runFacet(words);
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    const double seconds = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                           1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    const std::string told = std::to_string(spent.outcome.status) + " " + std::to_string(seconds) + " " +
                             std::to_string(static_cast<double>(used.ru_maxrss) / 1024) + " " + spent.outcome.text;
    const bool whole = ::write(ends[1], told.data(), told.size()) == static_cast<ssize_t>(told.size());
    ::_exit(whole ? 0 : 1);
  }
  ::close(ends[1]);
  std::string told;
  char buffer[4096];
  for (ssize_t n = 0; (n = ::read(ends[0], buffer, sizeof buffer)) > 0;) told.append(buffer, static_cast<size_t>(n));
  ::close(ends[0]);
  int status = -1;
  ::waitpid(child, &status, 0);
  REQUIRE(status == 0);
  Spent spent;
  int length = 0;
  REQUIRE(std::sscanf(told.c_str(), "%d %lf %lf %n", &spent.outcome.status, &spent.seconds, &spent.megabytes,
                      &length) == 3);
  spent.outcome.text = told.substr(static_cast<size_t>(length));
  return spent;
}

}  // namespace

TEST_CASE("hostile files: each is refused in one sentence, within a second and 200 MB", "[gl]") {
  const std::string folder = test::sharedFile("cases/hostile");
  if (folder.empty()) return;
  const test::TemporaryFolder out;
  const std::vector<std::string> drawn = {"--size",   "32x32", "--samples",      "1", "--visibility", "none",
                                          "--strict", "-o",    out.file("a.png")};
  const auto render = [&](std::vector<std::string> words) {
    words.insert(words.begin(), "render");
    words.insert(words.end(), drawn.begin(), drawn.end());
    return words;
  };
  const Spent usual = spentOn(render({"builtin:metals"}));  // what the driver takes for itself
  REQUIRE(usual.outcome.status == 0);
  size_t count = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string file = entry.path().string(), ending = entry.path().extension().string();
    std::vector<std::vector<std::string>> attempts;
    if (ending == ".gltf")
      attempts = {{"inspect", file, "--strict"}, render({file, "--env", "none", "--lights", "demo"})};
    if (ending == ".jpg") attempts = {{"normalmap", file, "-o", out.file("n.png")}};
    if (ending == ".exr")
      attempts = {render({"builtin:metals", "--env", file}), {"tables", "--env", file, "-o", out.file("t")}};
    CHECK_FALSE(attempts.empty());
    for (const std::vector<std::string>& words : attempts) {
      const Spent spent = spentOn(words);
      INFO(words.front() << " " << file << ": " << spent.seconds << " s, " << spent.megabytes << " MB\n"
                         << spent.outcome.text);
      CHECK(spent.outcome.status == 2);
      CHECK(holds(spent.outcome.text, entry.path().filename().string()));
      CHECK(spent.seconds < 1);
      CHECK(spent.megabytes < std::max(200.0, usual.megabytes + 100));
      ++count;
    }
  }
  CHECK(count >= 9);
}

TEST_CASE("clocks: a clock on the wall that is set time and again changes nothing", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", std::string(R"({"defaults": {"size": "16x16", "samples": 1}, "jobs": [
    {"name": "a", "model": "builtin:metals"}, {"name": "b", "model": "builtin:spheres"}]})"));
  const std::string jumps = "LD_PRELOAD=" + test::wallClockPath() + " " + test::facetPath() + " ";
  const Outcome dated = test::runShell("LD_PRELOAD=" + test::wallClockPath() + " date +%s; date +%s");
  REQUIRE(std::abs(std::stol(dated.text) - std::stol(dated.text.substr(dated.text.find('\n')))) > 80'000);
  const Outcome suite = test::runShell(jumps + "regress " + folder.path().string() + " --accept --timeout 60");
  INFO(suite.text);
  CHECK(suite.status == 0);
  const Outcome drawn = test::runShell(jumps + "render builtin:metals --size 16x16 --samples 1 --stats " +
                                       folder.file("a.json") + " -o " + folder.file("a.png"));
  CHECK(drawn.status == 0);
  CHECK(io::readImage(folder.file("a.png")));
  const auto stats = nlohmann::json::parse(test::runShell("cat " + folder.file("a.json")).text);
  const nlohmann::json flat = stats.flatten();
  for (const auto& [key, value] : flat.items()) {
    if (!value.is_number() || !holds(key, "Ms")) continue;
    INFO(key << " " << value);
    CHECK(value.get<double>() >= 0);
    CHECK(value.get<double>() < 600e3);
  }
}

TEST_CASE("faults: whichever texture, buffer or target a driver refuses, there is a sentence and no picture", "[gl]") {
  const test::TemporaryFolder folder;
  test::GltfBuilder b = test::triangle();
  b.append("images", {{"uri", test::dataUri(test::pngBytes(4, 4, 3, 8, std::vector<uint8_t>(48, 99)), "image/png")}});
  b.append("textures", {{"source", 0}});
  b.append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  auto& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["material"] = 0;
  primitive["attributes"]["TEXCOORD_0"] = b.add(std::vector<float>{0, 0, 1, 0, 0, 1}, test::floatType, "VEC2");
  const std::string model = folder.write("m.glb", b.glb()).string(), png = folder.file("a.png");
  const std::string render = " LD_PRELOAD=" + test::glFaultsPath() + " " + test::facetPath() + " render " + model +
                             " --size 16x16 --samples 1 --no-cache --overlay wireframe --visibility none -o " + png;
  size_t refused = 0;
  for (const std::string kind : {"textures", "buffers", "targets"}) {
    int n = 1;
    for (; n < 100; ++n) {
      fs::remove(png);
      const Outcome outcome = test::runShell("FACET_GL_FAULT='" + kind + " " + std::to_string(n) + "'" + render);
      if (outcome.status == 0) break;
      INFO(kind << " " << n << ": " << outcome.text);
      CHECK(outcome.status == 2);
      CHECK(holds(outcome.text, "OpenGL: the driver's memory does not suffice for "));
      CHECK_FALSE(fs::exists(png));
      ++refused;
    }
    INFO(kind);
    CHECK(n > 1);
    CHECK(n < 100);
    CHECK(io::readImage(png));
  }
  CHECK(refused >= 10);
}
