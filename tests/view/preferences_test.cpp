#include "view/preferences.hpp"

#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <csignal>

#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("preferences: what is written is read again, what is missing is as usual") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "deep" / "settings.json";
  CHECK(view::readPreferences(file).value() == view::Preferences{});
  const view::Preferences set{view::Theme::light, 1.5f, true, true, 1920, 1080, view::Hand::trackball};
  REQUIRE(view::writePreferences(file, set));
  CHECK(view::readPreferences(file).value() == set);
  REQUIRE(view::writePreferences(file, {}));
  CHECK(view::readPreferences(file).value() == view::Preferences{});
}

TEST_CASE("preferences: where nothing can be written, a sentence says so and what was set before stays") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "settings.json";
  const view::Preferences before{view::Theme::light, 1.5f, true, true, 1920, 1080};
  REQUIRE(view::writePreferences(file, before));
  // A full disk, as far as a process can have one of its own: no byte more in any file.
  rlimit former{};
  REQUIRE(::getrlimit(RLIMIT_FSIZE, &former) == 0);
  const auto handler = ::signal(SIGXFSZ, SIG_IGN);
  const rlimit none{0, former.rlim_max};
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &none) == 0);
  const Result<void> full = view::writePreferences(file, {});
  REQUIRE(::setrlimit(RLIMIT_FSIZE, &former) == 0);
  ::signal(SIGXFSZ, handler);
  REQUIRE_FALSE(full);
  CHECK(describe(full.error()) == file.string() +
                                      ": cannot be written: File too large; check the folder, its permissions and "
                                      "the space left.");
  CHECK(view::readPreferences(file).value() == before);
  CHECK(std::distance(std::filesystem::directory_iterator(folder.path()), {}) == 1);
  // A home that is not there, or in which nothing can be made, whoever asks.
  const Result<void> closed = view::writePreferences(file / "deeper" / "settings.json", {});
  REQUIRE_FALSE(closed);
  CHECK(describe(closed.error()).find("cannot be written: Not a directory") != std::string::npos);
  CHECK_FALSE(view::writePreferences("/proc/facet/settings.json", {}));
}

TEST_CASE("preferences: what is wrong in the file is told, what is out of range is brought into it") {
  const test::TemporaryFolder folder;
  const auto read = [&](const std::string& text) { return view::readPreferences(folder.write("settings.json", text)); };
  CHECK(read(R"({"scale": 99})").value().scale == 4);
  CHECK(read(R"({"scale": 0, "size": [-5, 1e9]})").value().width == 0);
  CHECK(read(R"({"other": true})").value() == view::Preferences{});
  for (const char* text : {"", "[]", "{", R"({"theme": 3})", R"({"scale": "big"})", R"({"size": [1]})",
                           R"({"playOnOpening": 1})", R"({"mouse": "3d"})"}) {
    INFO(text);
    CHECK_FALSE(read(text));
  }
  CHECK(read(R"({"theme": "pink"})").error().place == "/theme");
}
