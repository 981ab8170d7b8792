#include "shading/assembler.hpp"

#include <catch2/catch.hpp>
#include <map>
#include <regex>
#include <set>

#include "shading/embedded_shaders.hpp"
#include "shading/functions.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

shading::ShaderReader files(const std::map<std::string, std::string>& texts) {
  return [texts](const std::string& path) -> std::optional<std::string> {
    const auto found = texts.find(path);
    return found == texts.end() ? std::nullopt : std::optional(found->second);
  };
}

std::string problem(const std::map<std::string, std::string>& texts) {
  const auto assembled = shading::assemble("main.glsl", {}, files(texts));
  return assembled ? "" : describe(assembled.error());
}

}  // namespace

TEST_CASE("Assembler: version, defines, #line of every file and of what follows an include") {
  const auto assembled = shading::assemble(
      "main.glsl", {{"SMALL", "3"}, {"FLAG"}},
      files({{"main.glsl", "int a;\n#include \"passes/b.glsl\"  // why\nint c;\n"}, {"passes/b.glsl", "int b;\n"}}));
  REQUIRE(assembled);
  CHECK(assembled->text ==
        "#version 450 core\n#define SMALL 3\n#define FLAG 1\n"
        "#line 1 0\nint a;\n"
        "#ifndef FACET_INCLUDED_passes_b_glsl\n#define FACET_INCLUDED_passes_b_glsl\n#line 1 1\nint b;\n#endif\n"
        "#line 3 0\nint c;\n");
  CHECK(assembled->files == std::vector<std::string>{"main.glsl", "passes/b.glsl"});
}

TEST_CASE("Assembler: a file that two others include keeps one number and stands once") {
  const std::map<std::string, std::string> texts = {{"left.glsl", "#include \"shared.glsl\"\nint left;\n"},
                                                    {"right.glsl", "#include \"shared.glsl\"\nint right;\n"},
                                                    {"shared.glsl", "int both;\n"}};
  const auto assembled = [&](const std::string& main) {
    std::map<std::string, std::string> all = texts;
    all["main.glsl"] = main;
    const auto result = shading::assemble("main.glsl", {}, files(all));
    REQUIRE(result);
    CHECK(result->files == std::vector<std::string>{"main.glsl", "left.glsl", "shared.glsl", "right.glsl"});
    return result->text;
  };
  const auto count = [](const std::string& text, const std::string& what) {
    int found = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  const std::string plain = assembled("#include \"left.glsl\"\n#include \"right.glsl\"\n");
  CHECK(count(plain, "int both;") == 1);
  CHECK(plain.find("#line 1 3\n\nint right;") != std::string::npos);
  // In the same branch or one within it, but not behind it, nor in the other one: there the guard decides.
  CHECK(count(assembled("#ifdef A\n#include \"left.glsl\"\n# if B\n#include \"right.glsl\"\n# endif\n#endif\n"),
              "int both;") == 1);
  CHECK(count(assembled("#ifdef A\n#include \"left.glsl\"\n#endif\n#include \"right.glsl\"\n"), "int both;") == 2);
  const std::string guarded = assembled("#ifdef A\n#include \"left.glsl\"\n#else\n#include \"right.glsl\"\n#endif\n");
  CHECK(count(guarded, "#ifndef FACET_INCLUDED_shared_glsl\n#define FACET_INCLUDED_shared_glsl\n") == 2);
}

TEST_CASE("Assembler: a chunk or the one that stands for its absence") {
  const auto reader = files({{"main.glsl", "#include \"layers/film.glsl\" if HAS_FILM  // thin\n"},
                             {"layers/film.glsl", "int film;\n"},
                             {"layers/film_none.glsl", "int none;\n"}});
  const auto with = shading::assemble("main.glsl", {{"HAS_FILM"}}, reader);
  REQUIRE(with);
  CHECK(with->files == std::vector<std::string>{"main.glsl", "layers/film.glsl"});
  const auto without = shading::assemble("main.glsl", {{"HAS_FILMS"}}, reader);
  REQUIRE(without);
  CHECK(without->files == std::vector<std::string>{"main.glsl", "layers/film_none.glsl"});
  CHECK(without->text.find("int none;") != std::string::npos);
  CHECK(problem({{"main.glsl", "#include \"a.glsl\" if X\n"}, {"a.glsl", ""}}) ==
        "shaders/a_none.glsl: main.glsl:1: there is no such shader file.");
}

TEST_CASE("Assembler: a list counts as often as it is named") {
  const auto assembled = shading::assemble(
      "main.glsl", {}, files({{"main.glsl", "#include \"a.inc\"\n#include \"a.inc\"\n"}, {"a.inc", "ROW\n"}}));
  REQUIRE(assembled);
  CHECK(assembled->text == "#version 450 core\n#line 1 0\n#line 1 1\nROW\n#line 2 0\n#line 1 1\nROW\n#line 3 0\n");
}

TEST_CASE("Shaders: what is included on a condition has its pair, of equal functions") {
  const std::regex include(R"re(#include "([^"]+)\.glsl" if )re");
  // Signatures, without the names of arguments' files: "vec3 filmedMetal(Film film, float VoH, vec3 F, vec3 f0)".
  const auto functions = [](const std::string& text) {
    static const std::regex head(R"re((?:^|\n)(\w+ \w+\([^{};]*\)) \{)re");
    std::set<std::string> found;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), head); it != std::sregex_iterator(); ++it) {
      const std::string signature = std::regex_replace((*it)[1].str(), std::regex(R"re(\s+)re"), " ");
      found.insert(signature);
    }
    return found;
  };
  const shading::ShaderReader reader = shading::shaderReader();
  int pairs = 0;
  for (const shading::EmbeddedShader& file : shading::embeddedShaders()) {
    const std::string text(file.text);
    for (auto it = std::sregex_iterator(text.begin(), text.end(), include); it != std::sregex_iterator(); ++it) {
      const std::string name = (*it)[1].str();
      const auto whole = reader(name + ".glsl"), none = reader(name + "_none.glsl");
      INFO(name);
      REQUIRE((whole && none));
      const std::set<std::string> offered = functions(*whole);
      // What the pair has must be there in the whole one; what only the latter has is its own affair.
      for (const std::string& signature : functions(*none)) {
        INFO(signature);
        CHECK(offered.count(signature) == 1);
      }
      ++pairs;
    }
  }
  CHECK(pairs > 15);
}

TEST_CASE("Assembler: what is wrong names the file and the including line") {
  CHECK(problem({}) == "shaders/main.glsl: there is no such shader file.");
  CHECK(problem({{"main.glsl", "\n#include \"gone.glsl\"\n"}}) ==
        "shaders/gone.glsl: main.glsl:2: there is no such shader file.");
  CHECK(problem({{"main.glsl", "#include \"main.glsl\"\n"}}) ==
        "shaders/main.glsl: main.glsl:1: is included from itself.");
  CHECK(problem({{"main.glsl", "#include \"b.glsl\"\n"}, {"b.glsl", "\n\n#include \"main.glsl\"\n"}}) ==
        "shaders/main.glsl: b.glsl:3: is included from itself.");
}

TEST_CASE("Assembler: the compiler's messages are traced to chunk and line, in every driver's spelling") {
  const std::vector<std::string> names = {"main.glsl", "passes/b.glsl"};
  CHECK(shading::translateLog("1:12(3): error: what", names) == "shaders/passes/b.glsl:12: error: what\n");
  CHECK(shading::translateLog("0(7) : error C1: what", names) == "shaders/main.glsl:7: error C1: what\n");
  CHECK(shading::translateLog("ERROR: 1:5: 'x' : undeclared", names) ==
        "ERROR: shaders/passes/b.glsl:5: 'x' : undeclared\n");
  CHECK(shading::translateLog("9:5(1): error\nlink failed", names) == "9:5(1): error\nlink failed\n");
}

TEST_CASE("Shader reader: embedded files, and a folder in their place") {
  const auto embedded = shading::shaderReader();
  CHECK(embedded("microfacet.glsl")->find("D_GGX") != std::string::npos);
  CHECK(embedded("passes/mesh.frag.glsl"));
  CHECK_FALSE(embedded("nothing.glsl"));
  CHECK_FALSE(embedded(""));
  // Sorted, as the look-up needs it.
  CHECK(std::ranges::is_sorted(shading::embeddedShaders(), {}, &shading::EmbeddedShader::path));

  const test::TemporaryFolder folder;
  folder.write("own.glsl", std::string("int own;\n"));
  const auto reader = shading::shaderReader(folder.path());
  CHECK(reader("own.glsl") == "int own;\n");
  CHECK_FALSE(reader("microfacet.glsl"));
}

namespace {

// By name of function, all overloads of it: what it names. Macros are callers of what they hold, under "#define".
std::map<std::string, std::set<std::string>> callsOfShaders(std::set<std::string>& entries) {
  std::map<std::string, std::set<std::string>> calls;
  for (const shading::ShaderFunction& function : shading::shaderFunctions()) {
    calls[function.macro ? "#define" : function.name].insert(function.words.begin(), function.words.end());
    if (function.macro) continue;
    // ggxValue: what stands beside its sample and density for the tests of these.
    if (function.name == "main" || function.name == "ggxValue") entries.insert(function.name);
  }
  return calls;
}

}  // namespace

TEST_CASE("Shaders: every function is in a picture") {
  std::set<std::string> reached = {"#define"};
  const std::map<std::string, std::set<std::string>> calls = callsOfShaders(reached);
  CHECK(calls.size() > 200);
  std::vector<std::string> open(reached.begin(), reached.end());
  while (!open.empty()) {
    const auto caller = calls.find(open.back());
    open.pop_back();
    if (caller == calls.end()) continue;
    for (const std::string& name : caller->second)
      if (reached.insert(name).second) open.push_back(name);
  }
  for (const auto& [name, called] : calls) {
    INFO(name << " is in no picture: use it or drop it");
    CHECK(reached.count(name) == 1);
  }
}
