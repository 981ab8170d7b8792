#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "support/gltf_builder.hpp"
#include "support/gltf_load.hpp"
#include "support/ktx2_builder.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;
using test::Ktx2File;

Bytes numbers(size_t count, int step = 7) {
  Bytes out(count);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<uint8_t>(3 + static_cast<size_t>(step) * i);
  return out;
}

std::string problemOf(const Ktx2File& file) {
  const auto pixels = io::decodeImage(file.bytes(), "i");
  return pixels ? "decoded" : describe(pixels.error());
}

Ktx2File plain(uint32_t vkFormat, uint32_t width, uint32_t height, Bytes level) {
  Ktx2File file;
  file.vkFormat = vkFormat;
  file.width = width;
  file.height = height;
  file.levels = {std::move(level)};
  return file;
}

}  // namespace

TEST_CASE("KTX2 with plain texels", "[io][image][ktx2]") {
  struct Row {
    uint32_t vkFormat;
    int channels, sample;
    Bytes stored, shown;  // 1 x 2 texels
  };
  const Row rows[] = {{9, 3, 1, {10, 20}, {10, 0, 0, 20, 0, 0}},
                      {15, 3, 1, {10, 20}, {10, 0, 0, 20, 0, 0}},
                      {16, 3, 1, {1, 2, 3, 4}, {1, 2, 0, 3, 4, 0}},
                      {23, 3, 1, {1, 2, 3, 4, 5, 6}, {1, 2, 3, 4, 5, 6}},
                      {30, 3, 1, {1, 2, 3, 4, 5, 6}, {3, 2, 1, 6, 5, 4}},
                      {43, 4, 1, {1, 2, 3, 4, 5, 6, 7, 8}, {1, 2, 3, 4, 5, 6, 7, 8}},
                      {44, 4, 1, {1, 2, 3, 4, 5, 6, 7, 8}, {3, 2, 1, 4, 7, 6, 5, 8}},
                      {70, 3, 2, {1, 2, 3, 4}, {1, 2, 0, 0, 0, 0, 3, 4, 0, 0, 0, 0}},
                      {91, 4, 2, numbers(16), numbers(16)}};
  for (const Row& row : rows) {
    INFO(row.vkFormat);
    const auto pixels = io::decodeImage(plain(row.vkFormat, 1, 2, row.stored).bytes(), "i");
    REQUIRE(pixels);
    CHECK(pixels->width == 1);
    CHECK(pixels->height == 2);
    CHECK(pixels->channels == row.channels);
    CHECK(pixels->bytesPerSample == row.sample);
    CHECK(pixels->data == row.shown);
    CHECK(pixels->remarks.empty());
    const bool srgb = row.vkFormat == 15 || row.vkFormat == 43;
    CHECK(pixels->transfer == (srgb ? io::Pixels::Transfer::srgb : io::Pixels::Transfer::linear));
  }
}

TEST_CASE("Mip levels of KTX2, with each supercompression", "[io][image][ktx2]") {
  const std::vector<Bytes> levels = {numbers(5 * 3 * 4), numbers(2 * 1 * 4, 11), numbers(4, 13)};
  for (const uint32_t scheme : {0u, 2u, 3u}) {
    INFO(scheme);
    Ktx2File file;
    file.width = 5;
    file.height = 3;
    file.scheme = scheme;
    for (const Bytes& level : levels) {
      file.levels.push_back(scheme == 2 ? test::zstandard(level) : scheme == 3 ? test::zlibDeflated(level) : level);
      file.uncompressed.push_back(level.size());
    }
    auto pixels = io::decodeImage(file.bytes(), "i");
    REQUIRE(pixels);
    CHECK(pixels->data == levels[0]);
    CHECK(pixels->levels == std::vector<Bytes>{levels[1], levels[2]});
    // Level 0 alone, or a smaller one that cannot be read: what is there is shown.
    file.levelCount = 1;
    pixels = io::decodeImage(file.bytes(), "i");
    REQUIRE(pixels);
    CHECK(pixels->data == levels[0]);
    CHECK(pixels->levels.empty());
    file.levelCount = -1;
    file.levels[2] = {1, 2, 3};
    file.uncompressed[2] = scheme == 0 ? 3 : 4;
    CHECK(problemOf(file) == "i: the image is damaged: its mip level 2 cannot be read; save it again.");
    Notes notes;
    scene::Model model;
    model.images.push_back({.name = "a", .file = {}, .encoded = file.bytes(), .problem = {}});
    const auto images = io::decodeImages(model, {true}, notes);
    CHECK(images[0].data == levels[0]);
    CHECK(images[0].levels == std::vector<Bytes>{levels[1]});
    REQUIRE(notes.size() == 1);
    CHECK(notes[0].text ==
          "the image \"a\" is damaged, and a part of it may look wrong: its mip level 2 cannot be read");
    // Of level 0 itself.
    file.levels = {scheme == 0 ? Bytes{1, 2} : Bytes{1, 2, 3, 4}};
    file.uncompressed = {60};
    CHECK(problemOf(file).starts_with(scheme == 0   ? "i: the image is damaged: it is too short"
                                      : scheme == 2 ? "i: the image is damaged: its Zstandard data: "
                                                    : "i: the image is damaged: its ZLIB data is faulty or too short"));
    file.levels = {scheme == 2 ? test::zstandard(levels[0]) : test::zlibDeflated(levels[0])};
    file.uncompressed = {61};
    if (scheme != 0)
      CHECK(problemOf(file) == "i: the image is damaged: its level's length is not that of its size; save it again.");
  }
}

TEST_CASE("KTXswizzle says where channels come from", "[io][image][ktx2]") {
  const auto shown = [](uint32_t vkFormat, Bytes texel, const std::string& swizzle) {
    Ktx2File file = plain(vkFormat, 1, 1, std::move(texel));
    file.keyValues = {{"KTXorientation", "rd"}, {"KTXswizzle", swizzle}, {"KTXwriter", "a test"}};
    const auto pixels = io::decodeImage(file.bytes(), "i");
    REQUIRE(pixels);
    CHECK(pixels->remarks.empty());
    return pixels->data;
  };
  CHECK(shown(37, {1, 2, 3, 4}, "rgba") == Bytes{1, 2, 3, 4});
  CHECK(shown(37, {1, 2, 3, 4}, "abgr") == Bytes{4, 3, 2, 1});
  CHECK(shown(37, {1, 2, 3, 4}, "g01a") == Bytes{2, 0, 255, 4});
  CHECK(shown(37, {1, 2, 3, 4}, "rrr1") == Bytes{1, 1, 1});
  CHECK(shown(9, {9}, "rrr1") == Bytes{9, 9, 9});
  CHECK(shown(16, {9, 5}, "rrrg") == Bytes{9, 9, 9, 5});
  CHECK(shown(23, {1, 2, 3}, "bgra") == Bytes{3, 2, 1});
  CHECK(shown(70, {1, 2}, "rrrr") == Bytes{1, 2, 1, 2, 1, 2, 1, 2});
}

TEST_CASE("What a KTX2 file says besides its texels is told", "[io][image][ktx2]") {
  const auto remarks = [](const Ktx2File& file) {
    const auto pixels = io::decodeImage(file.bytes(), "i");
    REQUIRE(pixels);
    std::string out;
    for (const std::string& remark : pixels->remarks) out += remark + "\n";
    return out;
  };
  Ktx2File file = plain(37, 1, 1, {1, 2, 3, 4});
  CHECK(remarks(file) == "");
  file.flags = 1;
  CHECK(remarks(file) == "its colours are multiplied by alpha, and are shown as if they were not\n");
  file.flags = 0;
  file.keyValues = {{"KTXorientation", "ru"}, {"KTXswizzle", "xyzw"}};
  CHECK(remarks(file) ==
        "its KTXorientation is not rd: its first row is shown at the top all the same\n"
        "its KTXswizzle is none: it is shown without\n");
  file.keyValues = {};
  file.primaries = 4;
  CHECK(remarks(file) == "its colours' primaries are not those of Rec. 709, and are shown as if they were\n");
}

TEST_CASE("KTX2 textures that are not shown say why", "[io][image][ktx2]") {
  const Ktx2File good = plain(37, 2, 2, numbers(16));
  CHECK(problemOf(good) == "decoded");
  const auto with = [&](auto change) {
    Ktx2File file = good;
    change(file);
    return problemOf(file);
  };
  const std::string plain2D = ", and only plain 2D textures are shown; save a 2D texture.";
  CHECK(with([](Ktx2File& f) { f.height = 0; }) == "i: is a 1D KTX2 texture" + plain2D);
  CHECK(with([](Ktx2File& f) { f.depth = 2; }) == "i: is a 3D KTX2 texture" + plain2D);
  CHECK(with([](Ktx2File& f) { f.layers = 3; }) == "i: is an array of 3 KTX2 textures" + plain2D);
  CHECK(with([](Ktx2File& f) { f.faces = 6; }) == "i: is a KTX2 texture of 6 faces" + plain2D);
  CHECK(with([](Ktx2File& f) { f.vkFormat = 97; }) ==
        "i: is a KTX2 texture of VkFormat 97, which is not read; convert it to UASTC, ETC1S or PNG.");
  CHECK(with([](Ktx2File& f) { f.scheme = 9; }) ==
        "i: is a KTX2 texture with supercompression 9, which is not known; save it with Zstandard or none.");
  const std::string damaged = "i: the KTX2 file is damaged: ", again = "; save it again.";
  CHECK(with([](Ktx2File& f) { f.width = 0; }) == damaged + "its width is 0" + again);
  CHECK(with([](Ktx2File& f) { f.levelCount = 3; }) == damaged + "it has 3 mip levels, and 2 is the most" + again);
  CHECK(with([](Ktx2File& f) { f.width = 0x80000001u; }) == damaged + "it has 2147483649 x 2 texels" + again);
  CHECK(with([](Ktx2File& f) { f.width = f.height = 20000; }) ==
        "i: the image has 20000 x 20000 pixels, more than the limit of 268435456; use a smaller image.");
  const auto patched = [&](size_t at, uint8_t value) {
    Bytes bytes = good.bytes();
    bytes[at] = value;
    const auto pixels = io::decodeImage(bytes, "i");
    return pixels ? "decoded" : describe(pixels.error());
  };
  CHECK(patched(80 + 3, 1) == damaged + "level 0 lies outside the file" + again);
  CHECK(patched(80 + 15, 255) == damaged + "level 0 lies outside the file" + again);
  CHECK(patched(80 + 8, 0) == damaged + "level 0 is empty" + again);
  CHECK(patched(48 + 3, 1) == damaged + "the data format descriptor lies outside the file" + again);
  CHECK(patched(104 + 4, 1) == damaged + "its data format descriptor is none" + again);
  CHECK(patched(64 + 7, 1) == damaged + "its global data lies outside the file" + again);
}

TEST_CASE("Zstandard and ZLIB of very many texels in next to no bytes are refused by the header", "[io][image][ktx2]") {
  for (const uint32_t scheme : {2u, 3u}) {
    Ktx2File file = plain(37, 16384, 16384, Bytes(100));
    file.scheme = scheme;
    file.uncompressed = {uint64_t{1} << 30};
    CHECK(problemOf(file) == "i: the file is too short for 16384 x 16384 pixels; save it again.");
  }
}

TEST_CASE("Textures of KHR_texture_basisu show it, else their other image", "[io][gltf][ktx2]") {
  const Bytes red = {255, 0, 0, 255}, green = {0, 255, 0};
  Ktx2File good = plain(43, 1, 1, red);
  good.transfer = 2;
  const Bytes png = test::pngBytes(1, 1, 3, 8, green);
  const auto shown = [&](const Bytes& ktx2, const Bytes& other, std::string& said) {
    test::GltfBuilder b;
    b.append("images", {{"uri", test::dataUri(other, "image/png")}, {"name", "other"}});
    b.append("images", {{"uri", test::dataUri(ktx2, "image/ktx2")}, {"name", "ktx"}});
    b.append("textures", {{"source", 0}, {"extensions", {{"KHR_texture_basisu", {{"source", 1}}}}}});
    b.append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    auto model = test::loaded(b);
    CHECK(model.model.textures[0].image == 1);
    Notes notes;
    const auto pixels = io::decodeImages(model.model, {false, true}, notes);
    said.clear();
    for (const Note& note : notes) said += note.place + ": " + note.text + "\n";
    return pixels[1].data;
  };
  std::string said;
  CHECK(shown(good.bytes(), png, said) == red);
  CHECK(said == "");
  Bytes cut = good.bytes();
  cut.resize(90);
  CHECK(shown(cut, png, said) == green);
  CHECK(
      said ==
      "/images/1: the image \"ktx\" cannot be shown: the KTX2 file is damaged: it ends within its index; \"other\" is "
      "shown in its place\n");
  CHECK(shown({1}, {2}, said) == io::placeholderImage().data);
  CHECK(said ==
        "/images/1: the image \"ktx\" cannot be shown: is no PNG, JPEG, WebP, AVIF or KTX2 image, nor \"other\" in its "
        "place: "
        "is no PNG, JPEG, WebP, AVIF or KTX2 image; a placeholder takes its place\n");
  good.transfer = 1;
  good.vkFormat = 37;
  CHECK(shown(good.bytes(), png, said) == red);
  CHECK(said == "/images/1: the image \"ktx\" says that it is linear, and is read as sRGB by baseColorTexture\n");
}
