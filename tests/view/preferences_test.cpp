#include "view/preferences.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("preferences: what is written is read again, what is missing is as usual") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "deep" / "settings.json";
  CHECK(view::readPreferences(file).value() == view::Preferences{});
  const view::Preferences set{view::Theme::light, 1.5f, true, true, 1920, 1080};
  REQUIRE(view::writePreferences(file, set));
  CHECK(view::readPreferences(file).value() == set);
  REQUIRE(view::writePreferences(file, {}));
  CHECK(view::readPreferences(file).value() == view::Preferences{});
}

TEST_CASE("preferences: what is wrong in the file is told, what is out of range is brought into it") {
  const test::TemporaryFolder folder;
  const auto read = [&](const std::string& text) { return view::readPreferences(folder.write("settings.json", text)); };
  CHECK(read(R"({"scale": 99})").value().scale == 4);
  CHECK(read(R"({"scale": 0, "size": [-5, 1e9]})").value().width == 0);
  CHECK(read(R"({"other": true})").value() == view::Preferences{});
  for (const char* text :
       {"", "[]", "{", R"({"theme": 3})", R"({"scale": "big"})", R"({"size": [1]})", R"({"playOnOpening": 1})"}) {
    INFO(text);
    CHECK_FALSE(read(text));
  }
  CHECK(read(R"({"theme": "pink"})").error().place == "/theme");
}
