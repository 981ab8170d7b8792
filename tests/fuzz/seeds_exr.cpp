// Small OpenEXR files through the library: every compression, tiles, luminance and chroma, several parts.

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>

#include <fstream>
#include <iterator>

#include "fuzz/seeds.hpp"
#include "support/temporary_folder.hpp"

namespace facet::fuzz {

namespace {

constexpr int width = 7, height = 5;

struct Channels {
  std::vector<std::string> names;
  std::vector<float> values = std::vector<float>(size_t{width} * height);

  void addTo(Imf::Header& header, Imf::FrameBuffer& buffer) {
    for (size_t i = 0; i < values.size(); ++i) values[i] = 0.25f * static_cast<float>(i);
    for (const std::string& name : names) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), 4, 4 * width));
    }
  }
};

Bytes contents(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

std::vector<Bytes> exrSeeds() {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("a.exr");
  std::vector<Bytes> out;
  for (int compression = 0; compression < Imf::NUM_COMPRESSION_METHODS; ++compression) {
    Imf::Header header(width, height);
    header.compression() = static_cast<Imf::Compression>(compression);
    Channels channels{{"R", "G", "B", "A"}};
    Imf::FrameBuffer buffer;
    channels.addTo(header, buffer);
    {
      Imf::OutputFile file(path.c_str(), header);
      file.setFrameBuffer(buffer);
      file.writePixels(height);
    }
    out.push_back(contents(path));
  }
  for (const auto mode : {Imf::ONE_LEVEL, Imf::MIPMAP_LEVELS}) {
    Imf::Header header(width, height);
    header.setTileDescription({4, 4, mode});
    Imf::addChromaticities(header, {{0.7f, 0.3f}, {0.2f, 0.8f}, {0.1f, 0.1f}, {0.3f, 0.3f}});
    Channels channels{{"Y", "A"}};
    Imf::FrameBuffer buffer;
    channels.addTo(header, buffer);
    {
      Imf::TiledOutputFile file(path.c_str(), header);
      for (int level = 0; level < file.numLevels(); ++level) {
        file.setFrameBuffer(buffer);
        file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
      }
    }
    out.push_back(contents(path));
  }
  std::vector<Imf::Header> headers(2, Imf::Header({{-2, -1}, {9, 8}}, {{0, 0}, {width - 1, height - 1}}));
  std::vector<Channels> channels{{{"one.R", "one.G", "one.B"}}, {{"RY", "BY", "Y"}}};
  std::vector<Imf::FrameBuffer> buffers(2);
  for (size_t i = 0; i < 2; ++i) {
    headers[i].setName(i == 0 ? "first" : "second");
    headers[i].setType(Imf::SCANLINEIMAGE);
    channels[i].addTo(headers[i], buffers[i]);
  }
  {
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), 2);
    for (int i = 0; i < 2; ++i) {
      Imf::OutputPart part(file, i);
      part.setFrameBuffer(buffers[static_cast<size_t>(i)]);
      part.writePixels(height);
    }
  }
  out.push_back(contents(path));
  return out;
}

}  // namespace facet::fuzz
