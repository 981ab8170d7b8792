#include "commands/config_file.hpp"

#include <catch2/catch.hpp>

#include "support/command.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;
using commands::PictureArguments;

namespace {

PictureArguments applied(const std::string& text, const std::string& model, PictureArguments given = {}) {
  const Result<void> r = commands::applyConfigText(text, "config", "/home/me", model, given);
  INFO((r ? "" : describe(r.error())));
  REQUIRE(r);
  return given;
}

std::string problem(const std::string& text) {
  PictureArguments given;
  const Result<void> r = commands::applyConfigText(text, "my config", "/home/me", "a.glb", given);
  return r ? "" : describe(r.error());
}

}  // namespace

TEST_CASE("config: lines are options, what is given goes before, paths lie beside the file") {
  const std::string text =
      "# light\n\n  exposure = 1.5  \nenv=skies/dawn.hdr\r\nground = true\n\texposure = 2\nbrdf = gold\n";
  CHECK(applied(text, "a.glb") ==
        PictureArguments{{"exposure", "2"}, {"env", "/home/me/skies/dawn.hdr"}, {"ground", "true"}, {"brdf", "gold"}});
  CHECK(applied(text, "a.glb", {{"exposure", "-1"}}).at("exposure") == "-1");
  CHECK(applied("env = builtin:sky", "a.glb").at("env") == "builtin:sky");
  CHECK(applied("", "a.glb").empty());
}

TEST_CASE("config: sections are for models of a name") {
  const std::string text =
      "samples = 9\n[*.GLB]\nup = z\n[chair?.*]\nroll = 3\n[builtin:*]\nexposure = 1\n[*a*a*a*a*b]\nroll = "
      "9\n[*]\nfov-y = 30";
  CHECK(applied(text, "/x.y/thing.glb") == PictureArguments{{"samples", "9"}, {"up", "z"}, {"fov-y", "30"}});
  CHECK(applied(text, "Chair2.gltf") == PictureArguments{{"samples", "9"}, {"roll", "3"}, {"fov-y", "30"}});
  CHECK(applied(text, "chair.gltf") == PictureArguments{{"samples", "9"}, {"fov-y", "30"}});
  CHECK(applied(text, "builtin:poster") == PictureArguments{{"samples", "9"}, {"exposure", "1"}, {"fov-y", "30"}});
  CHECK(applied(text, std::string(4000, 'a')).size() == 2);  // and at once
}

TEST_CASE("config: what the command line excludes is left out") {
  const std::string text = "orbit = 1,2,3\nroll = 4\nfov-y = 30\n";
  CHECK(applied(text, "a.glb", {{"camera", "0"}}) == PictureArguments{{"camera", "0"}, {"fov-y", "30"}});
  CHECK(applied("camera = door", "a.glb", {{"up", "z"}}) == PictureArguments{{"up", "z"}});
  CHECK(applied("view-height = 2", "a.glb", {{"orbit", "1,2,3"}}) == PictureArguments{{"orbit", "1,2,3"}});
}

TEST_CASE("config: what is wrong is told with file and line, in other models' sections, too") {
  CHECK(problem("samples = 4\nexposure") == "my config: line 2: 'exposure' is no option; give OPTION = VALUE.");
  CHECK(problem("\nexpozure = 2") == "my config: line 2: there is no option 'expozure'; perhaps exposure is meant.");
  CHECK(problem("[*.gltf]\nsamples = many") ==
        "my config: line 2, samples: 'many' is not a whole number; give a whole number from 1 to 4096.");
  CHECK(problem("[x") == "my config: line 1: '[x' is no pattern; give one such as [*.glb].");
  CHECK(problem("ground = 2") == "my config: line 1, ground: '2' is neither; give true or false.");
}

TEST_CASE("config: a file, and one that is not there") {
  const test::TemporaryFolder folder;
  PictureArguments given;
  REQUIRE(commands::applyConfig(folder.write("c", "env = a.hdr"), "a.glb", given));
  CHECK(given.at("env") == (folder.path() / "a.hdr").string());
  CHECK(describe(commands::applyConfig(folder.path() / "none", "a.glb", given).error()) ==
        (folder.path() / "none").string() + ": cannot be read; check its name and permissions.");
  CHECK_FALSE(commands::applyConfig(folder.path(), "a.glb", given));
  const test::Outcome outcome = test::runFacet(
      {"render", "builtin:spheres", "-o", folder.file("a.png"), "--config", folder.write("d", "x = 1").string()});
  CHECK(outcome.status == 2);
  CHECK(outcome.text.find("/d: line 1: there is no option 'x'") != std::string::npos);
}
