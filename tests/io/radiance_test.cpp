#include "io/radiance.hpp"

#include <ImfChannelList.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "io/exr.hpp"
#include "io/sources.hpp"
#include "support/gltf_builder.hpp"
#include "support/skip.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;

std::string outcome(const Result<io::RadianceImage>& result) {
  return result ? std::string("read") : describe(result.error());
}

struct Files {
  test::TemporaryFolder folder;
  std::string path = (folder.path() / "f").string();

  Result<io::RadianceImage> read(const std::string& header, const Bytes& data, const io::Limits& limits = {}) const {
    Bytes bytes(header.begin(), header.end());
    bytes.insert(bytes.end(), data.begin(), data.end());
    return io::readRadiance(folder.write("f", bytes), limits);
  }
};

const std::string magic = "#?RADIANCE\n", format = "FORMAT=32-bit_rle_rgbe\n";

std::string header(int width, int height) {
  return magic + format + "\n-Y " + std::to_string(height) + " +X " + std::to_string(width) + "\n";
}

Bytes bytesOf(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

// A float image through the OpenEXR library with these channels, all holding channelIndex + 10 x + 100 y.
void writeChannels(const std::string& path, const std::vector<std::string>& names, Imath::Box2i data,
                   Imath::Box2i display, Imf::PixelType type = Imf::FLOAT,
                   Imf::Compression compression = Imf::ZIP_COMPRESSION) {
  Imf::Header header(display, data);
  header.compression() = compression;
  const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
  std::vector<std::vector<float>> values(names.size());
  std::vector<std::vector<Imath::half>> halves(names.size());
  Imf::FrameBuffer buffer;
  for (size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(type));
    for (int y = data.min.y; y <= data.max.y; ++y) {
      for (int x = data.min.x; x <= data.max.x; ++x)
        values[c].push_back(static_cast<float>(c) + static_cast<float>(10 * x + 100 * y));
    }
    halves[c].assign(values[c].begin(), values[c].end());
    void* from = type == Imf::FLOAT ? static_cast<void*>(values[c].data()) : halves[c].data();
    const size_t size = type == Imf::FLOAT ? 4 : 2;
    buffer.insert(names[c], Imf::Slice::Make(type, from, data, size, size * static_cast<size_t>(width)));
  }
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(buffer);
  file.writePixels(height);
}

Imath::Box2i box(int left, int top, int right, int bottom) { return {{left, top}, {right, bottom}}; }

}  // namespace

TEST_CASE("RGBE values", "[io][radiance]") {
  const Files files;
  // Uncompressed pixels (fewer than 8 a row): mantissa times 2^(e - 136)
  const auto image = files.read(header(4, 1), {128, 64, 0, 129, 1, 2, 3, 0, 255, 128, 1, 255, 200, 100, 50, 1});
  REQUIRE(image);
  CHECK(image->width == 4);
  CHECK(image->height == 1);
  CHECK(image->pixels[0] == glm::vec4(1, 0.5f, 0, 1));
  CHECK(image->pixels[1] == glm::vec4(0, 0, 0, 1));  // exponent 0 is black, whatever the mantissas
  CHECK(image->pixels[2] == glm::vec4(std::ldexp(255.0f, 119), std::ldexp(128.0f, 119), std::ldexp(1.0f, 119), 1));
  CHECK(image->pixels[3].x == std::ldexp(200.0f, -135));
}

TEST_CASE("EXPOSURE is divided out", "[io][radiance]") {
  const Files files;
  const Bytes pixel = {128, 128, 128, 129};
  const auto value = [&](const std::string& lines) {
    const auto image = files.read(magic + format + lines + "\n-Y 1 +X 1\n", pixel);
    REQUIRE(image);
    return image->pixels[0].x;
  };
  CHECK(value("") == 1);
  CHECK(value("EXPOSURE=2\n") == 0.5f);
  CHECK(value("EXPOSURE= 4.0 \r\nSOFTWARE=x\nEXPOSURE=0.5\n") == 0.5f);
}

TEST_CASE("Scan lines, new and old run lengths", "[io][radiance]") {
  const Files files;
  SECTION("new: runs and literals per channel, several rows") {
    // 10 pixels: R is 5 x 7 then 1..5; G 10 x 9; B 10 literals; E 10 x 136
    const Bytes row = {2, 2, 0, 10, 133, 7, 5, 1, 2, 3, 4, 5, 138, 9, 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 138, 136};
    Bytes data = row;
    data.insert(data.end(), row.begin(), row.end());
    const auto image = files.read(header(10, 2), data);
    REQUIRE(outcome(image) == "read");
    for (const size_t y : {0u, 10u}) {
      CHECK(image->pixels[y] == glm::vec4(7, 9, 0, 1));
      CHECK(image->pixels[y + 4] == glm::vec4(7, 9, 4, 1));
      CHECK(image->pixels[y + 5] == glm::vec4(1, 9, 5, 1));
      CHECK(image->pixels[y + 9] == glm::vec4(5, 9, 9, 1));
    }
  }
  SECTION("old: repeat counts in digits of 8 bits") {
    // one pixel, 3 repeats, then 260 = 4 + 256 repeats
    const Bytes data = {9, 8, 7, 136, 1, 1, 1, 3, 4, 5, 6, 136, 1, 1, 1, 4, 1, 1, 1, 1};
    const auto image = files.read(header(1 + 3 + 1 + 260, 1), data);
    REQUIRE(outcome(image) == "read");
    CHECK(image->pixels[3] == glm::vec4(9, 8, 7, 1));
    CHECK(image->pixels[4] == glm::vec4(4, 5, 6, 1));
    CHECK(image->pixels[264] == glm::vec4(4, 5, 6, 1));
  }
  SECTION("flat, although wide") {
    Bytes data;
    for (uint8_t i = 0; i < 9; ++i) data.insert(data.end(), {i, 0, 0, 136});
    const auto image = files.read(header(9, 1), data);
    REQUIRE(outcome(image) == "read");
    CHECK(image->pixels[8] == glm::vec4(8, 0, 0, 1));
  }
}

TEST_CASE("Radiance files that are refused say why", "[io][radiance]") {
  const Files files;
  const Bytes pixel = {1, 1, 2, 129};
  const auto message = [&](const std::string& text, const Bytes& data) { return outcome(files.read(text, data)); };
  const std::string f = files.path + ": ", convert = "; convert it to OpenEXR or to an ordinary .hdr.",
                    again = "; copy or download it again.";
  CHECK(message(header(1, 1), pixel) == "read");
  CHECK(message("#?RGBE\n" + format + "\n-Y 1 +X 1\n", pixel) == "read");
  CHECK(message("", {}) ==
        f + "is neither a Radiance (.hdr) nor an OpenEXR (.exr) picture; convert it to one of them.");
  CHECK(message("P6\n", pixel) ==
        f + "is neither a Radiance (.hdr) nor an OpenEXR (.exr) picture; convert it to one of them.");
  CHECK(message(magic + format, {}) == f + "byte 34: the file ends within its header" + again);
  CHECK(message(magic + "FORMAT=32-bit_rle_luv\n\n-Y 1 +X 1\n", pixel) ==
        f + "byte 11: the pixel format \"32-bit_rle_luv\" is neither 32-bit_rle_rgbe nor 32-bit_rle_xyze" + convert);
  CHECK(message(magic + "COLORCORR=1 0 1\n\n-Y 1 +X 1\n", pixel) ==
        f + "byte 11: \"COLORCORR=1 0 1\" is not three positive numbers" + convert);
  CHECK(message(magic + "PRIMARIES=.64 .33 .3 .6 .15 .06 .3127\n\n-Y 1 +X 1\n", pixel) ==
        f + "byte 11: \"PRIMARIES=.64 .33 .3 .6 .15 .06 .3127\" is not eight numbers" + convert);
  CHECK(message(magic + "EXPOSURE=0\n\n-Y 1 +X 1\n", pixel) ==
        f + "byte 11: \"EXPOSURE=0\" is not a positive number" + convert);
  CHECK(message(magic + "EXPOSURE=nan\n\n-Y 1 +X 1\n", pixel) ==
        f + "byte 11: \"EXPOSURE=nan\" is not a positive number" + convert);
  for (const std::string size : {"-Y 1", "-Y 1 -Y 1", "+X 1 X 1", "1 1", ""}) {
    CHECK(message(magic + "\n" + size + "\n", pixel) ==
          f + "byte 12: the resolution line \"" + size + "\" is not of the form \"-Y height +X width\"" + convert);
  }
  for (const std::string size : {"-Y -5 +X 1", "-Y 0 +X 1", "-Y 1 +X 99999999999", "-Y x +X 1"}) {
    CHECK(message(magic + "\n" + size + "\n", pixel) ==
          f + "byte 12: the resolution line \"" + size + "\" holds no positive size" + convert);
  }
  CHECK(message(magic + "\n-Y 100000 +X 100000\n", pixel) ==
        f + "the picture has 100000 x 100000 pixels, more than the limit of 134217728; use a smaller picture.");
  CHECK(message(magic + "\n-Y 8192 +X 16384\n", pixel) == f + "byte 29: the file is cut off" + again);
  CHECK(message(header(2, 1), pixel) == f + "byte 45: row 0 is damaged or cut off" + again);
  // The second row begins with a repetition: of nothing.
  CHECK(message(header(1, 2), {1, 2, 3, 129, 1, 1, 1, 1}) == f + "byte 49: row 1 is damaged or cut off" + again);
  const auto row = [&](const Bytes& codes) {
    Bytes data = {2, 2, 0, 8};
    data.insert(data.end(), codes.begin(), codes.end());
    return message(header(8, 1), data);
  };
  CHECK(row({136, 1, 136, 1, 136, 1, 136, 129}) == "read");
  CHECK(row({137, 1, 136, 1, 136, 1, 136, 129}) == f + "byte 45: row 0 is damaged or cut off" + again);  // over the end
  CHECK(row({0, 0, 0, 0}) == f + "byte 45: row 0 is damaged or cut off" + again);                        // stands still
  CHECK(row({136, 1, 8, 1, 2}) == f + "byte 45: row 0 is damaged or cut off" + again);
  CHECK(row({136}) == f + "byte 45: row 0 is damaged or cut off" + again);
}

TEST_CASE("Radiance pictures are turned and mirrored as they say", "[io][radiance]") {
  // 1 2 3 / 4 5 6 seen upright, by the order in which the file has them.
  const std::pair<std::string, std::string> forms[] = {
      {"-Y 2 +X 3", "123456"}, {"-Y 2 -X 3", "321654"}, {"+Y 2 +X 3", "456123"}, {"+Y 2 -X 3", "654321"},
      {"+X 3 -Y 2", "142536"}, {"+X 3 +Y 2", "415263"}, {"-X 3 -Y 2", "362514"}, {"-X 3 +Y 2", "635241"}};
  const Files files;
  for (const auto& [size, order] : forms) {
    INFO(size);
    Bytes data;
    for (const char c : order) data.insert(data.end(), {static_cast<uint8_t>(c - '0'), 0, 0, 136});
    const auto image = files.read(magic + "EXPOSURE=\t+1 \n\n" + size + "\n", data);
    REQUIRE(outcome(image) == "read");
    CHECK(image->width == 3);
    CHECK(image->height == 2);
    for (size_t i = 0; i < 6; ++i) CHECK(image->pixels[i].x == float(i + 1));
  }
}

TEST_CASE("EXR written and read again, bit for bit", "[io][radiance]") {
  const test::TemporaryFolder folder;
  const auto path = folder.path() / "a.exr";
  io::RadianceImage image;
  image.width = 5;
  image.height = 3;
  for (int i = 0; i < 15; ++i) {
    const float v = static_cast<float>(i);
    image.pixels.push_back(glm::vec4(v / 3, -v * 1e30f, std::ldexp(1.0f, -140 + i), v / 15));
  }
  image.pixels[7] = glm::vec4(std::numeric_limits<float>::infinity(), std::nanf(""), 0, 1);
  REQUIRE(io::writeExr(path, image));
  const auto read = io::readRadiance(path);
  REQUIRE(outcome(read) == "read");
  CHECK(read->width == 5);
  CHECK(read->height == 3);
  REQUIRE(read->pixels.size() == image.pixels.size());
  CHECK(std::memcmp(read->pixels.data(), image.pixels.data(), sizeof(glm::vec4) * 15) == 0);
  const auto failed = io::writeExr(folder.path() / "none/a.exr", image);
  REQUIRE_FALSE(failed);
  CHECK(failed.error().file == (folder.path() / "none/a.exr").string());
  CHECK(failed.error().remedy == "check the folder, its permissions and the space left");
}

TEST_CASE("EXR windows: the data window lies somewhere in the display window", "[io][radiance]") {
  const Files files;
  // Data from (-3, -2) to (2, 1), shown from (-1, -4) to (4, 0)
  writeChannels(files.path, {"B", "G", "R"}, box(-3, -2, 2, 1), box(-1, -4, 4, 0));
  const auto image = io::readRadiance(files.path);
  REQUIRE(outcome(image) == "read");
  REQUIRE(image->width == 6);
  REQUIRE(image->height == 5);
  const auto at = [&](int x, int y) { return image->pixels[static_cast<size_t>((y + 4) * 6 + x + 1)]; };
  CHECK(at(-1, -4) == glm::vec4(0));
  CHECK(at(-1, -2) == glm::vec4(-208, -209, -210, 1));
  CHECK(at(2, 0) == glm::vec4(22, 21, 20, 1));
  CHECK(at(3, 0) == glm::vec4(0));
  writeChannels(files.path, {"B", "G", "R"}, box(10, 10, 11, 11), box(0, 0, 3, 3));
  const auto apart = io::readRadiance(files.path);
  REQUIRE(outcome(apart) == "read");
  CHECK(apart->pixels == std::vector<glm::vec4>(16, glm::vec4(0)));
}

TEST_CASE("EXR channels", "[io][radiance]") {
  const Files files;
  const auto first = [&](const std::vector<std::string>& names, Imf::PixelType type = Imf::FLOAT,
                         Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    writeChannels(files.path, names, box(0, 0, 1, 0), box(0, 0, 1, 0), type, compression);
    const auto image = io::readRadiance(files.path);
    REQUIRE(outcome(image) == "read");
    return image->pixels[1];
  };
  CHECK(first({"R", "G", "B", "A"}) == glm::vec4(10, 11, 12, 13));
  CHECK(first({"R", "G", "B"}) == glm::vec4(10, 11, 12, 1));
  CHECK(first({"Y"}) == glm::vec4(10, 10, 10, 1));
  CHECK(first({"Y", "A"}) == glm::vec4(10, 10, 10, 11));
  CHECK(first({"R", "G", "B", "depth.Z"}) == glm::vec4(10, 11, 12, 1));
  CHECK(first({"View.Combined.R", "View.Combined.G", "View.Combined.B", "View.Combined.A"}) ==
        glm::vec4(10, 11, 12, 13));
  CHECK(first({"R", "G", "B"}, Imf::HALF, Imf::PIZ_COMPRESSION) == glm::vec4(10, 11, 12, 1));
  CHECK(first({"R", "G", "B"}, Imf::HALF, Imf::NO_COMPRESSION) == glm::vec4(10, 11, 12, 1));
  const auto refused = [&](const std::vector<std::string>& names) {
    writeChannels(files.path, names, box(0, 0, 1, 0), box(0, 0, 1, 0));
    return outcome(io::readRadiance(files.path));
  };
  CHECK(refused({"Z"}) == files.path + ": there are no channels R, G, B or Y, but Z; convert it to RGB.");
  CHECK(refused({"R", "G"}) == files.path + ": there are no channels R, G, B or Y, but G, R; convert it to RGB.");
  CHECK(refused({"Y", "RY"}) == files.path + ": there are no channels R, G, B or Y, but RY, Y; convert it to RGB.");
}

TEST_CASE("EXR layers: the picture's own, or the one that is named", "[io][radiance]") {
  const Files files;
  const auto layersOf = [](const std::vector<std::string>& layers) {
    std::vector<std::string> names;
    for (const std::string& layer : layers)
      for (const char* channel : {"R", "G", "B"}) names.push_back(layer + channel);
    return names;
  };
  const auto read = [&](const std::vector<std::string>& layers, const std::string& wanted = {}) {
    writeChannels(files.path, layersOf(layers), box(0, 0, 0, 0), box(0, 0, 0, 0));
    return io::readRadiance(files.path, {}, wanted);
  };
  const auto red = [&](const std::vector<std::string>& layers, const std::string& wanted = {}) {
    const auto image = read(layers, wanted);
    REQUIRE(outcome(image) == "read");
    return image->pixels[0].x / 3;  // the layer's place in the list
  };
  CHECK(red({"View.AO.", "View.Combined.", "View.DiffCol."}) == 1);
  CHECK(red({"albedo.", "beauty."}) == 1);
  CHECK(red({"a.", "b.", ""}) == 2);
  CHECK(red({"Combined.", ""}) == 1);
  CHECK(red({"b.", "a."}) == 1);  // by name
  CHECK(red({"View.AO.", "View.Combined."}, "View.AO") == 0);
  CHECK(red({"View.AO.", "View.Combined."}, "AO") == 0);
  CHECK(outcome(read({"View.AO.", "View.Combined."}, "Depth")) ==
        files.path + ": there is no layer \"Depth\", but View.AO, View.Combined; name one of them.");
  const auto image = read({"View.AO.", "View.Combined.", "View.DiffCol."});
  REQUIRE(image->notes.size() == 1);
  CHECK(image->notes[0].text == "the layer \"View.Combined\" is taken; it also holds View.AO, View.DiffCol");
  CHECK(read({""})->notes.empty());
  CHECK(read({"x."})->notes.empty());
  const auto hdr = files.folder.write("a.hdr", magic + format + "\n-Y 1 +X 1\n" + std::string(4, 'a'));
  CHECK(outcome(io::readRadiance(hdr, {}, "x")) ==
        hdr.string() + ": a Radiance picture has no layers; leave the layer's name out.");
}

TEST_CASE("A Radiance picture of very many pixels in next to no bytes is refused before memory is taken",
          "[io][radiance]") {
  const Files files;
  // Each row a pixel and runs of it: 2^27 pixels in 2 KB.
  Bytes data;
  for (int row = 0; row < 128; ++row) data.insert(data.end(), {9, 9, 9, 128, 1, 1, 1, 255, 1, 1, 1, 255, 1, 1, 1, 15});
  CHECK(outcome(files.read(magic + format + "\n-Y 128 +X 1048576\n", data))
            .find("2048 bytes are too few for 1048576 x 128 pixels; copy or download it again.") != std::string::npos);
  const auto small = files.read(magic + format + "\n-Y 1 +X 464\n", {9, 9, 9, 128, 1, 1, 1, 207, 1, 1, 1, 1});
  REQUIRE(small);
  CHECK(small->pixels.back() == small->pixels.front());
}

TEST_CASE("An environment's layer is named behind its file, which may have such a name itself", "[io][radiance]") {
  const Files files;
  writeChannels(files.path,
                {"View.AO.R", "View.AO.G", "View.AO.B", "View.Combined.R", "View.Combined.G", "View.Combined.B"},
                box(0, 0, 1, 0), box(0, 0, 1, 0));
  Notes notes;
  const auto read = [&](const std::string& layer) {
    return io::loadEnvironmentSource(io::withLayer(files.path, layer), notes);
  };
  CHECK(read("AO")->radiance[0].x == 0);
  CHECK(read("View.Combined")->radiance[0].x == 3);
  CHECK(read("")->radiance[0].x == 3);
  CHECK(io::checkEnvironmentSource(io::withLayer(files.path, "AO")));
  const auto unknown = read("Depth");
  REQUIRE_FALSE(unknown);
  CHECK(describe(unknown.error()) ==
        files.path + ": there is no layer \"Depth\", but View.AO, View.Combined; name one of them.");
  CHECK(unknown.error().about == Setting::environmentLayer);
  const std::string odd = files.path + "#AO";
  std::filesystem::copy_file(files.path, odd);
  CHECK(io::splitLayer(odd).file == odd);
  CHECK(io::loadEnvironmentSource(odd, notes)->radiance[0].x == 3);
  CHECK(io::splitLayer(odd + "#AO").layer == "AO");
  CHECK(io::splitLayer("builtin:studio").file == "builtin:studio");
}

TEST_CASE("Every compression's largest pictures of one colour are read", "[io][radiance]") {
  // The fewest bytes that a picture can have: what is refused as too short must be shorter.
  const Files files;
  for (const auto compression : {Imf::NO_COMPRESSION, Imf::RLE_COMPRESSION, Imf::ZIPS_COMPRESSION, Imf::ZIP_COMPRESSION,
                                 Imf::PIZ_COMPRESSION, Imf::PXR24_COMPRESSION, Imf::B44_COMPRESSION,
                                 Imf::B44A_COMPRESSION, Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
    for (const Imf::PixelType type : {Imf::HALF, Imf::FLOAT}) {
      INFO(compression << " " << type);
      const int width = 1024, height = 512;
      Imf::Header header(width, height);
      header.compression() = compression;
      std::vector<Imath::half> halves(width * height, Imath::half(0.5f));
      std::vector<float> floats(width * height, 0.5f);
      char* from = type == Imf::HALF ? reinterpret_cast<char*>(halves.data()) : reinterpret_cast<char*>(floats.data());
      const size_t size = type == Imf::HALF ? 2 : 4;
      Imf::FrameBuffer buffer;
      for (const char* name : {"R", "G", "B"}) {
        header.channels().insert(name, Imf::Channel(type));
        buffer.insert(name, Imf::Slice(type, from, size, size * width));
      }
      {
        Imf::OutputFile file(files.path.c_str(), header);
        file.setFrameBuffer(buffer);
        file.writePixels(height);
      }
      const auto image = io::readRadiance(files.path);
      REQUIRE(outcome(image) == "read");
      CHECK(image->pixels[0].x == Approx(0.5).epsilon(0.01));
      CHECK(image->pixels.back() == image->pixels[0]);
    }
  }
}

TEST_CASE("An EXR of several parts is read", "[io][radiance]") {
  const Files files;
  const auto write = [&](const std::vector<std::string>& names) {
    std::vector<Imf::Header> headers;
    for (const std::string& name : names) {
      Imf::Header& header = headers.emplace_back(2, 1);
      header.setName(name);
      header.setType(Imf::SCANLINEIMAGE);
      for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    }
    Imf::MultiPartOutputFile file(files.path.c_str(), headers.data(), static_cast<int>(headers.size()));
    for (size_t p = 0; p < names.size(); ++p) {
      std::vector<float> values(2, static_cast<float>(p + 1));
      Imf::FrameBuffer buffer;
      for (const char* channel : {"R", "G", "B"})
        buffer.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 8));
      Imf::OutputPart part(file, static_cast<int>(p));
      part.setFrameBuffer(buffer);
      part.writePixels(1);
    }
  };
  write({"first", "second"});
  CHECK(io::readRadiance(files.path)->pixels[1] == glm::vec4(1, 1, 1, 1));
  CHECK(io::readRadiance(files.path, {}, "second")->pixels[1] == glm::vec4(2, 2, 2, 1));
  write({"albedo", "beauty"});
  const auto image = io::readRadiance(files.path);
  REQUIRE(outcome(image) == "read");
  CHECK(image->pixels[1] == glm::vec4(2, 2, 2, 1));
  REQUIRE(image->notes.size() == 1);
  CHECK(image->notes[0].text == "the layer \"beauty\" is taken; it also holds albedo");
}

TEST_CASE("An EXR of luminance and chroma is read", "[io][radiance]") {
  const Files files;
  const int width = 16, height = 8;
  std::vector<Imf::Rgba> colors(width * height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      colors[static_cast<size_t>(y * width + x)] = Imf::Rgba(0.5f + 0.01f * static_cast<float>(x), 0.25f, 0.75f, 1);
  {
    Imf::RgbaOutputFile file(files.path.c_str(), width, height, Imf::WRITE_YC);
    file.setFrameBuffer(colors.data(), 1, width);
    file.writePixels(height);
  }
  const auto image = io::readRadiance(files.path);
  REQUIRE(outcome(image) == "read");
  REQUIRE(image->pixels.size() == colors.size());
  for (size_t i = 0; i < colors.size(); ++i) {
    CHECK(image->pixels[i].x == Approx(float(colors[i].r)).margin(0.01));
    CHECK(image->pixels[i].y == Approx(0.25).margin(0.01));
    CHECK(image->pixels[i].z == Approx(0.75).margin(0.01));
  }
}

TEST_CASE("Colours of other primaries become Rec. 709, and that is said", "[io][radiance]") {
  const Files files;
  // 0.5, 0.25, 0.1 of Rec. 709 in Rec. 2020 (BT.2087).
  const glm::vec3 wide(0.400354f, 0.265570f, 0.119759f);
  const auto check = [](const Result<io::RadianceImage>& image, double margin, const std::string& said) {
    REQUIRE(outcome(image) == "read");
    const double wanted[] = {0.5, 0.25, 0.1};
    for (int c = 0; c < 3; ++c) CHECK(image->pixels[0][c] == Approx(wanted[c]).margin(margin));
    REQUIRE(image->notes.size() == (said.empty() ? 0u : 1u));
    if (!said.empty()) CHECK_THAT(image->notes[0].text, Catch::StartsWith(said));
  };
  {
    Imf::Header header(1, 1);
    Imf::addChromaticities(header, Imf::Chromaticities({0.708f, 0.292f}, {0.17f, 0.797f}, {0.131f, 0.046f}));
    Imf::FrameBuffer buffer;
    for (int c = 0; c < 3; ++c) {
      const std::string name(1, "RGB"[c]);
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(const_cast<float*>(&wide[c])), 4, 4));
    }
    Imf::OutputFile file(files.path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(1);
  }
  check(io::readRadiance(files.path), 2e-4, "converted to Rec. 709 from the primaries 0.708, 0.292; ");
  const auto hdr = [&](const std::string& lines, const Bytes& pixel) {
    return files.read(magic + lines + "\n-Y 1 +X 1\n", pixel);
  };
  const Bytes rec709 = {128, 64, 26, 128}, rec2020 = {205, 136, 61, 127}, xyz = {161, 150, 69, 127};
  check(hdr("PRIMARIES= .708 .292  .17 .797 .131 .046 .3127 .329\n", rec2020), 4e-3, "converted to Rec. 709 from");
  check(hdr("PRIMARIES=.64 .33 .3 .6 .15 .06 .3127 .329\n", rec709), 2e-3, "");
  check(hdr("FORMAT=32-bit_rle_xyze\n", xyz), 4e-3, "converted to Rec. 709 from CIE XYZ");
  check(hdr("COLORCORR=2 1 1\nCOLORCORR=1 1 0.5\n", {255, 64, 13, 128}), 4e-3, "the colour correction");
  const auto none = hdr("PRIMARIES=0 0 0 0 0 0 0 0\n", rec709);
  check(none, 2e-3, "the primaries 0, 0; 0, 0; 0, 0 and the white 0, 0 span no colours");
  CHECK(none->notes[0].severity == Note::Severity::warning);

  Notes notes;  // the environment's, with its name
  REQUIRE(hdr("FORMAT=32-bit_rle_xyze\n", xyz));
  REQUIRE(io::loadEnvironment(files.path, notes));
  REQUIRE(notes.size() == 2);
  CHECK(notes[0].place == "f");
  CHECK(notes[0].severity == Note::Severity::info);
}

TEST_CASE("Conversion leaves what is not finite", "[io][radiance]") {
  io::RadianceImage image{3, 1, {glm::vec4(INFINITY, 0, 0, 1), glm::vec4(NAN, 0, 0, 1), glm::vec4(1, 1, 1, 0.5f)}};
  io::toRec709(image, {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}});
  CHECK(image.pixels[0].x == INFINITY);
  CHECK(image.pixels[0].y == 0);
  CHECK(std::isnan(image.pixels[1].x));
  CHECK(image.pixels[2].y == Approx(1));
  CHECK(image.pixels[2].w == 0.5f);
}

TEST_CASE("A tiled EXR is read", "[io][radiance]") {
  const Files files;
  Imf::Header header(3, 2);
  header.setTileDescription(Imf::TileDescription(2, 2, Imf::ONE_LEVEL));
  std::vector<float> values = {1, 2, 3, 4, 5, 6};
  Imf::FrameBuffer buffer;
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 12));
  }
  {
    Imf::TiledOutputFile file(files.path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
  }
  const auto image = io::readRadiance(files.path);
  REQUIRE(outcome(image) == "read");
  CHECK(image->pixels[5] == glm::vec4(6, 6, 6, 1));
  // Tiles of two million rows, for which the library would have the memory.
  Bytes bytes = bytesOf(files.path);
  const std::string name("tiles\0tiledesc\0\x09\0\0\0", 19);
  const auto found = std::search(bytes.begin(), bytes.end(), name.begin(), name.end());
  REQUIRE(found != bytes.end());
  const uint32_t rows = 2'000'000;
  std::memcpy(&bytes[static_cast<size_t>(found - bytes.begin()) + name.size() + 4], &rows, sizeof rows);
  CHECK(describe(io::decodeExr(bytes, "tall.exr", {}).error()) ==
        "tall.exr: its tiles have 2 x 2000000 pixels, far more than the picture; copy or download it again.");
}

TEST_CASE("EXR files that are refused say why", "[io][radiance]") {
  const Files files;
  writeChannels(files.path, {"R", "G", "B"}, box(0, 0, 15, 15), box(0, 0, 15, 15));
  const Bytes good = bytesOf(files.path);
  const std::string f = files.path + ": ";
  const auto read = [&](const Bytes& bytes, const io::Limits& limits = {}) {
    return outcome(files.read("", bytes, limits));
  };
  CHECK(read(good) == "read");
  CHECK(read(Bytes(good.begin(), good.begin() + 6)) == f + "the file is cut off; copy or download it again.");
  CHECK(read(Bytes(good.begin(), good.begin() + 8)) == f + "the header has no data window; copy or download it again.");
  CHECK(read(Bytes(good.begin(), good.begin() + 40)) ==
        f + "byte 24: an attribute of 55 bytes does not fit into the file; copy or download it again.");
  Bytes greedy = good;  // the last attribute claims gigabytes
  const std::string last = "screenWindowWidth";
  const auto attribute = std::search(greedy.begin(), greedy.end(), last.begin(), last.end());
  REQUIRE(attribute != greedy.end());
  const auto size = attribute + 18 + 6;  // behind both names
  *(size + 3) = 0x7f;
  CHECK(read(greedy) ==
        f + "byte " + std::to_string(size - greedy.begin()) +
            ": an attribute of 2130706436 bytes does not fit into the file; copy or download it again.");
  // The library would read one byte of it and go on there, where no other size was checked.
  const std::string compression = std::string("compression\0compression\0", 24);
  Bytes longer = good;
  const auto byte = std::search(longer.begin(), longer.end(), compression.begin(), compression.end());
  REQUIRE(byte != longer.end());
  const auto longSize = byte + std::ssize(compression);
  *longSize = 9;
  CHECK(read(longer) == f + "byte " + std::to_string(longSize - longer.begin()) +
                            ": an attribute of type compression has 9 bytes; copy or download it again.");
  Bytes channels = good;  // of one, and the others behind its end
  const auto second = std::find(channels.begin() + 26, channels.end(), 'G');
  REQUIRE(second != channels.end());
  *second = 0;
  CHECK(read(channels) == f + "byte 24: an attribute of type chlist has 55 bytes; copy or download it again.");
  Bytes deep = good;
  deep[5] |= 0x08;
  CHECK(read(deep) == f + "byte 4: deep images are not supported; convert it to a single-part scan-line image.");
  // A huge data window in a small file
  const std::string name = std::string("dataWindow\0box2i\0\x10\0\0\0", 21);
  const auto found = std::search(good.begin(), good.end(), name.begin(), name.end());
  REQUIRE(found != good.end());
  const auto window = [&](int32_t left, int32_t top, int32_t right, int32_t bottom) {
    Bytes bytes = good;
    const int32_t values[] = {left, top, right, bottom};
    std::memcpy(&bytes[static_cast<size_t>(found - good.begin()) + name.size()], values, sizeof values);
    return read(bytes);
  };
  constexpr int32_t least = std::numeric_limits<int32_t>::min(), most = std::numeric_limits<int32_t>::max();
  CHECK(window(0, 0, 15, 15) == "read");
  CHECK(window(least, least, most, most) == f + "the data window has 4294967296 x 4294967296 pixels, more than the "
                                                "limit of 134217728; use a smaller picture.");
  CHECK(window(0, 0, 0, most) ==
        f + "the data window has 1 x 2147483648 pixels, more than the limit of 134217728; use a smaller picture.");
  CHECK(window(5, 5, 4, 5) == f + "the data window is empty; copy or download it again.");
  CHECK(window(0, 0, 8191, 8191) == f + "the file is too short for 8192 x 8192 pixels; copy or download it again.");
  CHECK(window(0, 0, 0, 99999) == f + "the file is too short for 1 x 100000 pixels; copy or download it again.");
  CHECK_THAT(window(0, 0, 15, 31), Catch::StartsWith(f + "the picture is damaged: "));
  io::Limits limits;
  limits.radiancePixels = 255;
  CHECK(read(good, limits) ==
        f + "the data window has 16 x 16 pixels, more than the limit of 255; use a smaller picture.");
}

TEST_CASE("A truncated or damaged EXR never crashes", "[io][radiance]") {
  const Files files;
  writeChannels(files.path, {"R", "G", "B"}, box(0, 0, 15, 15), box(0, 0, 15, 15));
  const Bytes good = bytesOf(files.path);
  for (size_t length = 0; length < good.size(); length += 3) {
    CHECK_FALSE(io::decodeExr(std::span(good).first(length), "e", {}));
  }
  uint32_t state = 3;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
  io::Limits limits;
  limits.radiancePixels = 1 << 16;
  for (int round = 0; round < 1000; ++round) {
    Bytes bytes = good;
    for (int change = 0; change < 1 + round % 3; ++change)
      bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
    const auto image = io::decodeExr(bytes, "e", limits);
    if (image) CHECK(image->pixels.size() == static_cast<size_t>(image->width) * static_cast<size_t>(image->height));
  }
}

TEST_CASE("An environment that is not 2:1 is accepted with a warning", "[io][radiance]") {
  const Files files;
  Notes notes;
  REQUIRE(files.read(header(1, 1), {128, 64, 32, 129}));
  const auto environment = io::loadEnvironment(files.path, notes);
  REQUIRE(environment);
  CHECK(environment->name == "f");
  CHECK(environment->radiance == std::vector<glm::vec3>{{1, 0.5f, 0.25f}});
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].text == "has 1 x 1 pixels and not twice as many across as down: stretched over the sphere");
  REQUIRE(files.read(header(2, 1), {128, 64, 32, 129, 0, 0, 0, 0}));
  notes.clear();
  REQUIRE(io::loadEnvironment(files.path, notes));
  CHECK(notes.empty());
}

TEST_CASE("Texels that are mended are counted in the notes", "[io][radiance]") {
  const test::TemporaryFolder folder;
  io::RadianceImage image;
  image.width = 4;
  image.height = 2;
  image.pixels.assign(8, glm::vec4(1));
  image.pixels[0] = glm::vec4(std::nanf(""), 1, 1, 1);
  image.pixels[3] = image.pixels[4] = glm::vec4(std::numeric_limits<float>::infinity(), 1, 1, 1);
  image.pixels[7] = glm::vec4(1, -2, 1, 1);
  REQUIRE(io::writeExr(folder.path() / "e.exr", image));
  Notes notes;
  const auto environment = io::loadEnvironment(folder.path() / "e.exr", notes);
  REQUIRE(environment);
  CHECK(environment->nanTexels == 1);
  CHECK(environment->infiniteTexels == 2);
  CHECK(environment->negativeTexels == 1);
  REQUIRE(notes.size() == 3);
  CHECK(notes[0].text == "1 texels are not numbers: replaced by their neighbours");
  CHECK(notes[1].text == "2 texels are infinite: replaced by the largest value");
  CHECK(notes[2].text == "1 texels are negative: replaced by zero");
}

TEST_CASE("The shared environments have the radiance that is written about them", "[io][radiance][shared]") {
  const std::string manifestPath = test::sharedFile("assets/manifest.json");
  if (manifestPath.empty()) return;
  std::ifstream stream(manifestPath);
  const auto manifest = nlohmann::json::parse(stream);
  for (const auto& entry : manifest.at("environments")) {
    INFO(entry.dump());
    const auto file = std::filesystem::path(manifestPath).parent_path() / entry.at("file").get<std::string>();
    const auto image = io::readRadiance(file);
    REQUIRE(outcome(image) == "read");
    REQUIRE(image->width == entry.at("width"));
    REQUIRE(image->height == entry.at("height"));
    double largest = 0, sum = 0, weights = 0;
    for (int y = 0; y < image->height; ++y) {
      const double weight = std::sin((y + 0.5) / image->height * 3.14159265358979);
      for (int x = 0; x < image->width; ++x) {
        const glm::dvec4 p(image->pixels[static_cast<size_t>(y * image->width + x)]);
        largest = std::max({largest, p.x, p.y, p.z});
        sum += weight * (0.2126 * p.x + 0.7152 * p.y + 0.0722 * p.z);
        weights += weight;
      }
    }
    CHECK(largest == Approx(entry.at("max_channel").get<double>()).epsilon(1e-5));
    CHECK(sum / weights == Approx(entry.at("mean_luminance").get<double>()).epsilon(1e-4));
  }
}
