// What a disk, a driver, a signal or little memory does to facet, as a user runs it: a sentence, and files that are
// whole or not there.

#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "io/image.hpp"
#include "io/radiance.hpp"
#include "support/command.hpp"

using namespace facet;
using test::Outcome;

namespace {

namespace fs = std::filesystem;

bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string contents(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Files in the folder and below that no complete write leaves; the driver's own are not ours.
std::vector<std::string> remains(const fs::path& folder) {
  std::vector<std::string> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().string().find("/driver/") != std::string::npos) continue;
    const bool aside = entry.path().extension() == ".part" || entry.path().extension() == ".new";
    if (aside || (entry.is_regular_file() && entry.file_size() == 0)) found.push_back(entry.path().string());
  }
  return found;
}

// `before`: what the shell does first, or variables of the environment.
Outcome facetAfter(const std::string& before, const std::string& arguments) {
  return test::runShell(before + " " + test::facetPath() + " " + arguments);
}

bool isWholePicture(const fs::path& file) {
  if (file.extension() == ".exr") return io::readRadiance(file).has_value();
  return io::readImage(file).has_value();
}

const std::string small = " --size 32x32 --samples 1 --no-cache ";

}  // namespace

// ---- Disks ----------------------------------------------------------------------------------------------------------

TEST_CASE("faults: where no more can be written, what was there stays and a sentence says why", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string full = "ulimit -f 1;";  // 512 bytes of a file, less than any of these
  const auto refused = [&](const std::string& arguments, const std::string& name) {
    const std::string file = folder.file(name);
    folder.write(name, std::string("former"));
    const Outcome outcome = facetAfter(full, arguments + file);
    INFO(outcome.text);
    CHECK(outcome.status == 2);
    CHECK(says(outcome.text, file + ": cannot be written: File too large; check the folder, its permissions and the "
                                    "space left."));
    CHECK(contents(file) == "former");
  };
  refused("render builtin:metals" + small + "-o ", "a.png");
  refused("render builtin:metals" + small + "-o ", "a.exr");
  refused("report fresnel -o ", "a.md");
  refused("brdf --synthesize ggx-0.35 -o ", "a.binary");
  CHECK(remains(folder.path()).empty());
  const std::string png = folder.file("c.png");
  const Outcome stats = facetAfter("", "render builtin:metals" + small + "--stats /dev/full -o " + png);
  CHECK(stats.status == 2);
  CHECK(says(stats.text, "/dev/full: cannot be written: No space left on device"));
  CHECK(isWholePicture(png));
  const Outcome told = facetAfter("", "inspect builtin:metals > /dev/full");
  CHECK(told.status == 2);
  CHECK(says(told.text, "standard output: cannot be written: No space left on device."));
}

TEST_CASE("faults: a folder that nobody may write to", "[gl]") {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path() / "closed");
  fs::permissions(folder.path() / "closed", fs::perms(0500));
  const bool root = geteuid() == 0;  // who may write anywhere but there
  const std::string file = root ? "/proc/a.png" : folder.file("closed/a.png");
  const Outcome outcome = facetAfter("", "render builtin:metals" + small + "-o " + file);
  CHECK(outcome.status == 2);
  CHECK(says(outcome.text, file + ": cannot be written: "));
  folder.write("suite.json", std::string(R"({"jobs": [{"name": "a", "model": "builtin:metals", "size": "16x16"}]})"));
  const Outcome suite =
      facetAfter("", "regress " + folder.path().string() + " -o " + (root ? "/proc/results" : folder.file("closed/r")));
  CHECK(suite.status == 2);
  CHECK(says(suite.text, "cannot be made: "));
}

TEST_CASE("faults: a full disk never damages a baseline", "[gl]") {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::string& material) {
    folder.write("suite.json", R"({"defaults": {"size": "64x64", "samples": 1}, "jobs": [
      {"name": "a", "model": "builtin:spheres", "material": ")" +
                                   material + R"("}]})");
  };
  const std::string dir = folder.path().string();
  write("gold");
  REQUIRE(facetAfter("", "regress --accept " + dir).status == 0);
  const std::string before = contents(folder.path() / "baselines/a.png");
  REQUIRE(isWholePicture(folder.path() / "baselines/a.png"));
  write("copper");
  const auto attempt = [&](const std::string& how, const std::string& sentence) {
    const Outcome outcome = facetAfter(how, "regress --accept " + dir);
    INFO(outcome.text);
    CHECK(outcome.status == 2);
    CHECK(says(outcome.text, sentence));
    CHECK(contents(folder.path() / "baselines/a.png") == before);
  };
  attempt("ulimit -f 1;", "cannot be written: File too large");
  CHECK(remains(folder.path()).empty());
  // The picture can be written, the baseline cannot: its folder has become a file.
  fs::rename(folder.path() / "baselines", folder.path() / "kept");
  folder.write("baselines", std::string());
  const Outcome outcome = facetAfter("", "regress --accept " + dir);
  INFO(outcome.text);
  CHECK(outcome.status == 2);
  CHECK(says(outcome.text, "failed a: "));
  CHECK(says(contents(folder.path() / "results/report.json"), "\"failed\""));
}

TEST_CASE("faults: after power is lost each file is whole, and a damaged cache is as none", "[gl]") {
  const test::TemporaryFolder folder;
  const auto path = [&](const char* name) { return (folder.path() / name).string(); };
  folder.write("suite.json", std::string(R"({"jobs": [{"name": "a", "model": "builtin:metals", "size": "16x16"}]})"));
  const std::string cached = "XDG_CACHE_HOME=" + path("cache") + " ";
  const std::string lost = cached + "LD_PRELOAD=" + test::powerLossPath();
  const std::string render = "render builtin:metals --size 16x16 --samples 1 --stats " + path("a.json") + " -o ";
  for (const char* picture : {"a.png", "a.exr"}) {
    const Outcome outcome = facetAfter(lost, render + path(picture));
    INFO(outcome.text);
    REQUIRE(outcome.status == 0);
    CHECK(isWholePicture(path(picture)));
    CHECK(says(contents(path("a.json")), "\"origin\""));
  }
  // What is not waited for is lost here: the cache's entries.
  size_t empty = 0, entries = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path() / "cache/facet"))
    if (entry.path().extension() == ".bin") ++entries, empty += entry.file_size() == 0;
  CHECK(entries > 3);
  CHECK(empty == entries);
  const std::string picture = contents(path("a.png"));
  REQUIRE(facetAfter(cached, render + path("a.png")).status == 0);
  CHECK(contents(path("a.png")) == picture);
  REQUIRE(facetAfter(lost, "regress --accept " + folder.path().string()).status == 0);
  CHECK(isWholePicture(path("baselines/a.png")));
  CHECK(says(contents(path("results/report.json")), "\"accepted\""));
  CHECK(says(contents(path("results/junit.xml")), "</testsuite"));
  REQUIRE(facetAfter(lost, "report fresnel -o " + path("tables")).status == 0);
  CHECK(remains(folder.path() / "tables").empty());
}

// ---- Caches ---------------------------------------------------------------------------------------------------------

namespace {

// Renders with this cache; the picture's bytes.
std::string pictureWith(const fs::path& cache, const std::string& output, std::string* text = nullptr,
                        const std::string& before = "") {
  const Outcome outcome = facetAfter(before + " XDG_CACHE_HOME=" + cache.string(),
                                     "render builtin:metals --size 32x32 --samples 1 -o " + output);
  INFO(outcome.text);
  CHECK(outcome.status == 0);
  if (text) *text = outcome.text;
  return contents(output);
}

}  // namespace

TEST_CASE("faults: whatever the cache's folder is, the picture is the same", "[gl]") {
  const test::TemporaryFolder folder;
  const fs::path fine = folder.path() / "fine";
  fs::create_directory(fine);
  const std::string out = folder.file("a.png"), picture = pictureWith(fine, out);
  CHECK(picture.size() < 4096);
  REQUIRE(fs::exists(fine / "facet/tables"));
  const auto entries = [&](const fs::path& cache) {
    size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(cache)) count += entry.path().extension() == ".bin";
    return count;
  };
  const auto copied = [&](const char* name) {
    fs::copy(fine, folder.path() / name, fs::copy_options::recursive);
    return folder.path() / name;
  };
  const size_t count = entries(fine);
  REQUIRE(count > 3);

  const fs::path corrupt = copied("corrupt");
  size_t kind = 0;
  for (const auto& entry : fs::recursive_directory_iterator(corrupt)) {
    if (entry.path().extension() != ".bin") continue;
    std::string bytes = contents(entry.path());
    if (kind % 3 == 0) bytes.resize(bytes.size() / 2);
    if (kind % 3 == 1) bytes[bytes.size() - 1] = static_cast<char>(bytes[bytes.size() - 1] ^ 1);
    if (kind % 3 == 2) bytes.clear();
    std::ofstream(entry.path(), std::ios::binary) << bytes;
    ++kind;
  }
  CHECK(pictureWith(corrupt, out) == picture);
  CHECK(entries(corrupt) == count);
  CHECK(remains(corrupt / "facet").empty());

  fs::create_directory(folder.path() / "linked");
  fs::create_directory_symlink(fine / "facet", folder.path() / "linked/facet");
  CHECK(pictureWith(folder.path() / "linked", out) == picture);
  CHECK(entries(fine) == count);

  folder.write("file/facet", std::string("x"));
  CHECK(pictureWith(folder.path() / "file", out) == picture);

  CHECK(pictureWith(folder.path() / "full", out, nullptr, "ulimit -f 8;") == picture);  // some entries are larger
  CHECK(entries(folder.path() / "full") < count);
  CHECK(remains(folder.path() / "full/facet").empty());

  const fs::path open = copied("open");
  fs::permissions(open / "facet", fs::perms(0777));
  std::string text;
  CHECK(pictureWith(open, out, &text) == picture);
  CHECK(says(
      text, "facet: everybody may write to it, so that no cache is used; set XDG_CACHE_HOME to a folder of your own."));
  if (geteuid() != 0) return;  // only root can give it away
  fs::permissions(open / "facet", fs::perms(0755));
  REQUIRE(chown((open / "facet").c_str(), 12345, 12345) == 0);
  CHECK(pictureWith(open, out, &text) == picture);
  CHECK(says(text, "facet: belongs to another user, so that no cache is used"));
}

TEST_CASE("faults: eight processes race for a cache that is not there yet", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string line = "XDG_CACHE_HOME=" + folder.file("cache") + " " + test::facetPath() +
                           " render builtin:spheres --env none --size 16x16 --samples 1 -o ";
  std::string all;
  for (int i = 0; i < 8; ++i) all += line + folder.file(std::to_string(i) + ".png") + " & ";
  const Outcome outcome = test::runShell(all + "wait");
  INFO(outcome.text);
  CHECK_FALSE(says(outcome.text, "error"));
  const std::string first = contents(folder.file("0.png"));
  CHECK(first.size() > 100);
  for (int i = 1; i < 8; ++i) CHECK(contents(folder.file(std::to_string(i) + ".png")) == first);
  CHECK(remains(folder.path()).empty());
}

// ---- Signals --------------------------------------------------------------------------------------------------------

TEST_CASE("faults: a signal in the middle ends facet with a word, the convention's status and whole files", "[gl]") {
  const test::TemporaryFolder folder;
  std::string jobs;
  for (int i = 0; i < 400; ++i)
    jobs += std::string(i > 0 ? "," : "") +
            R"({"model": "builtin:metals", "size": "64x64", "samples": 1, "output": ")" + std::to_string(i) +
            (i % 2 == 0 ? ".png\"}" : ".exr\"}");
  folder.write("jobs.json", "[" + jobs + "]");
  struct Row {
    const char* signal;
    int status;
    const char* word;
  };
  const Row row =
      GENERATE(Row{"TERM", 143, "ended by SIGTERM: "}, Row{"INT", 130, "ended by SIGINT: "}, Row{"KILL", 137, nullptr});
  // Once a few are there.
  const Outcome outcome = test::runShell(
      test::facetPath() + " render --no-cache --jobs " + folder.file("jobs.json") + " & pid=$!; until test -e " +
      folder.file("6.png") + "; do sleep 0.02; done; kill -" + row.signal + " $pid; wait $pid; echo status $?");
  INFO(outcome.text);
  CHECK(says(outcome.text, "status " + std::to_string(row.status)));
  size_t pictures = 0;
  for (const auto& entry : fs::directory_iterator(folder.path())) {
    if (entry.path().extension() == ".json") continue;
    if (row.word == nullptr && entry.path().extension() == ".part") continue;
    INFO(entry.path());
    CHECK(isWholePicture(entry.path()));
    ++pictures;
  }
  CHECK(pictures >= 7);
  CHECK(pictures < 400);
  if (row.word == nullptr) return;
  // It may have ended between a picture and its being counted.
  CHECK((says(outcome.text, row.word + std::to_string(pictures) + " of 400 pictures written.") ||
         says(outcome.text, row.word + std::to_string(pictures - 1) + " of 400 pictures written.")));
  CHECK(remains(folder.path()).empty());
}

TEST_CASE("faults: a crash says a sentence and stays a crash", "[gl]") {
  const test::TemporaryFolder folder;
  const Outcome outcome =
      test::runShell(test::facetPath() + " render builtin:spheres --no-cache --size 512x512 --samples 4096 -o " +
                     folder.file("a.png") + " & pid=$!; sleep 0.5; kill -SEGV $pid; wait $pid; echo status $?");
  INFO(outcome.text);
  CHECK(says(outcome.text, "status 139"));
  CHECK(says(outcome.text, "facet: error: ended by signal 11 (segmentation fault), a mistake of facet's or of the "));
  CHECK(remains(folder.path()).empty());
}

// ---- Memory ---------------------------------------------------------------------------------------------------------

TEST_CASE("faults: with little memory there is a picture or a sentence", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string png = folder.file("a.png");
  size_t pictures = 0, sentences = 0;
  for (const int megabytes : {60, 150, 300, 380, 500, 650, 4000}) {
    fs::remove(png);
    const Outcome outcome = facetAfter("ulimit -c 0; ulimit -v " + std::to_string(megabytes * 1024) + ";",
                                       "render builtin:metals" + small + "-o " + png);
    INFO(megabytes << " MB: " << outcome.text);
    if (outcome.status == 0) {
      CHECK(isWholePicture(png));
      ++pictures;
    } else {
      CHECK(says(outcome.text, "facet: error: "));
      CHECK_FALSE(fs::exists(png));
      ++sentences;
    }
    CHECK(remains(folder.path()).empty());
  }
  CHECK(pictures >= 1);
  CHECK(sentences >= 2);
}

// ---- Drivers --------------------------------------------------------------------------------------------------------

namespace {

Outcome withFault(const std::string& fault, const std::string& arguments) {
  return facetAfter("FACET_GL_FAULT='" + fault + "' LD_PRELOAD=" + test::glFaultsPath(), arguments);
}

}  // namespace

TEST_CASE("faults: a driver without memory, or reset, is a sentence and no picture", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string png = folder.file("a.png");
  const std::string render = "render builtin:metals" + small + "-o " + png;
  REQUIRE(withFault("none 0", render).status == 0);
  for (const std::string fault :
       {"textures 1", "textures 4", "buffers 1", "buffers 4", "targets 1", "once 2", "reset 1", "reset 2"}) {
    fs::remove(png);
    const Outcome outcome = withFault(fault, render);
    INFO(fault << ": " << outcome.text);
    CHECK(outcome.status == 2);
    const bool reset = fault.starts_with("reset");
    CHECK(says(outcome.text, reset ? "OpenGL: the driver was reset while it worked on the picture; run facet again"
                                   : "OpenGL: the driver's memory does not suffice for "));
    CHECK_FALSE(fs::exists(png));
  }
}

TEST_CASE("faults: after a driver's failure the next job begins anew, and no table that it spoilt is kept", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("jobs.json", std::string(R"([
    {"model": "builtin:metals", "size": "16x16", "samples": 1, "output": "a.png"},
    {"model": "builtin:metals", "size": "16x16", "samples": 1, "output": "b.png"}])"));
  const std::string render = "render --jobs " + folder.file("jobs.json");
  REQUIRE(facetAfter("", render).status == 0);
  const std::string good = contents(folder.file("b.png"));
  fs::remove(folder.file("a.png")), fs::remove(folder.file("b.png"));
  const std::string cache = folder.file("cache");
  const Outcome outcome =
      test::runShell("XDG_CACHE_HOME=" + cache + " FACET_GL_FAULT='once 4' LD_PRELOAD=" + test::glFaultsPath() + " " +
                     test::facetPath() + " " + render);
  INFO(outcome.text);
  CHECK(outcome.status == 2);
  CHECK(says(outcome.text, "1/2 "));
  CHECK(says(outcome.text, "does not suffice for tables of light"));
  CHECK(says(outcome.text, "1 of 2 pictures written"));
  CHECK_FALSE(fs::exists(folder.file("a.png")));
  CHECK(contents(folder.file("b.png")) == good);
  fs::remove(folder.file("b.png"));
  REQUIRE(facetAfter("XDG_CACHE_HOME=" + cache, render).status == 0);
  CHECK(contents(folder.file("b.png")) == good);
}

TEST_CASE("faults: regress ends a job that hangs in the driver and one whose driver is reset, and goes on", "[gl]") {
  const test::TemporaryFolder folder;
  folder.write("suite.json", std::string(R"({"defaults": {"size": "16x16", "samples": 1}, "jobs": [
    {"name": "a", "model": "builtin:metals"}, {"name": "b", "model": "builtin:spheres"},
    {"name": "c", "model": "builtin:metals", "material": "gold"}]})"));
  const std::string regress = "regress " + folder.path().string() + " --accept -j 1 ";
  // Each of a process's pictures waits twice for the driver: its second job is the one, and the third has a new
  // process.
  const Outcome hung = withFault("hang 3", regress + "--timeout 20");
  INFO(hung.text);
  CHECK(hung.status == 1);
  CHECK(says(hung.text, "accepted a"));
  CHECK(says(hung.text, "failed b: the process that rendered it took longer than 20 s"));
  CHECK(says(hung.text, "accepted c"));
  CHECK(says(hung.text, "2 of 3 good"));
  fs::remove_all(folder.path() / "baselines");
  const Outcome reset = withFault("reset 3", regress);
  INFO(reset.text);
  CHECK(reset.status == 1);
  CHECK(says(reset.text,
             "failed b: the process that rendered it ended with status 2: facet: error: OpenGL: the driver "
             "was reset while it worked on the picture"));
  CHECK(says(reset.text, "2 of 3 good"));
}

TEST_CASE("faults: a driver without an extension draws without it or is refused with a sentence", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string png = folder.file("a.png"), render = "render builtin:spheres --env none" + small + "-o " + png;
  const auto run = [&](const std::string& variable) {
    fs::remove(png);
    const Outcome outcome = facetAfter(variable, render);
    INFO(variable << ": " << outcome.text);
    CHECK((outcome.status == 0 || outcome.status == 3));
    CHECK(fs::exists(png) == (outcome.status == 0));
    return outcome;
  };
  const Outcome usual = run("");
  if (!says(usual.text, "Mesa")) WARN("these variables are Mesa's");
  for (const char* extension : {"ARB_get_program_binary", "ARB_texture_filter_anisotropic", "KHR_robustness"})
    run("MESA_EXTENSION_OVERRIDE=-GL_" + std::string(extension));
  const Outcome draws = run("MESA_EXTENSION_OVERRIDE=-GL_ARB_shader_draw_parameters MESA_GL_VERSION_OVERRIDE=4.5");
  if (says(usual.text, "Mesa")) {
    CHECK(draws.status == 3);
    CHECK(says(draws.text, "without GL_ARB_shader_draw_parameters"));
  }
  const Outcome old = run("MESA_GL_VERSION_OVERRIDE=4.4");
  if (says(usual.text, "Mesa")) {
    CHECK(old.status == 3);
    CHECK(says(old.text, "no headless context could be made: EGL surfaceless refuses OpenGL 4.6 and 4.5 core"));
  }
}
