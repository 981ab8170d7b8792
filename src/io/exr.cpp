#include "io/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfOutputFile.h>
#include <ImfPartType.h>
#include <ImfRgbaFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

#include "base/interrupt.hpp"
#include "base/whole_file.hpp"
#include "io/exr_header.hpp"
#include "io/exr_layers.hpp"
#include "io/little_endian.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;
using Imath::Box2i;

constexpr const char* convertExr = "convert it to a single-part scan-line image";

// Bits of the version field (OpenEXR File Layout, "Version field").
constexpr uint32_t deepBit = 0x800, severalPartsBit = 0x1000;

Result<void> checkVersion(Bytes bytes, const std::string& name) {
  if (bytes.size() < 8) return fail(name, "", "the file is cut off", exrCopyAgain);
  if ((littleEndian(bytes, 4) & (deepBit | severalPartsBit)) == deepBit)
    return fail(name, "byte 4", "deep images are not supported", convertExr);
  return {};
}

// The library's pool; its own default is none. It lives on, and takes no signal while another thread writes a file.
int exrThreads() {
  const SignalsHeld held;
  const int count = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  if (Imf::globalThreadCount() < count) Imf::setGlobalThreadCount(count);
  return count;
}

class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(Bytes bytes, const std::string& name) : Imf::IStream(name.c_str()), bytes_(bytes) {}
  bool isMemoryMapped() const override { return true; }
  char* readMemoryMapped(int n) override {
    need(n);
    // The library only reads through this pointer.
    char* data = const_cast<char*>(reinterpret_cast<const char*>(bytes_.data() + at_));
    at_ += static_cast<size_t>(n);
    return data;
  }
  bool read(char c[], int n) override {
    need(n);
    std::memcpy(c, bytes_.data() + at_, static_cast<size_t>(n));
    at_ += static_cast<size_t>(n);
    return at_ < bytes_.size();
  }
  uint64_t tellg() override { return at_; }
  void seekg(uint64_t at) override { at_ = at; }

 private:
  void need(int n) const {
    if (n < 0 || at_ > bytes_.size() || static_cast<size_t>(n) > bytes_.size() - at_) {
      throw std::runtime_error("the file is cut off");
    }
  }
  Bytes bytes_;
  size_t at_ = 0;
};

class MemoryOutput : public Imf::OStream {
 public:
  explicit MemoryOutput(const std::string& name) : Imf::OStream(name.c_str()) {}
  void write(const char c[], int n) override {
    bytes.resize(std::max(bytes.size(), at_ + static_cast<size_t>(n)));
    std::memcpy(bytes.data() + at_, c, static_cast<size_t>(n));
    at_ += static_cast<size_t>(n);
  }
  uint64_t tellp() override { return at_; }
  void seekp(uint64_t at) override { at_ = at; }
  std::string bytes;

 private:
  size_t at_ = 0;
};

std::vector<ExrPartChannels> exrChannels(const Imf::MultiPartInputFile& file) {
  std::vector<ExrPartChannels> parts;
  for (int p = 0; p < file.parts(); ++p) {
    const Imf::Header& header = file.header(p);
    ExrPartChannels& part = parts.emplace_back();
    if (file.parts() > 1 && header.hasName()) part.name = header.name();
    if (header.hasType() && Imf::isDeepData(header.type())) continue;
    const Imf::ChannelList& list = header.channels();
    for (auto it = list.begin(); it != list.end(); ++it) part.channels.emplace_back(it.name());
  }
  return parts;
}

// The file in memory, its layer, and where its pixels lie.
struct ExrSource {
  Bytes bytes;
  const std::string& name;
  ExrLayer layer;
  Box2i window;
  size_t width() const { return static_cast<size_t>(window.max.x - window.min.x + 1); }
  size_t pixels() const { return width() * static_cast<size_t>(window.max.y - window.min.y + 1); }
};

// Some rows at a time, so that damage is found before all of the memory is taken: calls read(first, last) for each
// band after making room for it.
template <class Read>
void readBands(const ExrSource& source, std::vector<glm::vec4>& pixels, const Read& read) {
  constexpr int rows = 256;  // a multiple of every compression's chunk
  pixels.reserve(source.pixels());
  for (int64_t y = source.window.min.y; y <= source.window.max.y; y += rows) {
    const int last = static_cast<int>(std::min<int64_t>(y + rows - 1, source.window.max.y));
    pixels.resize(static_cast<size_t>(last - source.window.min.y + 1) * source.width(), glm::vec4(0, 0, 0, 1));
    read(static_cast<int>(y), last);
  }
}

Result<void> readChannels(Imf::InputPart& part, const ExrSource& source, std::vector<glm::vec4>& pixels) {
  const ExrLayer& layer = source.layer;
  const bool grey = layer.color == ExrColor::grey;
  std::vector<std::pair<std::string, int>> channels;  // and their component
  for (int c = 0; c < (grey ? 1 : 3); ++c) channels.emplace_back(layer.prefix + (grey ? 'Y' : "RGB"[c]), c);
  if (layer.alpha) channels.emplace_back(layer.prefix + "A", 3);
  for (const auto& [channel, component] : channels) {
    const Imf::Channel& found = part.header().channels()[channel];
    if (found.xSampling == 1 && found.ySampling == 1) continue;
    return fail(source.name, "", "channel " + channel + " is subsampled", "convert it to RGB");
  }
  pixels.reserve(source.pixels());
  Imf::FrameBuffer buffer;
  for (const auto& [channel, component] : channels)
    buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, &pixels.data()->x + component, source.window, sizeof(glm::vec4),
                                            sizeof(glm::vec4) * source.width(), 1, 1, component == 3 ? 1 : 0));
  part.setFrameBuffer(buffer);
  readBands(source, pixels, [&](int first, int last) { part.readPixels(first, last); });
  if (grey)
    for (auto& pixel : pixels) pixel.y = pixel.z = pixel.x;
  return {};
}

// Chroma at half the resolution, filtered by the library, in half precision.
void readLuminanceChroma(const ExrSource& source, std::vector<glm::vec4>& pixels) {
  MemoryStream stream(source.bytes, source.name);
  std::string layer = source.layer.prefix;
  if (!layer.empty()) layer.pop_back();  // the point
  Imf::RgbaInputFile file(stream, layer, exrThreads());
  std::vector<Imf::Rgba> row(source.width());
  const ptrdiff_t left = source.window.min.x;
  file.setFrameBuffer(row.data() - left, 1, 0);  // each row into the same place
  readBands(source, pixels, [&](int first, int last) {
    for (int y = first; y <= last; ++y) {
      file.readPixels(y);
      glm::vec4* to = &pixels[static_cast<size_t>(y - source.window.min.y) * source.width()];
      for (const Imf::Rgba& p : row) *to++ = glm::vec4(p.r, p.g, p.b, p.a);
    }
  });
}

// The part of the data window that the display window shows.
std::vector<glm::vec4> placeInDisplay(const std::vector<glm::vec4>& pixels, const ExrWindow& data,
                                      const ExrWindow& display) {
  std::vector<glm::vec4> shown(display.width() * display.height(), glm::vec4(0));
  const int64_t left = std::max(data.left, display.left), right = std::min(data.right, display.right);
  const int64_t top = std::max(data.top, display.top), bottom = std::min(data.bottom, display.bottom);
  if (right < left) return shown;
  for (int64_t y = top; y <= bottom; ++y) {
    const auto* from = pixels.data() + static_cast<uint64_t>(y - data.top) * data.width() + (left - data.left);
    auto* to = shown.data() + static_cast<uint64_t>(y - display.top) * display.width() + (left - display.left);
    std::copy(from, from + (right - left + 1), to);
  }
  return shown;
}

optics::Chromaticities chromaticitiesOf(const Imf::Header& header) {
  if (!Imf::hasChromaticities(header)) return {};
  const Imf::Chromaticities& c = Imf::chromaticities(header);
  const auto xy = [](const Imath::V2f& v) { return glm::dvec2(v.x, v.y); };
  return {xy(c.red), xy(c.green), xy(c.blue), xy(c.white)};
}

ExrWindow windowOf(const Box2i& box) { return {box.min.x, box.min.y, box.max.x, box.max.y}; }

bool sameSize(const ExrWindow& a, const ExrWindow& b) { return a.width() == b.width() && a.height() == b.height(); }

void noteLayer(const std::vector<ExrPartChannels>& parts, const ExrLayer& layer, bool wanted, Notes& notes) {
  const std::vector<ExrLayer> all = exrLayers(parts);
  if (wanted || all.size() < 2) return;
  std::string others;
  for (const ExrLayer& other : all)
    if (other.name != layer.name && others.size() < 200) others += (others.empty() ? "" : ", ") + other.name;
  notes.push_back({Note::Severity::info, "",
                   layer.name.empty() ? "the picture is taken; it also holds the layers " + others
                                      : "the layer " + inQuotes(layer.name) + " is taken; it also holds " + others});
}

Result<RadianceImage> readExrImage(Bytes bytes, const std::vector<ExrPart>& scanned, const std::string& name,
                                   const std::string& wanted) {
  MemoryStream stream(bytes, name);
  // Tables of chunks that are damaged are not guessed anew: that reads all of the file.
  Imf::MultiPartInputFile file(stream, exrThreads(), false);
  const std::vector<ExrPartChannels> parts = exrChannels(file);
  const auto layer = chooseExrLayer(parts, wanted);
  if (!layer) return fail(name, "", layer.error().problem, layer.error().remedy);
  Imf::InputPart part(file, static_cast<int>(layer->part));
  const ExrSource source{bytes, name, *layer, part.header().dataWindow()};
  const ExrWindow data = windowOf(source.window), display = windowOf(part.header().displayWindow());
  // The library has read the header for itself; it must not have understood something larger.
  const ExrPart& claimed = scanned[std::min(layer->part, scanned.size() - 1)];
  if (scanned.size() != static_cast<size_t>(file.parts()) || !sameSize(data, *claimed.data) ||
      !sameSize(display, *claimed.display))
    return fail(name, "", "the header contradicts itself", exrCopyAgain);
  RadianceImage image;
  if (layer->color == ExrColor::luminanceChroma) {
    if (file.parts() > 1)
      return fail(name, "", "luminance and chroma in one of several parts are not supported", convertExr);
    readLuminanceChroma(source, image.pixels);
  } else if (auto ok = readChannels(part, source, image.pixels); !ok) {
    return tl::unexpected(ok.error());
  }
  image.width = static_cast<int>(display.width());
  image.height = static_cast<int>(display.height());
  if (source.window != part.header().displayWindow()) image.pixels = placeInDisplay(image.pixels, data, display);
  noteLayer(parts, *layer, !wanted.empty(), image.notes);
  toRec709(image, chromaticitiesOf(part.header()));
  return image;
}

}  // namespace

bool isExr(Bytes bytes) { return bytes.size() >= 4 && littleEndian(bytes, 0) == 20000630; }

Result<RadianceImage> decodeExr(Bytes bytes, const std::string& name, const Limits& limits, const std::string& layer) {
  if (auto ok = checkVersion(bytes, name); !ok) return tl::unexpected(ok.error());
  const Result<std::vector<ExrPart>> parts = scanExrParts(bytes, (littleEndian(bytes, 4) & severalPartsBit) != 0, name);
  if (!parts) return tl::unexpected(parts.error());
  for (const ExrPart& part : *parts)
    if (auto ok = checkExrPart(part, bytes.size(), name, limits); !ok) return tl::unexpected(ok.error());
  try {
    return readExrImage(bytes, *parts, name, layer);
  } catch (const std::bad_alloc&) {
    return fail(name, "", "there is not enough memory for the picture", "use a smaller picture");
  } catch (const std::exception& e) {
    return fail(name, "", std::string("the picture is damaged: ") + e.what(), exrCopyAgain);
  }
}

Result<void> writeExr(const std::filesystem::path& path, const RadianceImage& image, const Origin& origin,
                      const std::vector<ExrLayerImage>& layers) {
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [name, value] : originFields(origin))
      if (!value.empty()) header.insert(name, Imf::StringAttribute(value));
    Imf::FrameBuffer buffer;
    const auto insert = [&](const std::string& name, const RadianceImage& from, int c) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, &from.pixels.data()->x + c, header.dataWindow(),
                                           sizeof(glm::vec4), sizeof(glm::vec4) * static_cast<size_t>(from.width)));
    };
    const auto insertAll = [&](const std::string& before, const std::string& components, const RadianceImage& from) {
      for (size_t c = 0; c < components.size(); ++c) insert(before + components[c], from, static_cast<int>(c));
    };
    insertAll("", "RGBA", image);
    for (const ExrLayerImage& layer : layers) insertAll(layer.name + ".", layer.components, *layer.image);
    MemoryOutput memory(path.string());
    {
      Imf::OutputFile file(memory, header, exrThreads());
      file.setFrameBuffer(buffer);
      file.writePixels(image.height);
    }
    return writeOutputFile(path, std::as_bytes(std::span(memory.bytes)));
  } catch (const std::exception& e) {
    return fail(path.string(), "", std::string("cannot be written: ") + e.what(),
                "check the folder, its permissions and the space left");
  }
}

}  // namespace facet::io
