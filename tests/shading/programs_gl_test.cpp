#include <catch2/catch.hpp>

#include "report/shader_probe.hpp"
#include "support/gpu.hpp"

using namespace facet;

TEST_CASE("A probe runs a chunk's function over an array") {
  const report::Probe probe{{"fresnel.glsl"}, "out0 = vec4(F_Schlick(in0.x, in0.yyy, 1.0), in0.w);"};
  const std::vector<glm::vec4> inputs = {{1, 0.04f, 0, 7}, {0, 0.04f, 0, 8}, {0.5f, 0.5f, 0, 9}};
  const auto out = report::runProbe(probe, inputs, shading::shaderReader());
  REQUIRE(out);
  CHECK((*out)[0].x == Approx(0.04));
  CHECK((*out)[1].x == Approx(1.0));
  CHECK((*out)[2].x == Approx(0.5 + 0.5 / 32));
  CHECK((*out)[2].w == 9);
}

TEST_CASE("A compiler message names the chunk and its line") {
  const auto reader = [](const std::string& path) -> std::optional<std::string> {
    if (path == "broken.glsl") return "float one() { return 1.0; }\nfloat two() { return nothing; }\n";
    return shading::shaderReader()(path);
  };
  const auto out =
      report::runProbe({{"constants.glsl", "broken.glsl"}, "out0.x = two();"}, std::vector<glm::vec4>(1), reader);
  REQUIRE_FALSE(out);
  CHECK_THAT(out.error().problem, Catch::Contains("shaders/broken.glsl:2:"));
}

TEST_CASE("A message about a fragment shader names the fragment shader's chunk") {
  const auto reader = [](const std::string& path) -> std::optional<std::string> {
    if (path == "broken.frag.glsl") return "out vec4 color;\nvoid main() { color = nothing; }\n";
    return shading::shaderReader()(path);
  };
  shading::ProgramStore programs(reader, {}, "");
  const auto program = programs.render("passes/fullscreen.vert.glsl", "broken.frag.glsl");
  REQUIRE_FALSE(program);
  CHECK(program.error().place == "fragment shader");
  CHECK_THAT(program.error().problem, Catch::StartsWith("shaders/broken.frag.glsl:2:"));
}
