#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>
#include <memory>
#include <new>
#include <stdexcept>

#include "base/log.hpp"
#include "base/origin.hpp"
#include "commands/commands.hpp"
#include "support/command.hpp"

using namespace facet;
using commands::Command;

namespace {

std::string ran;  // what the commands below saw
log::Level levelSeen;

std::function<int()> addWindow(CLI::App& app) {
  const auto model = std::make_shared<std::string>();
  const auto size = std::make_shared<std::string>();
  app.add_option("MODEL", *model);
  app.add_option("--size", *size);
  return [=] { return ran = "window " + *model + " " + *size, 0; };
}

std::function<int()> addRender(CLI::App& app) {
  const auto model = std::make_shared<std::string>();
  app.add_option("MODEL", *model)->required();
  return [=] { return ran = "render " + *model, levelSeen = log::level(), 3; };
}

std::function<int()> addThrow(CLI::App&) {
  return []() -> int { throw std::bad_alloc(); };
}

constexpr Command table[] = {{"", "opens a window", "  facet model.glb", addWindow},
                             {"render", "renders", "  facet render model.glb", addRender},
                             {"throw", "throws", "  facet throw", addThrow}};

int run(std::vector<std::string> words) {
  ran.clear();
  words.insert(words.begin(), "facet");
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  log::setLevel(log::Level::info);
  const int status = commands::run(table, static_cast<int>(arguments.size()), arguments.data());
  log::setLevel(log::Level::info);
  return status;
}

}  // namespace

TEST_CASE("words reach their command, and its status comes back") {
  CHECK(run({}) == 0);
  CHECK(ran == "window  ");
  CHECK(run({"model.glb", "--size", "1x2"}) == 0);
  CHECK(ran == "window model.glb 1x2");
  CHECK(run({"./render"}) == 0);
  CHECK(ran == "window ./render ");
  CHECK(run({"render", "m.glb"}) == 3);
  CHECK(ran == "render m.glb");
  CHECK(run({"render", "render"}) == 3);  // after a command its name is an ordinary word
  CHECK(ran == "render render");
}

TEST_CASE("the log level is set before or after the command") {
  run({"--log-level", "debug", "render", "m"});
  CHECK(ran == "render m");
  CHECK(levelSeen == log::Level::debug);
  run({"render", "m", "--log-level", "quiet"});
  CHECK(levelSeen == log::Level::quiet);
  run({"render", "m"});
  CHECK(levelSeen == log::Level::info);
}

TEST_CASE("what cannot be meant is refused and nothing runs") {
  const auto words = GENERATE(values<std::vector<std::string>>({{"render"},
                                                                {"render", "a", "b"},
                                                                {"render", "a", "--siez", "3"},
                                                                {"a.glb", "b.glb"},
                                                                {"--size", "1x2", "render", "m"},
                                                                {"a.glb", "render", "m"},
                                                                {"rendr"},
                                                                {"rendr", "m.glb"},
                                                                {"--size"},
                                                                {"--log-level", "loud", "render", "m"},
                                                                {"-x"},
                                                                {"throw"}}));
  CHECK(run(words) == commands::exitBadInput);
  CHECK(ran == "");
}

TEST_CASE("the program's own words and exit status") {
  struct Row {
    std::vector<std::string> words;
    int status;
    std::string text;
  };
  const Row row = GENERATE(values<Row>({
      {{"--version"}, 0, "facet " + programVersion() + ", commit " + programCommit() + "\n"},
      {{"comapre", "a", "b"}, 2, "facet: error: 'comapre': neither a command nor a file; perhaps compare is meant.\n"},
      {{"compare"}, 2, "facet: error: REF is required; see facet compare --help.\n"},
      {{"compare", "a", "b", "c"}, 2, "facet: error: 'c': one argument too many; see facet compare --help.\n"},
      {{"compare", "a", "--tolerace", "1", "b"},
       2,
       "facet: error: --tolerace: there is no such option; perhaps --tolerance is meant.\n"},
      {{"compare", "--tolerace=1"},
       2,
       "facet: error: --tolerace: there is no such option; perhaps --tolerance is meant.\n"},
      {{"compare", "--frobnicate", "a", "b"},
       2,
       "facet: error: --frobnicate: there is no such option; see facet compare --help.\n"},
      {{"compare", "a", "b", "--metric"},
       2,
       "facet: error: --metric: takes exactly one value, once; see facet compare --help.\n"},
      {{"compare", "a", "b", "--metric", "ssim", "--metric", "bias"},
       2,
       "facet: error: --metric: takes exactly one value, once; see facet compare --help.\n"},
      {{"--log-level", "dbug", "compare", "a", "b"},
       2,
       "facet: error: --log-level: 'dbug' is no level; perhaps debug is meant.\n"},
      {{"--log-level", "quiet", "compare", "/nonexistent/a", "b"}, 2, ""},
  }));
  const test::Outcome outcome = test::runFacet(row.words);
  CHECK(outcome.text == row.text);
  CHECK(outcome.status == row.status);
}

TEST_CASE("help of the program and of a command ends with examples and the exit status") {
  const test::Outcome program = test::runFacet({"--help"}), compare = test::runFacet({"compare", "--help"});
  CHECK(program.status == 0);
  CHECK(program.text.find("measure how two pictures differ") != std::string::npos);
  CHECK(compare.status == 0);
  CHECK(compare.text.find("Examples:\n  facet compare before.png after.png\n") != std::string::npos);
  CHECK(compare.text.find("Exit status: 0 good, 1 ") != std::string::npos);
}
