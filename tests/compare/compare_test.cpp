#include "compare/compare.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/srgb.hpp"
#include "compare/legend.hpp"
#include "support/not_a_number.hpp"

using namespace facet;
using compare::comparePictures;
using compare::Comparison;

using facet::test::notANumber;

namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

io::RadianceImage uniform(int width, int height, const glm::vec4& color) {
  return {width, height, std::vector<glm::vec4>(static_cast<size_t>(width * height), color)};
}

glm::vec4& at(io::RadianceImage& image, int x, int y) { return image.pixels[static_cast<size_t>(y * image.width + x)]; }

// Linear grey that is shown as `encoded`.
glm::vec4 grey(double encoded) {
  const float linear = static_cast<float>(linearFromSrgb(encoded));
  return {linear, linear, linear, 1};
}

}  // namespace

TEST_CASE("a picture does not differ from itself") {
  io::RadianceImage image = uniform(9, 5, glm::vec4(0.2f, 0.4f, 3.0f, 1));
  at(image, 4, 2) = glm::vec4(1e5f, -1, 0, 0.5f);
  const Result<Comparison> c = comparePictures(image, image);
  REQUIRE(c);
  CHECK(c->relRmse == 0);
  CHECK(c->bias == std::array<double, 3>{0, 0, 0});
  CHECK(c->displayRmse == 0);
  CHECK(c->largest == 0);
  CHECK(c->shareAbove == 0);
  CHECK(c->ssim == Approx(1).margin(1e-6));
  CHECK(c->pixels == 45);
  CHECK(c->finite());
}

TEST_CASE("a constant offset gives the figures of its closed form") {
  const Result<Comparison> c =
      comparePictures(uniform(16, 12, {0.5f, 0.25f, 0.75f, 1}), uniform(16, 12, {0.6f, 0.25f, 0.5f, 1}));
  REQUIRE(c);
  CHECK(c->relRmse == Approx(std::sqrt((0.01 + 0 + 0.0625) / 3) / 0.5).epsilon(1e-6));
  CHECK(c->bias[0] == Approx(0.2).epsilon(1e-6));
  CHECK(c->bias[1] == 0);
  CHECK(c->bias[2] == Approx(-1.0 / 3).epsilon(1e-6));
  const double red = srgbFromLinear(0.6) - srgbFromLinear(0.5), blue = srgbFromLinear(0.5) - srgbFromLinear(0.75);
  CHECK(c->displayRmse == Approx(255 * std::sqrt((red * red + blue * blue) / 3)).epsilon(1e-6));
  CHECK(c->largest == Approx(-blue).epsilon(1e-6));
  CHECK(c->shareAbove == 1);
}

TEST_CASE("one bad pixel is found, and what it adds is known") {
  io::RadianceImage picture = uniform(10, 10, glm::vec4(0.25f, 0.25f, 0.25f, 1));
  const io::RadianceImage reference = picture;
  at(picture, 3, 7) = glm::vec4(1, 1, 1, 1);
  const Result<Comparison> c = comparePictures(reference, picture);
  REQUIRE(c);
  CHECK(c->relRmse == Approx(0.75 / 10 / 0.25));
  CHECK(c->bias[1] == Approx(0.75 / 100 / 0.25));
  CHECK(c->displayRmse == Approx(25.5 * (1 - srgbFromLinear(0.25))));
  CHECK(c->largest == Approx(1 - srgbFromLinear(0.25)));
  CHECK(c->largestX == 3);
  CHECK(c->largestY == 7);
  CHECK(c->shareAbove == Approx(0.01));
  CHECK(c->ssim < 0.9);
}

TEST_CASE("the tolerance separates what counts as different") {
  const io::RadianceImage reference = uniform(4, 4, grey(0.5)), picture = uniform(4, 4, grey(0.52));
  CHECK(comparePictures(reference, picture, {.tolerance = 0.0199})->shareAbove == 1);
  CHECK(comparePictures(reference, picture, {.tolerance = 0.0201})->shareAbove == 0);
}

TEST_CASE("display figures clamp, linear ones do not") {
  const Result<Comparison> c = comparePictures(uniform(3, 3, {2, 2, 2, 1}), uniform(3, 3, {4, 4, 4, 1}));
  REQUIRE(c);
  CHECK(c->relRmse == Approx(1));
  CHECK(c->displayRmse == 0);
  CHECK(c->largest == 0);
}

TEST_CASE("a wrong alpha is a difference even where the colour is black") {
  const Result<Comparison> c = comparePictures(uniform(2, 2, {0, 0, 0, 1}), uniform(2, 2, {0, 0, 0, 0.75f}));
  REQUIRE(c);
  const double overWhite = srgbFromLinear(0.25);
  CHECK(c->largest == Approx(overWhite));
  CHECK(c->shareAbove == 1);
  CHECK(c->displayRmse == Approx(255 * overWhite));
  CHECK(c->alphaRmse == Approx(0.25 * 255));
}

TEST_CASE("what only covers is seen over white") {
  // A black disc against nothing, half of the picture: over black they are the same.
  io::RadianceImage disc = uniform(32, 16, glm::vec4(0)), empty = disc;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) at(disc, x, y).a = 1;
  for (const auto& [reference, picture] : {std::pair(disc, empty), std::pair(empty, disc)}) {
    const Result<Comparison> c = comparePictures(reference, picture);
    REQUIRE(c);
    CHECK(c->displayRmse == Approx(255 * std::sqrt(0.5)));
    CHECK(c->alphaRmse == Approx(255 * std::sqrt(0.5)));
    CHECK(std::abs(c->bias[1]) >= 0.5);
    CHECK(c->flipMean > 0.4);
    CHECK(c->shareNoticeable >= 0.5);
    CHECK(c->ssim < 0.6);
    CHECK(c->largest == 1);
    CHECK(c->shareAbove == 0.5);
  }
  // White against nothing differs over black only, and that is not lost.
  io::RadianceImage white = disc;
  for (glm::vec4& v : white.pixels) v = glm::vec4(v.a);
  const Result<Comparison> c = comparePictures(empty, white);
  REQUIRE(c);
  CHECK(c->displayRmse == Approx(255 * std::sqrt(0.5)));
  // Half covered: over white half of it is left.
  const Result<Comparison> half = comparePictures(uniform(8, 8, {0, 0, 0, 0.5f}), uniform(8, 8, glm::vec4(0)));
  REQUIRE(half);
  CHECK(half->alphaRmse == Approx(127.5));
  CHECK(half->displayRmse == Approx(255 * (1 - srgbFromLinear(0.5))).epsilon(1e-5));
  // The same colours behind no coverage at all are no difference.
  CHECK(comparePictures(empty, empty)->displayRmse == 0);
  CHECK(compare::displayDifference({0, 0, 0, 1}, {0, 0, 0, 0.75f}) == Approx(srgbFromLinear(0.25)));
}

TEST_CASE("not finite: counted, never within, zero in the sums") {
  const float bad = GENERATE(as<float>{}, notANumber, infinite, -infinite);
  const int channel = GENERATE(0, 1, 2, 3);
  io::RadianceImage reference = uniform(10, 10, {0.5f, 0.5f, 0.5f, 1}), picture = reference;
  at(picture, 6, 1)[channel] = bad;
  SECTION("in the picture") {
    const Result<Comparison> c = comparePictures(reference, picture, {.tolerance = 0.999});
    REQUIRE(c);
    CHECK(c->nonFinitePicture == 1);
    CHECK(c->nonFiniteReference == 0);
    CHECK_FALSE(c->finite());
    CHECK(c->largest == 1);
    CHECK(c->largestX == 6);
    CHECK(c->largestY == 1);
    CHECK(c->shareAbove == Approx(0.01));
    CHECK(c->relRmse == Approx(channel == 3 ? 0 : std::sqrt(0.25 / 300) / 0.5).margin(1e-12));
    CHECK(std::isfinite(c->ssim));
  }
  SECTION("in both at one place: they still fail") {
    const Result<Comparison> c = comparePictures(picture, picture);
    REQUIRE(c);
    CHECK(c->nonFinitePicture == 1);
    CHECK(c->nonFiniteReference == 1);
    CHECK_FALSE(c->finite());
    CHECK(c->largest == 1);
  }
}

TEST_CASE("the mask is where the reference's alpha is above one half") {
  io::RadianceImage reference = uniform(4, 1, {0.5f, 0.5f, 0.5f, 1}), picture = reference;
  at(reference, 0, 0).a = 0.5f;  // not above
  at(reference, 1, 0).a = 0.51f;
  at(picture, 0, 0) = {9, 9, 9, 1};
  at(picture, 3, 0) = {1, 1, 1, 1};
  const Result<Comparison> c = comparePictures(reference, picture, {.maskFromAlpha = true});
  REQUIRE(c);
  CHECK(c->pixels == 3);
  CHECK(c->bias[0] == Approx(0.5 / 3 / 0.5));
  CHECK(c->largestX == 1);  // 0.49 of alpha is more than what white differs from 0.5
  SECTION("NaN outside the mask is still counted") {
    at(picture, 0, 0).r = notANumber;
    const Result<Comparison> outside = comparePictures(reference, picture, {.maskFromAlpha = true});
    CHECK(outside->nonFinitePicture == 1);
    CHECK(outside->bias[0] == Approx(0.5 / 3 / 0.5));
  }
  SECTION("an empty mask is an error") {
    const Result<Comparison> none = comparePictures(uniform(4, 1, glm::vec4(0)), picture, {.maskFromAlpha = true});
    REQUIRE_FALSE(none);
    CHECK(describe(none.error()) == "no pixel of the reference has an alpha above 0.5; compare without the mask.");
  }
}

TEST_CASE("a black reference keeps the relative figures finite") {
  const Result<Comparison> same = comparePictures(uniform(3, 3, {0, 0, 0, 1}), uniform(3, 3, {0, 0, 0, 1}));
  CHECK(same->relRmse == 0);
  const Result<Comparison> other = comparePictures(uniform(3, 3, {0, 0, 0, 1}), uniform(3, 3, {1, 1, 1, 1}));
  CHECK(other->relRmse == Approx(1e9));
  CHECK(other->bias[2] == Approx(1e9));
}

TEST_CASE("pictures of different sizes are refused") {
  const Result<Comparison> c = comparePictures(uniform(4, 6, glm::vec4(1)), uniform(6, 4, glm::vec4(1)));
  REQUIRE_FALSE(c);
  CHECK(describe(c.error()) == "the sizes differ, 4x6 and 6x4; compare pictures of one size.");
  CHECK_FALSE(compare::heatMap(uniform(4, 6, glm::vec4(1)), uniform(6, 4, glm::vec4(1))));
  CHECK_FALSE(comparePictures({}, {}));
}

TEST_CASE("heat map: the scale's stops and what lies between") {
  using Color = std::array<uint8_t, 3>;
  CHECK(compare::heatColor(0) == Color{0, 0, 0});
  CHECK(compare::heatColor(1.0 / 16) == Color{0, 0, 255});
  CHECK(compare::heatColor(1.0 / 4) == Color{255, 0, 0});
  CHECK(compare::heatColor(9.0 / 16) == Color{255, 255, 0});
  CHECK(compare::heatColor(1) == Color{255, 255, 255});
  CHECK(compare::heatColor(1.0 / 64) == Color{0, 0, 128});      // half way to blue
  CHECK(compare::heatColor(0.140625) == Color{128, 0, 128});    // (3/8)^2, half way to red
  CHECK(compare::heatColor(0.765625) == Color{255, 255, 128});  // (7/8)^2, half way to white
  CHECK(compare::heatColor(1 / 255.0)[2] == 64);                // the smallest step of 8 bit can be seen
  CHECK(compare::heatColor(-1) == Color{0, 0, 0});
  CHECK(compare::heatColor(2) == Color{255, 255, 255});
}

TEST_CASE("heat map: a pixel for a pixel, magenta where not finite, grey outside the mask") {
  io::RadianceImage reference = uniform(5, 2, {0, 0, 0, 1}), picture = reference;
  at(picture, 1, 0) = grey(0.25);
  at(picture, 2, 1).g = notANumber;
  at(reference, 3, 1) = glm::vec4(0);
  const Result<io::Pixels> map = compare::heatMap(reference, picture, {.maskFromAlpha = true});
  REQUIRE(map);
  CHECK((map->width == 5 && map->height == 2 && map->channels == 3 && map->bytesPerSample == 1));
  REQUIRE(map->data.size() == 30);
  const auto pixel = [&](size_t x, size_t y) {
    const size_t i = 3 * (5 * y + x);
    return std::array<int, 3>{map->data[i], map->data[i + 1], map->data[i + 2]};
  };
  CHECK(pixel(0, 0) == std::array<int, 3>{0, 0, 0});
  CHECK(pixel(1, 0) == std::array<int, 3>{255, 0, 0});
  CHECK(pixel(2, 1) == std::array<int, 3>{255, 0, 255});
  CHECK(pixel(3, 1) == std::array<int, 3>{48, 48, 48});
}

TEST_CASE("stored pixels become linear with associated alpha") {
  io::Pixels pixels;
  pixels.width = 2, pixels.height = 1;
  SECTION("8 bit RGBA") {
    pixels.channels = 4;
    pixels.data = {255, 128, 0, 255, 255, 128, 0, 51};
    const io::RadianceImage image = compare::linearPicture(pixels);
    CHECK(image.pixels[0] == glm::vec4(1, static_cast<float>(linearFromSrgb(128 / 255.0)), 0, 1));
    CHECK(image.pixels[1].r == Approx(0.2));
    CHECK(image.pixels[1].g == Approx(0.2 * linearFromSrgb(128 / 255.0)));
    CHECK(image.pixels[1].a == Approx(0.2));
  }
  SECTION("grey and grey with alpha") {
    pixels.channels = 1;
    pixels.data = {0, 255};
    CHECK(compare::linearPicture(pixels).pixels[1] == glm::vec4(1, 1, 1, 1));
    pixels.channels = 2;
    pixels.data = {0, 255, 255, 0};
    CHECK(compare::linearPicture(pixels).pixels[0] == glm::vec4(0, 0, 0, 1));
    CHECK(compare::linearPicture(pixels).pixels[1] == glm::vec4(0, 0, 0, 0));
  }
  SECTION("16 bit RGB") {
    pixels.channels = 3, pixels.bytesPerSample = 2;
    const uint16_t samples[6] = {65535, 0, 32768, 1, 2, 3};
    pixels.data.resize(sizeof samples);
    std::memcpy(pixels.data.data(), samples, sizeof samples);
    const io::RadianceImage image = compare::linearPicture(pixels);
    CHECK(image.pixels[0].b == Approx(linearFromSrgb(32768 / 65535.0)));
    CHECK(image.pixels[1].r == Approx(1 / 65535.0 / 12.92));
  }
}

TEST_CASE("compare: where one pixel of a thousand bears the error it is told apart") {
  io::RadianceImage reference{100, 100, std::vector<glm::vec4>(10000, glm::vec4(0.25f, 0.25f, 0.25f, 1))};
  io::RadianceImage picture = reference;
  for (size_t i = 0; i < picture.pixels.size(); ++i)
    picture.pixels[i] += glm::vec4(glm::vec3(i % 2 ? 1e-3f : -1e-3f), 0);
  const auto even = compare::comparePictures(reference, picture);
  REQUIRE(even.has_value());
  CHECK(even->worstShare == Approx(0.001).epsilon(0.02));
  CHECK(even->trimmedRmse == Approx(even->displayRmse).epsilon(0.01));
  CHECK(even->relMse == Approx(1e-6 / (0.0625 + 0.01)).epsilon(1e-3));
  CHECK(even->percentile99 == Approx(even->largest).epsilon(0.01));
  for (const size_t i : {5u, 500u, 5000u}) picture.pixels[i] = glm::vec4(1);  // three of the ten worst
  const auto spiky = compare::comparePictures(reference, picture);
  CHECK(spiky->worstShare > 0.98);
  CHECK(spiky->trimmedRmse == Approx(even->displayRmse).epsilon(0.01));
  CHECK(spiky->percentile99 == Approx(even->percentile99));
  CHECK(spiky->largest > 0.4);
  const auto maps = compare::differenceMaps(reference, picture);
  REQUIRE(maps.has_value());
  CHECK(maps->difference.pixels[0].x == Approx(-1e-3f).epsilon(1e-3));
  CHECK(maps->relative.pixels[1].y == Approx(4e-3f).epsilon(1e-3));
  CHECK(maps->difference.pixels[5].z == Approx(0.75f));
}

TEST_CASE("compare: of few pixels none is trimmed, and a percentile is not exceeded by more than it says") {
  io::RadianceImage reference{10, 1, std::vector<glm::vec4>(10, glm::vec4(0, 0, 0, 1))}, picture = reference;
  picture.pixels[4] = glm::vec4(1);
  const auto c = compare::comparePictures(reference, picture);
  REQUIRE(c.has_value());
  CHECK(c->trimmedRmse == Approx(c->displayRmse).epsilon(1e-6));
  CHECK(c->percentile99 == 1);
  CHECK(c->worstShare == 0);
}

TEST_CASE("withLegend: below the map the scale of its colours, which stays as it is, none where it is too narrow") {
  io::Pixels map{.width = 200, .height = 10, .channels = 3, .data = std::vector<uint8_t>(200 * 10 * 3, 77)};
  const io::Pixels with = compare::withLegend(map);
  CHECK(with.width == 200);
  REQUIRE(with.height > 30);
  CHECK(std::equal(map.data.begin(), map.data.end(), with.data.begin()));
  const auto at = [&](int x, int y) {
    const uint8_t* p = &with.data[static_cast<size_t>((y * with.width + x) * 3)];
    return std::array<uint8_t, 3>{p[0], p[1], p[2]};
  };
  // In the middle of the bar a quarter, at its ends nothing and all.
  const auto near = [](const std::array<uint8_t, 3>& a, const std::array<uint8_t, 3>& b) {
    for (size_t c = 0; c < 3; ++c)
      if (std::abs(int(a[c]) - int(b[c])) > 8) return false;
    return true;
  };
  CHECK(near(at(100, 18), compare::heatColor(0.25)));
  CHECK(near(at(4, 18), compare::heatColor(0)));
  CHECK(near(at(195, 18), compare::heatColor(1)));
  // Letters below it: "1/4" about the middle, none between the numbers.
  const auto lit = [&](int left, int right) {
    int count = 0;
    for (int y = 26; y < 38; ++y)
      for (int x = left; x < right; ++x) count += at(x, y)[0] > 200 ? 1 : 0;
    return count;
  };
  CHECK(lit(88, 112) > 15);
  CHECK(lit(70, 85) == 0);
  map.width = 20, map.height = 100;
  CHECK(compare::withLegend(map).height == 100);
}
