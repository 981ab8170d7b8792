#include <catch2/catch.hpp>
#include <filesystem>

#include "ibl/layers.hpp"
#include "io/radiance.hpp"
#include "optics/energy.hpp"
#include "support/command.hpp"

using namespace facet;

TEST_CASE("facet tables: an EXR for each, of a white environment what the integrals are") {
  test::TemporaryFolder folder;
  const std::string out = folder.file("made/tables");
  const test::Outcome made = test::runFacet({"tables", "--env", "builtin:white", "-o", out});
  INFO(made.text);
  REQUIRE(made.status == 0);
  CHECK(made.text.find("| irradiance.exr ") != std::string::npos);
  CHECK(std::distance(std::filesystem::directory_iterator(out), {}) == 4 + layout::ldLayerCount);

  const auto read = [&](const std::string& name) {
    const Result<io::RadianceImage> image = io::readRadiance(out + "/" + name);
    INFO(name);
    REQUIRE(image.has_value());
    return *image;
  };
  // Radiance 1 from everywhere is irradiance / pi and prefiltered radiance 1.
  for (const char* name : {"irradiance.exr", "ld-0.00.exr", "ld-0.30.exr", "ld-1.00.exr", "environment.exr"}) {
    const io::RadianceImage image = read(name);
    CHECK(image.height == 6 * image.width);
    float least = 10, most = 0;
    for (const glm::vec4& p : image.pixels)
      for (int c = 0; c < 3; ++c) least = std::min(least, p[c]), most = std::max(most, p[c]);
    INFO(name);
    CHECK(least == Approx(1).margin(2e-3));
    CHECK(most == Approx(1).margin(2e-3));
  }
  // Row and column are where the list says that they are.
  const io::RadianceImage dfg = read("dfg.exr");
  REQUIRE(dfg.width == 64);
  const int column = 40, row = 20;
  const double u = column / 63.0, r = row / 63.0;
  const optics::Dfg truth = optics::integrateDfg(u * u, r * r);
  const glm::vec4 pixel = dfg.pixels[static_cast<size_t>(row * 64 + column)];
  CHECK(pixel.x == Approx(truth.A).margin(1e-3));
  CHECK(pixel.y == Approx(truth.B).margin(1e-3));

  const test::Outcome none = test::runFacet({"tables"});
  CHECK(none.status == 2);
  const test::Outcome wrong = test::runFacet({"tables", "--env", "builtin:blue", "-o", out});
  CHECK(wrong.status == 2);
  CHECK(wrong.text.find("studio") != std::string::npos);
}

TEST_CASE("facet tables: a face of the irradiance is turned as OpenGL has it, the sky is brighter above") {
  test::TemporaryFolder folder;
  REQUIRE(test::runFacet({"tables", "--env", "builtin:sky", "-o", folder.file("t")}).status == 0);
  const Result<io::RadianceImage> image = io::readRadiance(folder.file("t/irradiance.exr"));
  REQUIRE(image.has_value());
  const auto at = [&](int face, int x, int y) {
    return image->pixels[static_cast<size_t>((face * image->width + y) * image->width + x)].y;
  };
  const int middle = image->width / 2;
  CHECK(at(2, middle, middle) > 2 * at(3, middle, middle));                                             // +Y above -Y
  for (const int side : {0, 1, 4, 5}) CHECK(at(side, middle, 0) > at(side, middle, image->width - 1));  // rows go down
}
