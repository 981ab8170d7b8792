#include <catch2/catch.hpp>
#include <cmath>

#include "frame/max_error.hpp"
#include "frame/session.hpp"
#include "support/picture.hpp"

using namespace facet;

namespace {

frame::PictureSettings poster(int samples) {
  frame::PictureSettings settings;
  settings.frame.width = settings.frame.height = 96;
  settings.sources.environment = "builtin:studio";
  settings.quality.samples = samples;
  settings.quality.visibility = frame::Visibility::none;
  return settings;
}

}  // namespace

TEST_CASE("max error: as many samples as the fall of the error says") {
  frame::PictureSettings settings;
  settings.quality.maxError = 0.01;  // 2.55 / 255
  using Errors = std::vector<std::pair<int, double>>;
  const auto next = [&](const Errors& errors, double rate = 0.5) {
    std::vector<frame::Attempt> attempts;
    for (const auto& [samples, error] : errors) attempts.push_back({samples, {0, error, rate}});
    return frame::nextSamples(settings, attempts);
  };
  CHECK(frame::firstSamples(settings) == 8);
  CHECK(next({{8, 2.21}}) == 0);  // 1.15 times below
  CHECK(next({{8, 2.23}}) == 10);
  CHECK(next({{8, 4.4}}) == 32);                    // 31.5
  CHECK(next({{8, 5.1}}, 0.8) == 24);               // 22.66; 4 ... 7 times a power of two
  CHECK(next({{8, 25.5}}) == 640);                  // half of 1058
  CHECK(next({{8, 25.5}, {224, 5.1}}) == 1280);     // fell by N^-0.483: 224 * 2.3^(1 / 0.483) = 1257
  CHECK(next({{8, 25.5}, {64, 5.1}}, 0.5) == 192);  // N^-0.774: 64 * 2.3^(1 / 0.774) = 187.7
  CHECK(next({{8, 25.5}, {224, 2.21}}) == 0);
  CHECK(next({{8, 1e9}}) == 4096);
  CHECK(next({{4096, 3}}) == 0);
  settings.quality.samples = 100;
  CHECK(next({{8, 1e9}}) == 100);
  CHECK(next({{8, 9}, {96, 2.6}}) == 100);
  CHECK(next({{100, 3}}) == 0);
  settings.quality.samples = 6;
  CHECK(frame::firstSamples(settings) == 6);
}

TEST_CASE("max error: the picture of that many samples, within the error, against the converged one", "[gl]") {
  test::Studio studio;
  const io::LoadedModel model = test::loadBuiltin("builtin:poster");
  frame::PictureSettings settings = poster(4);
  const auto truth = studio.render(model, poster(512)).display;
  for (const double wanted : {0.03, 0.012}) {
    settings.quality.maxError = wanted;
    const frame::Picture picture = studio.render(model, settings);
    const std::vector<frame::Attempt>& attempts = picture.statistics.attempts;
    REQUIRE_FALSE(attempts.empty());
    CHECK(attempts.size() <= 4);
    CHECK(frame::errorMargin * attempts.back().error.most <= 255 * wanted);
    for (size_t i = 0; i + 1 < attempts.size(); ++i) CHECK(frame::errorMargin * attempts[i].error.most > 255 * wanted);
    double squares = 0;
    for (size_t i = 0; i < truth.data.size(); ++i)
      squares += std::pow(double(truth.data[i]) - double(picture.display.data[i]), 2);
    const double error = std::sqrt(squares / double(truth.data.size()));
    INFO(attempts.back().samples << " samples, estimated " << attempts.back().error.most << ", true " << error);
    CHECK(error <= 255 * wanted);
    CHECK(attempts.back().error.most < 2 * error);
  }
}

TEST_CASE("max error: the same bytes as --samples with the number that was chosen", "[gl]") {
  test::Studio studio;
  const io::LoadedModel model = test::loadBuiltin("builtin:poster");
  frame::PictureSettings settings = poster(4);
  settings.quality.maxError = 0.015;
  const frame::Picture kept = studio.render(model, settings);
  // Sampled pictures read irradiance and DFG only; at 1.5 % the former is the default's, so that a scene of metals,
  // whose DFG table is coarser, differs by less than the table's error.
  const frame::Picture plain = studio.render(model, poster(kept.statistics.attempts.back().samples));
  REQUIRE(kept.display.data.size() == plain.display.data.size());
  int largest = 0;
  for (size_t i = 0; i < plain.display.data.size(); ++i)
    largest = std::max(largest, std::abs(int(kept.display.data[i]) - int(plain.display.data[i])));
  CHECK(largest <= 2);
}

TEST_CASE("max error: what cannot be reached is drawn with as many samples as are allowed", "[gl]") {
  test::Studio studio;
  frame::PictureSettings settings = poster(12);
  settings.quality.maxError = 1e-4;
  const frame::Picture picture = studio.render(test::loadBuiltin("builtin:poster"), settings);
  REQUIRE(picture.statistics.attempts.size() == 2);
  CHECK(picture.statistics.attempts[0].samples == 8);
  CHECK(picture.statistics.attempts[1].samples == 12);
  CHECK(picture.statistics.attempts[1].error.most > 255 * 1e-4);
  // What is told of the tables is what was chosen for them.
  REQUIRE(picture.statistics.methods.size() == 3);
  CHECK(picture.statistics.methods == ibl::chosenFor(1e-4));
  settings.quality.maxError.reset();
  CHECK(studio.render(test::loadBuiltin("builtin:poster"), settings).statistics.methods.empty());
}
