#include "shading/functions.hpp"

#include <catch2/catch.hpp>

using namespace facet;

TEST_CASE("Shader functions: names, overloads, macros, what bodies name but not what comments do") {
  const auto found = shading::functionsOf("a.glsl",
                                          "#define TWICE(x) \\\n  twice(x)\n"
                                          "float twice(float x) { return 2.0 * x; }  // or four(x)\n"
                                          "vec2 twice(vec2 x) {\n  if (x.x > 0.0) { return sum(x); }\n  return x;\n}\n"
                                          "void main() {\n  TWICE(1.0);\n}\nfloat declared(float x);\n");
  REQUIRE(found.size() == 3);
  CHECK(found[0].name == "TWICE");
  CHECK(found[0].macro);
  CHECK(found[0].words.contains("twice"));
  CHECK(found[1].name == "twice");
  CHECK_FALSE(found[1].macro);
  CHECK(found[1].words.contains("sum"));
  CHECK_FALSE(found[1].words.contains("four"));
  CHECK(found[2].name == "main");
  CHECK(found[2].words == std::set<std::string>{"TWICE", "1", "0"});
}
