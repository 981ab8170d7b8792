#include "commands/manual.hpp"

#include <catch2/catch.hpp>

#include "commands/completion.hpp"
#include "options/picture_options.hpp"
#include "support/command.hpp"

using namespace facet;
using commands::CommandText;
using commands::Completions;
using commands::OptionText;

namespace {

const std::vector<CommandText>& program() {
  static const std::vector<CommandText> all = commands::described(commands::allCommands());
  return all;
}

const CommandText& command(const std::string& name) {
  const auto found = std::ranges::find(program(), name, &CommandText::name);
  REQUIRE(found != program().end());
  return *found;
}

std::vector<std::string> wordsAfter(const std::vector<std::string>& line) {
  std::vector<std::string> words;
  for (const commands::Candidate& candidate : commands::completions(program(), line).words)
    words.push_back(candidate.word);
  return words;
}

}  // namespace

TEST_CASE("the program's words as data are what its help shows") {
  REQUIRE(program().size() == commands::allCommands().size());
  for (const CommandText& each : program()) {
    INFO(each.name);
    const test::Outcome help = each.name.empty() ? test::runFacet({"--help"}) : test::runFacet({each.name, "--help"});
    for (const OptionText& option : each.options) {
      INFO(option.help);
      CHECK(help.text.find(option.help.substr(0, option.help.find('\n'))) != std::string::npos);
      for (const std::string& name : option.names) CHECK(help.text.find(name) != std::string::npos);
    }
  }
  const std::vector<OptionText>& options = command("regress").options;
  const auto processes = std::ranges::find_if(options, [](const OptionText& o) {
    return o.names == std::vector<std::string>{"-j", "--processes"};
  });
  REQUIRE(processes != options.end());
  CHECK(*processes ==
        OptionText{
            {"-j", "--processes"}, "", "N", "processes beside each other (as many as cores, at most 4)", "Options"});
  for (const OptionText& option : options)  // hidden
    CHECK(std::ranges::find(option.names, "--worker") == option.names.end());
  const OptionText& reference = command("compare").options[1];
  CHECK((reference.place == "REF" && reference.required && !reference.many && reference.value == "PICTURE|MODEL"));
  const OptionText& model = command("report").options[3];  // by its place or by its name
  CHECK((model.place == "MODEL" && model.names == std::vector<std::string>{"--model"}));
}

TEST_CASE("a page of the manual has every option, and nothing that troff would take for its own") {
  for (const CommandText& each : program()) {
    const std::string page = commands::manualPage(each, program());
    INFO(page);
    CHECK(page.starts_with(".TH FACET"));
    for (const OptionText& option : each.options)
      for (std::string name : option.names) {
        for (size_t at = 0; (at = name.find('-', at)) != std::string::npos; at += 2) name.replace(at, 1, "\\-");
        CHECK(page.find("\\fB" + name + "\\fR") != std::string::npos);
      }
  }
  CHECK(commands::manualPage(command(""), program()).find("\\fBfacet\\-render\\fR(1)") != std::string::npos);
  const CommandText awkward{"x", "s", "  facet x", {{{"-a"}, "", "A", ".TH begins\n'so does\na\\b it's", "Options"}}};
  CHECK(commands::manualPage(awkward, program())
            .find(".TP\n\\fB\\-a\\fR \\fIA\\fR\n\\&.TH begins\n.br\n\\&\\(aqso does\n.br\na\\eb it\\(aqs\n") !=
        std::string::npos);
}

TEST_CASE("pages are printed, or written as files") {
  CHECK(test::runFacet({"manual", "render"}).text == commands::manualPage(command("render"), program()));
  CHECK(test::runFacet({"manual", "rendr"}).text ==
        "facet: error: 'rendr': there is no such command; perhaps render is meant.\n");
  const test::TemporaryFolder folder;
  CHECK(test::runFacet({"manual", "-o", folder.file("pages")}).status == 0);
  for (const CommandText& each : program())
    CHECK(std::filesystem::exists(folder.file("pages/" + commands::manualName(each) + ".1")));
}

TEST_CASE("what may come next on a command line") {
  using Words = std::vector<std::string>;
  CHECK(wordsAfter({"re"}) == Words{"render", "regress", "report"});
  CHECK(wordsAfter({"render", "--tonem"}) == Words{"--tonemap"});
  CHECK(wordsAfter({"render", "x.glb", "--tonemap", "a"}) == Words{"aces", "agx"});
  CHECK(wordsAfter({"--tonemap", "a"}) == Words{"aces", "agx"});  // the window's
  CHECK(wordsAfter({"render", "--tonemap=a"}) == Words{"--tonemap=aces", "--tonemap=agx"});
  CHECK(wordsAfter({"render", "--env", "builtin:s"}) == Words{"builtin:studio", "builtin:sky"});
  CHECK(wordsAfter({"render", "--background", ""}) == Words{"env", "transparent"});
  CHECK(wordsAfter({"render", "--material", "go"}) == Words{"gold"});
  CHECK(wordsAfter({"brdf", "--metric", ""}) == Words{"log", "cuberoot"});
  CHECK(wordsAfter({"brdf", "--format", "m"}) == Words{"markdown"});
  CHECK(wordsAfter({"compare", "a.png", "b.png", "--metric", "flip"}) == Words{"flip", "flip-largest"});
  CHECK(wordsAfter({"report", "vis"}) == Words{"visibility"});
  CHECK(wordsAfter({"manual", "ins"}) == Words{"inspect"});
  CHECK(wordsAfter({"render", "--log-level", ""}) == Words{"quiet", "error", "warning", "info", "debug"});
  CHECK(wordsAfter({"render", "--size", "1x1", "--siz"}) == Words());  // given already
  CHECK(wordsAfter({"render", "--", "--siz"}) == Words());             // a file's name
  CHECK(wordsAfter({"render", "--nonsense", "--siz"}) == Words{"--size"});
  CHECK(wordsAfter({"render", "render"}) == Words());  // after a command its name is an ordinary word
  CHECK(wordsAfter({"render", "--frames", ""}) == Words());

  const auto files = [](const Words& line) { return commands::completions(program(), line); };
  CHECK(files({"render", "x"}) == Completions{{}, true, true, {"glb", "gltf"}});
  CHECK(files({"render", "x.glb", "x"}) == Completions());                       // one model only
  CHECK(files({"x.glb", "x"}) == Completions{{}, true, true, {"glb", "gltf"}});  // the window takes folders, too
  CHECK(files({"regress", "x"}) == Completions{{}, true, false, {}});
  CHECK(files({"render", "x.glb", "-o", "x"}) == Completions{{}, true, true, {}});
  CHECK(files({"compare", "a.png", "x"}) == Completions{{}, true, true, {"png", "exr", "glb", "gltf"}});
  CHECK(commands::asLines(files({"render", "builtin:pos"})) ==
        "builtin:poster\ta golden trefoil among spheres of many materials\n:folders\n:files glb gltf\n");
  CHECK(test::runFacet({"complete", "--", "render", "--tonemap", "ag"}).text == "agx\n");
  CHECK(test::runFacet({"complete", "--", "regres", ""}).text.find("\n:files") != std::string::npos);
}

TEST_CASE("every value of an option that names files, folders or words is completed") {
  // What cannot be: numbers, texts, names that are the model's own.
  const std::vector<std::string> open = {"N",
                                         "S",
                                         "E",
                                         "T",
                                         "F",
                                         "X",
                                         "I/N",
                                         "TEXT",
                                         "WORDS",
                                         "WxH",
                                         "DEG",
                                         "THETA,PHI,RADIUS",
                                         "X,Y,Z",
                                         "0..1",
                                         "1..3",
                                         "STOPS",
                                         "FROM,TO",
                                         "#rrggbb|R,G,B",
                                         "NAME|INDEX",
                                         "TABLE",
                                         "THETAV,THETAL,PHI",
                                         "N,...",
                                         "WxH,...",
                                         "OPTION=VALUE,...",
                                         "M",
                                         "NODE,...",
                                         "NAME=VALUE",
                                         "POINTER=VALUE"};
  for (const CommandText& each : program()) {
    for (const OptionText& option : each.options) {
      if (option.value.empty() || std::ranges::find(open, option.value) != open.end()) continue;
      INFO(each.name << " " << option.help << " " << option.value);
      if (option.names.empty()) continue;  // arguments by their place: above
      const Completions found = commands::completions(program(), {each.name, option.names.back(), ""});
      const Completions window = commands::completions(program(), {option.names.back(), ""});
      const Completions& asked = each.name.empty() ? window : found;
      if (option.names.back() == "--layer") continue;  // the environment's own
      CHECK((!asked.words.empty() || asked.files || asked.folders));
    }
  }
}
