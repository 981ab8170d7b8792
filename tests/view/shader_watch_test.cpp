#include "view/shader_watch.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace facet;
using namespace std::chrono_literals;

TEST_CASE("shader watch: tells a newer file once, and looks only now and then") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("passes/mesh.glsl", std::string("1"));
  view::ShaderWatch watch = view::watchShaders(folder.path().string());
  auto now = std::chrono::steady_clock::now() + 1s;
  CHECK_FALSE(view::shadersChanged(watch, now));
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) + 5s);
  CHECK_FALSE(view::shadersChanged(watch, now + 100ms));
  CHECK(view::shadersChanged(watch, now + 1s));
  CHECK_FALSE(view::shadersChanged(watch, now + 2s));
  view::ShaderWatch embedded = view::watchShaders("");
  CHECK_FALSE(view::shadersChanged(embedded, now + 9s));
}
