#include "io/measured.hpp"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "io/merl.hpp"
#include "optics/synthetic_brdf.hpp"
#include "support/not_a_number.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;
using optics::MeasuredKind;

using facet::test::notANumber;

namespace {

std::vector<uint8_t> merlBytesOf(int phiSteps, double value) {
  std::vector<uint8_t> bytes(io::merlBytes(phiSteps));
  const int32_t dimensions[3] = {90, 90, phiSteps};
  std::memcpy(bytes.data(), dimensions, 12);
  for (size_t i = 12; i < bytes.size(); i += 8) std::memcpy(bytes.data() + i, &value, 8);
  return bytes;
}

void put(std::vector<uint8_t>& bytes, size_t at, double value) { std::memcpy(bytes.data() + at, &value, 8); }

std::string problemOf(const std::string& path) {
  const auto brdf = io::readMeasured(path);
  REQUIRE_FALSE(brdf.has_value());
  return describe(brdf.error());
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

TEST_CASE("MERL: order, scale, counts, written and read again it is the same") {
  std::vector<uint8_t> bytes = merlBytesOf(180, 1500);
  CHECK(bytes.size() == 34992012);
  const size_t plane = size_t{8} * 90 * 90 * 180, cell = (2 * 90 + 3) * 180 + 4;  // theta_h 2, theta_d 3, phi_d 4
  put(bytes, 12 + 8 * cell, 3000);
  put(bytes, 12 + plane + 8 * cell, 300);
  put(bytes, 12 + 2 * plane + 8 * cell, 30);
  put(bytes, 12 + 8 * 0, -1);
  put(bytes, 12 + 8 * 1, notANumber);
  put(bytes, 12 + plane + 8 * 2, infinity);
  put(bytes, 12 + plane + 8 * 3, 1e300);  // above what single precision holds
  const auto brdf = io::decodeMerl(bytes, "x");
  REQUIRE(brdf.has_value());
  CHECK(brdf->values[cell].x == Approx(2));
  CHECK(brdf->values[cell].y == Approx(0.2 * 1.15));
  CHECK(brdf->values[cell].z == Approx(0.02 * 1.66));
  CHECK(brdf->values[5] == glm::vec3(1, 1.15f, 1.66f));
  for (size_t i = 0; i < 4; ++i) CHECK(brdf->values[i] == glm::vec3(-1));
  CHECK(brdf->counts.negative == 1);
  CHECK(brdf->counts.notANumber == 1);
  CHECK(brdf->counts.infinite == 1);
  CHECK(brdf->counts.tooLarge == 1);  // 1e300 is finite
  CHECK(io::measuredNotes(*brdf).size() == 4);
  const auto again = io::decodeMerl(io::encodeMerl(*brdf), "x");
  REQUIRE(again.has_value());
  CHECK(again->values == brdf->values);
  CHECK(again->counts.negative == 4);
}

TEST_CASE("MERL: 360 steps of phi_d are accepted where size and dimensions say so, and noted") {
  const auto brdf = io::decodeMerl(merlBytesOf(360, 1500), "x");
  REQUIRE(brdf.has_value());
  CHECK(brdf->phiSteps == 360);
  REQUIRE(io::measuredNotes(*brdf).size() == 1);
  CHECK(holds(io::measuredNotes(*brdf)[0].text, "360 steps"));
  std::vector<uint8_t> half = merlBytesOf(180, 1500);
  half[8] = 104, half[9] = 1;  // 360 in the header only
  CHECK(holds(describe(io::decodeMerl(half, "x").error()), "has 34992012 bytes, but its dimensions need 69984012"));
}

TEST_CASE("UTIA: order, decoding, counts, written and read again it is the same") {
  std::vector<uint8_t> bytes(io::utiaBytes);
  CHECK(bytes.size() == 1990656);
  for (size_t i = 0; i < bytes.size(); i += 8) put(bytes, i, 0.25);
  const size_t plane = 8 * 288 * 288, cell = 288 * (48 * 1 + 2) + 48 * 3 + 4;
  put(bytes, 8 * cell, 0.5);
  put(bytes, plane + 8 * cell, 0.125);
  put(bytes, 0, -0.1);
  const auto raw = io::decodeUtia(bytes, "x");
  REQUIRE(raw.has_value());
  CHECK(raw->values[cell] == glm::vec3(0.5f, 0.125f, 0.25f));
  CHECK(raw->values[0] == glm::vec3(-1));
  CHECK(raw->counts.negative == 1);
  REQUIRE(io::measuredNotes(*raw).size() == 1);
  CHECK(io::measuredNotes(*raw)[0].severity == Note::Severity::warning);
  const auto srgb = io::decodeUtia(bytes, "x", io::UtiaDecode::srgb);
  CHECK(srgb->values[cell].x == Approx(0.21404114));
  const auto scaled = io::decodeUtia(bytes, "x", io::UtiaDecode::srgb140);
  CHECK(scaled->values[cell].x == Approx(100 * 0.5 / 140 / 12.92));
  const auto again = io::decodeUtia(io::encodeUtia(*raw), "x");
  CHECK(again->values == raw->values);
  CHECK(io::parseUtiaDecode("srgb140").value() == io::UtiaDecode::srgb140);
  CHECK_FALSE(io::parseUtiaDecode("sgrb").has_value());
}

TEST_CASE("measured BRDFs: what is wrong with a file is told") {
  const test::TemporaryFolder folder;
  const auto write = [&](const std::vector<uint8_t>& bytes) { return folder.write("a.binary", bytes).string(); };
  std::vector<uint8_t> bytes = merlBytesOf(180, 1);
  bytes.pop_back();
  CHECK(holds(problemOf(write(bytes)), "a.binary: has 34992011 bytes, but its dimensions need 34992012"));
  bytes.resize(12);
  CHECK(holds(problemOf(write(bytes)), "it is cut off"));
  bytes = merlBytesOf(180, 1);
  bytes[0] = 91;
  CHECK(holds(problemOf(write(bytes)), "the dimensions 91 x 90 x 180 are not 90 x 90 x 180"));
  CHECK(holds(problemOf(write(merlBytesOf(180, notANumber))), "holds no valid value: of its cells 1458000 are NaN"));
  CHECK(holds(problemOf(write(merlBytesOf(180, -1))), "0 infinite, 0 too large, 1458000 negative"));
  CHECK(holds(problemOf(write({})), "is empty"));
  CHECK(holds(problemOf(write({0x89, 'P', 'N', 'G', 13, 10, 26, 10, 0, 0, 0, 13})), "is a PNG picture"));
  CHECK(holds(problemOf(write({1, 2, 3})), "no measured BRDF that facet reads: 3 bytes"));
  CHECK(holds(problemOf(write(std::vector<uint8_t>(io::largestMerl + 1))), "more than the limit"));
  CHECK(holds(problemOf(folder.path().string()), "is a folder"));
  CHECK(holds(problemOf(folder.file("none.binary")), "no such file"));
  REQUIRE(mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  CHECK(holds(problemOf(folder.file("pipe")), "is not a regular file"));
  CHECK(holds(problemOf("builtin:ggx-0.6"), "there is no such built-in BRDF"));
}

TEST_CASE("measured BRDFs: holes of a file are filled and told, or the file is refused") {
  const test::TemporaryFolder folder;
  // UTIA, Lambert of albedo 0.3, theta of L at 75 degrees not measured.
  std::vector<uint8_t> utia(io::utiaBytes);
  const size_t cells = size_t{288} * 288;
  for (size_t i = 0; i < 3 * cells; ++i) {
    const bool ring = i % cells / 288 / 48 == 5;
    put(utia, 8 * i, ring ? notANumber : 0.3 / 3.14159265358979);
  }
  const auto matte = io::readMeasured(folder.write("matte.bin", utia).string());
  REQUIRE(matte.has_value());
  CHECK(matte->counts.notANumber == 48 * 288);
  for (const glm::vec3& value : matte->values) REQUIRE(value.y == Approx(0.3 / 3.14159265358979).epsilon(1e-5));
  const Notes notes = io::measuredNotes(*matte);
  REQUIRE(notes.size() == 2);
  CHECK(notes[0].text == "13824 of 82944 cells hold NaN and count as missing");
  CHECK(notes[1].severity == Note::Severity::warning);
  CHECK(
      notes[1].text ==
      "13824 cells above the horizon hold no value and are filled (11520 with V and L exchanged, 2304 like the nearest "
      "ones): 15 % of the light that it reflects is guessed");
  // Both rings of both directions: nothing measured is near enough.
  for (size_t i = 0; i < 3 * cells; ++i)
    if (i % cells / 288 / 48 > 1 || i % 288 / 48 > 1) put(utia, 8 * i, infinity);
  CHECK(holds(problemOf(folder.write("dark.bin", utia).string()),
              "cells hold no value, are above the horizon and have no neighbours to fill them from"));
}

TEST_CASE("measured BRDFs: found in folders by content, and by name") {
  const test::TemporaryFolder folder;
  const std::vector<uint8_t> merl = merlBytesOf(180, 100);
  folder.write("deep/one.binary", merl);
  folder.write("two.bin", std::vector<uint8_t>(io::utiaBytes));
  folder.write("three.txt", std::string("no database"));
  folder.write("four.binary", std::vector<uint8_t>(merl.size()));  // its size, but not its dimensions
  const auto found = io::findMeasured(folder.path());
  REQUIRE(found.size() == 2);
  CHECK(found[0].name == "one");
  CHECK(found[0].kind == MeasuredKind::merl);
  CHECK(found[1].name == "two");
  CHECK(found[1].kind == MeasuredKind::utia);
  CHECK(io::findMeasured(folder.path() / "nowhere").empty());
  CHECK(io::brdfFolders(folder.path()).front() == folder.path());
  CHECK(io::resolveMeasured("one", folder.path()).value() == found[0].path.string());
  CHECK(io::resolveMeasured("builtin:lambert", {}).value() == "builtin:lambert");
  CHECK(holds(describe(io::resolveMeasured("oen", folder.path()).error()), "perhaps one is meant"));
  const auto brdf = io::readMeasured(found[0].path.string());
  REQUIRE(brdf.has_value());
  CHECK(brdf->name == "one");
}
