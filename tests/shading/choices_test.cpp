#include "shading/choices.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "optics/color.hpp"
#include "optics/models.hpp"
#include "shading/assembler.hpp"
#include "shading/embedded_shaders.hpp"
#include "shading/features.hpp"

using namespace facet;

namespace {

// The name alone, not as part of another.
bool standsIn(std::string_view text, const std::string& name) {
  const auto isName = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (size_t at = text.find(name); at != std::string_view::npos; at = text.find(name, at + 1)) {
    const size_t end = at + name.size();
    if ((at == 0 || !isName(text[at - 1])) && (end == text.size() || !isName(text[end]))) return true;
  }
  return false;
}

std::string textOfFile(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(FACET_SOURCE_DIR "/" + path).rdbuf();
  return text.str();
}

// "| `--diffuse` | lambert, burley (a note) | lights |" -> "lambert, burley"; notes follow a colon or stand in
// brackets.
std::string wordsBeside(const std::string& text, const std::string& option) {
  const std::string row = "| `--" + option + "` | ";
  const size_t begin = text.find(row);
  REQUIRE(begin != std::string::npos);
  const size_t end = text.find(" |", begin + row.size());
  std::string words;
  bool note = false;
  for (const char c : text.substr(begin + row.size(), end - begin - row.size())) {
    if (c == '(' || c == ':') note = true;
    if (c == ';') note = false;
    if (!note) words += c == ';' ? ',' : c;
    if (c == ')') note = false;
  }
  std::erase(words, ' ');
  return words;
}

template <class T, size_t count>
std::string wordsWithoutSpaces(const Choice<T> (&rows)[count]) {
  std::string words = wordsOf(rows);
  std::erase(words, ' ');
  return words;
}

}  // namespace

TEST_CASE("Choices: shaders read the rows' numbers by name", "[shading]") {
  CHECK(shading::defineName("geometryNormal") == "GEOMETRY_NORMAL");
  CHECK(shading::defineName("v-cavity") == "V_CAVITY");
  const auto assembled =
      shading::assemble("main.glsl", {}, [](const std::string&) { return std::string("#include \"choices.glsl\"\n"); });
  REQUIRE(assembled);
  for (const char* line : {"#define DIFFUSE_LAMBERT 0\n", "#define DIFFUSE_OREN_NAYAR 3\n", "#define FRESNEL_F82 2\n",
                           "#define ENERGY_KULLA_CONTY 3\n", "#define IMAGE_LIGHT_USUAL 6\n",
                           "#define CHANNEL_GEOMETRY_NORMAL 2\n", "#define TONE_NEUTRAL 6\n"})
    CHECK(assembled->text.find(line) != std::string::npos);
}

TEST_CASE("Choices: every row but the usual one has its formula in a chunk", "[shading]") {
  std::string all;
  for (const shading::EmbeddedShader& file : shading::embeddedShaders()) all += file.text;
  const auto check = [&](const std::string& prefix, const auto& rows) {
    for (const auto& row : rows) {
      if (static_cast<int>(row.value) == 0) continue;
      INFO(prefix << row.word);
      CHECK(standsIn(all, prefix + shading::defineName(row.word)));
    }
  };
  check("DIFFUSE_", optics::diffuseModels);
  check("FRESNEL_", optics::fresnelModels);
  check("NDF_", optics::distributions);
  check("MASKING_", optics::maskings);
  check("ENERGY_", optics::energyModels);
  check("CHANNEL_", shading::channels);
  check("TONE_", optics::toneMappers);
}

TEST_CASE("Choices: READMEs list the rows", "[shading]") {
  const std::string text = textOfFile("src/optics/README.md");
  CHECK(wordsBeside(text, "diffuse") == wordsWithoutSpaces(optics::diffuseModels));
  CHECK(wordsBeside(text, "fresnel") == wordsWithoutSpaces(optics::fresnelModels));
  CHECK(wordsBeside(text, "ndf") == wordsWithoutSpaces(optics::distributions));
  CHECK(wordsBeside(text, "masking") == wordsWithoutSpaces(optics::maskings));
  CHECK(wordsBeside(text, "energy") == wordsWithoutSpaces(optics::energyModels));
  CHECK(wordsBeside(text, "image-light") == wordsWithoutSpaces(optics::imageLights));
  std::string readme = textOfFile("README.md");
  std::ranges::replace(readme, '\n', ' ');
  CHECK(readme.find("Tone mappers: " + wordsOf(optics::toneMappers) + " (the default)") != std::string::npos);
}
