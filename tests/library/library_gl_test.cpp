// The library beside another user of OpenGL, this test's own context.

#include <epoxy/egl.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <thread>

#include "io/image.hpp"
#include "io/radiance.hpp"
#include "library/facet.hpp"
#include "options/picture_options.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/gpu.hpp"

using namespace facet;

namespace {

std::vector<uint8_t> pngAsRgba(const std::string& file) {
  const Result<io::Pixels> read = io::readImage(file);
  REQUIRE(read);
  REQUIRE(read->channels == 4);
  return read->data;
}

}  // namespace

TEST_CASE("The library has every option of a picture, by its name and with its values") {
  size_t count = 0;
  for (const options::PictureOption& option : options::pictureOptions()) {
    REQUIRE(facet_option_name(count));
    CHECK(std::string(facet_option_name(count)) == option.name);
    CHECK(std::string(facet_option_help(count)) == options::helpOf(option));
    ++count;
  }
  CHECK(facet_option_name(count) == nullptr);
  CHECK(facet_interface() == FACET_INTERFACE);
}

TEST_CASE("The library's pictures are the command's, and leave the caller's OpenGL alone", "[library]") {
  const EGLContext before = eglGetCurrentContext();
  REQUIRE(before != EGL_NO_CONTEXT);
  const test::TemporaryFolder folder;
  const std::string model = folder.write("triangle.glb", test::triangle().glb()).string();
  Renderer first, second;
  REQUIRE(first);
  REQUIRE(second);
  const std::vector<std::pair<std::string, std::string>> some[] = {
      {{"size", "40x30"}, {"background", "transparent"}, {"env", "builtin:white"}},
      {{"size", "40x30"}, {"samples", "20"}, {"ground", "true"}, {"overlay", "bounds"}, {"env", "builtin:sky"}},
      {{"size", "33x17"}, {"channel", "depth"}, {"max-error", "2%"}}};
  for (const auto& options : some) {
    std::vector<std::string> words = {"render", model, "-o", folder.file("p.png")};
    for (const auto& [name, value] : options) {
      REQUIRE(first.set(name, value));
      words.push_back("--" + name);
      if (value != "true") words.push_back(value);
    }
    REQUIRE(test::runFacet(words).status == 0);
    words[3] = folder.file("p.exr");
    REQUIRE(test::runFacet(words).status == 0);
    REQUIRE(first.load(model));
    const Image<uint8_t> image = first.render();
    INFO(first.message());
    REQUIRE(image);
    CHECK(image.samples == pngAsRgba(folder.file("p.png")));
    const Image<float> radiance = first.radiance();
    const Result<io::RadianceImage> exr = io::readRadiance(folder.file("p.exr"));
    REQUIRE(exr);
    REQUIRE(radiance.samples.size() == exr->pixels.size() * 4);
    CHECK(std::memcmp(radiance.samples.data(), exr->pixels.data(), radiance.samples.size() * sizeof(float)) == 0);
    for (const auto& [name, value] : options) REQUIRE(first.unset(name));
  }
  CHECK(eglGetCurrentContext() == before);
  // One ends, the other one goes on, from whatever thread.
  first = Renderer();
  { const Renderer ended = std::move(first); }
  std::thread([&] {
    REQUIRE(second.set("size", "9x5"));
    REQUIRE(second.load(model));
    CHECK(second.render().samples.size() == 9 * 5 * 4);
  }).join();
  CHECK(eglGetCurrentContext() == before);
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("What is wrong is a sentence and a status, and the next call is as if nothing had been", "[library]") {
  const test::TemporaryFolder folder;
  Renderer renderer;
  REQUIRE(renderer);
  const auto says = [&](bool done, const std::string& sentence) {
    CHECK_FALSE(done);
    CHECK(renderer.status() == FACET_BAD_INPUT);
    CHECK_THAT(renderer.message(), Catch::Contains(sentence));
  };
  says(bool(renderer.render()), "there is no model to draw; load one.");
  says(renderer.load(""), "no model is named");
  says(renderer.load(folder.file("no.glb")), "no.glb: no such file");
  says(renderer.load(folder.write("bad.glb", std::string("glTF")).string()), "bad.glb: ");
  says(renderer.set("--size", "1x1"), "'--size': there is no such option");
  says(renderer.set("size", "1y1"), "--size: '1y1' is not a size; give WIDTHxHEIGHT such as 1280x720.");
  REQUIRE(renderer.load("builtin:furnace"));
  CHECK(renderer.message().empty());
  REQUIRE(renderer.set("size", "8x8"));
  REQUIRE(renderer.set("variant", "red"));
  says(bool(renderer.render()), "(--variant)");
  REQUIRE(renderer.unset("variant"));
  REQUIRE(renderer.set("env", folder.file("no.hdr")));
  says(bool(renderer.render()), "no.hdr: no such file");
  REQUIRE(renderer.set("env", "builtin:white"));
  CHECK(renderer.render());
  // The C interface takes what C programs get wrong.
  CHECK(facet_open(0, nullptr) == FACET_BAD_INPUT);
  CHECK(facet_load(nullptr, "a") == FACET_BAD_INPUT);
  CHECK(std::string(facet_message(nullptr)) != "");
  facet_close(nullptr);
  facet_renderer* plain = nullptr;
  REQUIRE(facet_open(FACET_NO_CACHE, &plain) == FACET_GOOD);
  facet_picture picture{};
  CHECK(facet_render(plain, 7, &picture) == FACET_BAD_INPUT);
  CHECK(std::string(facet_message(plain)) == "there is no format 7; give 0 (bytes) or 1 (floats).");
  CHECK(facet_render(plain, 0, nullptr) == FACET_BAD_INPUT);
  CHECK(facet_set(plain, nullptr, nullptr) == FACET_BAD_INPUT);
  CHECK(facet_load(plain, nullptr) == FACET_BAD_INPUT);
  facet_close(plain);
}

TEST_CASE("The library says what is shown otherwise than asked for", "[library]") {
  const test::TemporaryFolder folder;
  test::GltfBuilder broken = test::triangle();
  broken.json["images"] = {{{"uri", "no.png"}}};  // and there are no coordinates
  broken.json["textures"] = {{{"source", 0}}};
  broken.json["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  broken.json["meshes"][0]["primitives"][0]["material"] = 0;
  Renderer renderer;
  REQUIRE(renderer.set("size", "8x8"));
  REQUIRE(renderer.set("overlay", "axes"));
  REQUIRE(renderer.load(folder.write("a.glb", broken.glb()).string()));
  std::vector<std::string> warnings = renderer.warnings();
  REQUIRE(warnings.size() == 1);
  CHECK_THAT(warnings[0], Catch::Contains("a.glb: ") && Catch::Contains("the texture is not used"));
  REQUIRE(renderer.radiance());
  warnings = renderer.warnings();
  REQUIRE_FALSE(warnings.empty());
  CHECK_THAT(warnings.back(), Catch::Contains("--overlay: an EXR is the radiance below it"));
}
