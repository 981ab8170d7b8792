#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>

#include "selftest/shader_probe.hpp"
#include "support/gpu.hpp"
#include "support/skip.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("A probe runs a chunk's function over an array") {
  const selftest::Probe probe{{"fresnel.glsl"}, "out0 = vec4(F_Schlick(in0.x, in0.yyy, 1.0), in0.w);"};
  const std::vector<glm::vec4> inputs = {{1, 0.04f, 0, 7}, {0, 0.04f, 0, 8}, {0.5f, 0.5f, 0, 9}};
  const auto out = selftest::runProbe(probe, inputs, shading::shaderReader());
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
      selftest::runProbe({{"constants.glsl", "broken.glsl"}, "out0.x = two();"}, std::vector<glm::vec4>(1), reader);
  REQUIRE_FALSE(out);
  CHECK_THAT(out.error().problem, Catch::Contains("shaders/broken.glsl:2:"));
}

namespace {

struct CacheRun {
  int compiled = 0, fromDisk = 0;
  size_t files = 0;
};

// Asks a fresh store for one program and runs it.
CacheRun useCache(const test::TemporaryFolder& folder, const std::string& driver) {
  shading::ProgramStore store(shading::shaderReader(), folder.path(), driver);
  const auto program = store.render("passes/fullscreen.vert.glsl", "passes/display.frag.glsl");
  REQUIRE(program);
  CHECK((*program)->id() != 0);
  GLint linked = 0;
  glGetProgramiv((*program)->id(), GL_LINK_STATUS, &linked);
  CHECK(linked == GL_TRUE);
  CacheRun run{store.statistics().compiled, store.statistics().fromDisk};
  if (std::filesystem::exists(folder.path() / "programs"))
    for ([[maybe_unused]] const auto& file : std::filesystem::directory_iterator(folder.path() / "programs"))
      ++run.files;
  return run;
}

std::filesystem::path onlyFile(const test::TemporaryFolder& folder) {
  return std::filesystem::directory_iterator(folder.path() / "programs")->path();
}

}  // namespace

TEST_CASE("Program cache: the second process takes the binary, another driver does not") {
  if (!test::contextInfo().programBinaries) return test::skip("the driver offers no program binaries");
  const test::TemporaryFolder folder;
  const CacheRun first = useCache(folder, "driver 1");
  CHECK(first.compiled == 1);
  CHECK(first.fromDisk == 0);
  CHECK(first.files == 1);
  const CacheRun second = useCache(folder, "driver 1");
  CHECK(second.compiled == 0);
  CHECK(second.fromDisk == 1);
  const CacheRun other = useCache(folder, "driver 2");
  CHECK(other.compiled == 1);
  CHECK(other.fromDisk == 0);
  CHECK(other.files == 2);
}

TEST_CASE("Program cache: a damaged file is compiled again and replaced") {
  if (!test::contextInfo().programBinaries) return test::skip("the driver offers no program binaries");
  const test::TemporaryFolder folder;
  useCache(folder, "driver");
  const std::filesystem::path file = onlyFile(folder);
  const auto size = std::filesystem::file_size(file);
  const bool cut = GENERATE(true, false);
  if (cut) {
    std::filesystem::resize_file(file, size / 3);  // within the key
  } else {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(size) - 64);
    stream << std::string(64, 'x');
  }
  const CacheRun damaged = useCache(folder, "driver");
  CHECK(damaged.compiled == 1);
  CHECK(damaged.fromDisk == 0);
  CHECK(damaged.files == 1);
  CHECK(useCache(folder, "driver").fromDisk == 1);
}

TEST_CASE("Programs: the same entry and defines are built once, other defines are another program") {
  shading::ProgramStore store = test::makeProgramStore();
  const auto mesh = [&](const std::vector<shading::Define>& defines) {
    const auto program = store.render("passes/mesh.vert.glsl", "passes/mesh.frag.glsl", defines);
    REQUIRE(program);
    return *program;
  };
  const gl::Program* plain = mesh({{"UNLIT"}});
  CHECK(mesh({{"UNLIT"}}) == plain);
  CHECK(store.statistics().compiled == 1);
  CHECK(mesh({{"UNLIT"}, {"HAS_NORMAL"}}) != plain);
  CHECK(store.statistics().compiled == 2);
  const auto missing = store.compute("passes/none.comp.glsl");
  REQUIRE_FALSE(missing);
  CHECK(describe(missing.error()) == "shaders/passes/none.comp.glsl: there is no such shader file.");
}

TEST_CASE("Programs: what was used longest ago is freed, and built again where it is asked for") {
  shading::ProgramStore store(
      [](const std::string& path) -> std::optional<std::string> {
        if (path == "a.comp.glsl")
          return "layout(local_size_x = 1) in;\nlayout(std430, binding = 0) buffer B { int b[]; };\n"
                 "void main() { b[0] = NUMBER; }\n";
        return shading::shaderReader()(path);
      },
      {}, "");
  const auto id = [&](int number) {
    const auto program = store.compute("a.comp.glsl", {{"NUMBER", std::to_string(number)}});
    REQUIRE(program);
    return (*program)->id();
  };
  std::vector<GLuint> ids;
  for (int number = 0; number < 6; ++number) ids.push_back(id(number));
  store.keepLatest(6);
  CHECK(store.size() == 6);
  CHECK(id(0) == ids[0]);  // used once more: now the latest
  store.keepLatest(3);
  CHECK(store.size() == 3);
  for (const int number : {0, 4, 5}) CHECK(glIsProgram(ids[static_cast<size_t>(number)]) == GL_TRUE);
  for (const int number : {1, 2, 3}) CHECK(glIsProgram(ids[static_cast<size_t>(number)]) == GL_FALSE);
  CHECK(store.statistics().compiled == 6);
  id(0), id(2);
  CHECK(store.statistics().compiled == 7);
  store.keepLatest(0);
  CHECK(store.size() == 0);
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
