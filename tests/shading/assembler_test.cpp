#include "shading/assembler.hpp"

#include <catch2/catch.hpp>
#include <map>

#include "shading/embedded_shaders.hpp"
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

TEST_CASE("Assembler: a file that two others include keeps one number and one guard") {
  const auto assembled = shading::assemble("main.glsl", {},
                                           files({{"main.glsl", "#include \"left.glsl\"\n#include \"right.glsl\"\n"},
                                                  {"left.glsl", "#include \"shared.glsl\"\nint left;\n"},
                                                  {"right.glsl", "#include \"shared.glsl\"\nint right;\n"},
                                                  {"shared.glsl", "int both;\n"}}));
  REQUIRE(assembled);
  CHECK(assembled->files == std::vector<std::string>{"main.glsl", "left.glsl", "shared.glsl", "right.glsl"});
  size_t guards = 0;
  const std::string guard = "#ifndef FACET_INCLUDED_shared_glsl\n#define FACET_INCLUDED_shared_glsl\n#line 1 2\n";
  for (size_t at = assembled->text.find(guard); at != std::string::npos; at = assembled->text.find(guard, at + 1))
    ++guards;
  CHECK(guards == 2);
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
