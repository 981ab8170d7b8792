// Each pixel's standard error against what pictures of other random numbers differ by.

#include <catch2/catch.hpp>

#include "frame/session.hpp"
#include "frame/settings.hpp"

using namespace facet;
using frame::Picture, frame::PictureSettings;

namespace {

Result<Picture> drawn(frame::Session& session, const PictureSettings& settings, bool standardError = true) {
  Notes notes;
  Stages stages;
  return session.render("builtin:spheres", settings, {.radiance = true, .standardError = standardError}, notes, stages);
}

PictureSettings sized(int samples) {
  PictureSettings settings;
  settings.frame.width = settings.frame.height = 32;
  settings.quality.samples = samples;
  settings.quality.visibility = frame::Visibility::none;
  return settings;
}

// Of pixels that no light shines into from afar: what the few others do says nothing of a mean.
double darkMeanSquare(const io::RadianceImage& image, const io::RadianceImage& bright) {
  double sum = 0, count = 0;
  for (size_t i = 0; i < image.pixels.size(); ++i)
    if (const glm::dvec3 b(bright.pixels[i]), p(image.pixels[i]); std::max({b.x, b.y, b.z}) < 1)
      sum += glm::dot(p, p), count += 3;
  return sum / count;
}

}  // namespace

TEST_CASE("standard error: of drawn and of traced pictures it is what seeds differ by") {
  const auto session = frame::Session::create({});
  REQUIRE(session.has_value());
  for (const auto transport : {frame::Transport::direct, frame::Transport::paths}) {
    constexpr int seeds = 6;
    double stated = 0, squares = 0;
    std::vector<Picture> pictures;
    for (int seed = 0; seed < seeds; ++seed) {
      PictureSettings settings = sized(48);  // no power of two: the last part is not as long as all before
      settings.quality.transport = transport, settings.quality.seed = seed;
      Result<Picture> picture = drawn(**session, settings);
      REQUIRE(picture.has_value());
      REQUIRE(picture->standardError.pixels.size() == 32 * 32);
      pictures.push_back(std::move(*picture));
    }
    io::RadianceImage mean = pictures[0].radiance;
    for (size_t i = 0; i < mean.pixels.size(); ++i) {
      glm::vec4 sum(0);
      for (const Picture& picture : pictures) sum += picture.radiance.pixels[i];
      mean.pixels[i] = sum / static_cast<float>(seeds);
    }
    for (const Picture& picture : pictures) {
      io::RadianceImage apart = picture.radiance;
      for (size_t i = 0; i < apart.pixels.size(); ++i) apart.pixels[i] -= mean.pixels[i];
      squares += darkMeanSquare(apart, mean) / (seeds - 1);
      stated += darkMeanSquare(picture.standardError, mean) / seeds;
    }
    INFO("stated over true, squared: " << stated / squares);
    CHECK(stated / squares > 0.9);  // evener draws than independent ones are better than stated
    CHECK(stated / squares < 3);
    double of192 = 0;  // a quarter of what 48 have, but for what few pixels bear
    for (int seed = 0; seed < 3; ++seed) {
      PictureSettings settings = sized(192);
      settings.quality.transport = transport, settings.quality.seed = seed;
      of192 += darkMeanSquare(drawn(**session, settings)->standardError, mean) / 3;
    }
    INFO("of 192 samples over that of 48: " << of192 / stated);
    CHECK(of192 < 0.9 * stated);
  }
}

TEST_CASE("standard error: none where nothing is random or nothing is gathered, and asking changes no pixel") {
  const auto session = frame::Session::create({});
  REQUIRE(session.has_value());
  CHECK(drawn(**session, sized(4))->standardError.pixels.empty());
  const Result<Picture> asked = drawn(**session, sized(8)), unasked = drawn(**session, sized(8), false);
  CHECK(unasked->standardError.pixels.empty());
  CHECK(asked->radiance.pixels == unasked->radiance.pixels);
  // The background is even: where no sample met the scene the error is 0.
  PictureSettings plain = sized(16);
  plain.frame.background = frame::Background::color;
  const Result<Picture> picture = drawn(**session, plain);
  CHECK(picture->standardError.pixels.front() == glm::vec4(0));
}
