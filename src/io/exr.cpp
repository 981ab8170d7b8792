#include "io/exr.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfThreading.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "io/little_endian.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;
using Imath::Box2i;

constexpr const char* convertExr = "convert it to a single-part scan-line image";
constexpr const char* copyAgain = "copy or download it again";

struct Window {
  int64_t left = 0, top = 0, right = -1, bottom = -1;  // inclusive
  uint64_t width() const { return static_cast<uint64_t>(std::max<int64_t>(0, right - left + 1)); }
  uint64_t height() const { return static_cast<uint64_t>(std::max<int64_t>(0, bottom - top + 1)); }
};

// The windows straight from the header's attributes (name, type, size, value), because the library allocates by them
// before anyone can look.
struct Windows {
  std::optional<Window> data, display;
};

Windows findWindows(Bytes bytes) {
  Windows windows;
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  for (size_t at = 8; at < bytes.size() && bytes[at] != 0;) {
    const size_t nameEnd = text.find('\0', at);
    if (nameEnd == std::string_view::npos) break;
    const size_t typeEnd = text.find('\0', nameEnd + 1);
    if (typeEnd == std::string_view::npos || typeEnd + 5 > bytes.size()) break;
    const std::string_view name = text.substr(at, nameEnd - at), type = text.substr(nameEnd + 1, typeEnd - nameEnd - 1);
    const size_t size = littleEndian(bytes, typeEnd + 1), value = typeEnd + 5;
    if (size > bytes.size() - value) break;
    if (type == "box2i" && size == 16 && (name == "dataWindow" || name == "displayWindow")) {
      const auto number = [&](size_t i) { return static_cast<int32_t>(littleEndian(bytes, value + 4 * i)); };
      (name == "dataWindow" ? windows.data : windows.display) = Window{number(0), number(1), number(2), number(3)};
    }
    at = value + size;
  }
  return windows;
}

Result<void> checkWindow(const std::optional<Window>& window, const char* what, const std::string& name,
                         const Limits& limits) {
  if (!window) return fail(name, "", std::string("the header has no ") + what, copyAgain);
  const uint64_t width = window->width(), height = window->height();
  if (width == 0 || height == 0) return fail(name, "", std::string("the ") + what + " is empty", copyAgain);
  if (height > limits.radiancePixels / width) {
    return fail(name, "",
                std::string("the ") + what + " has " + std::to_string(width) + " x " + std::to_string(height) +
                    " pixels, more than the limit of " + std::to_string(limits.radiancePixels),
                "use a smaller picture");
  }
  return {};
}

// Bits of the version field (OpenEXR File Layout, "Version field").
Result<void> checkVersion(Bytes bytes, const std::string& name) {
  if (bytes.size() < 8) return fail(name, "", "the file is cut off", copyAgain);
  const uint32_t flags = littleEndian(bytes, 4);
  if (flags & 0x800) return fail(name, "byte 4", "deep images are not supported", convertExr);
  if (flags & 0x1000) return fail(name, "byte 4", "images of several parts are not supported", convertExr);
  return {};
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

struct Channels {
  std::string prefix;  // "" or "layer."
  bool grey = false, alpha = false;
};

Result<Channels> chooseChannels(const Imf::ChannelList& list, const std::string& name) {
  Channels chosen;
  const auto has = [&](const std::string& channel) { return list.findChannel(channel) != nullptr; };
  std::string names;
  bool colour = has("R") && has("G") && has("B");
  for (auto it = list.begin(); it != list.end(); ++it) {
    const std::string channel = it.name();
    names += (names.empty() ? "" : ", ") + channel;
    if (colour || !channel.ends_with(".R")) continue;
    const std::string prefix = channel.substr(0, channel.size() - 1);
    if (has(prefix + "G") && has(prefix + "B")) chosen.prefix = prefix, colour = true;
  }
  if (!colour) {
    chosen.grey = has("Y") && !has("RY") && !has("BY");
    if (!chosen.grey) {
      return fail(name, "", "there are no channels R, G, B or Y alone, but " + names.substr(0, 200),
                  "convert it to RGB");
    }
  }
  chosen.alpha = has(chosen.prefix + "A");
  for (const char* channel : {"R", "G", "B", "A", "Y"}) {
    const auto* found = list.findChannel(chosen.prefix + channel);
    if (found != nullptr && (found->xSampling != 1 || found->ySampling != 1)) {
      return fail(name, "", std::string("channel ") + channel + " is subsampled", "convert it to RGB");
    }
  }
  return chosen;
}

// Reads the data window into pixels, row after row.
void readPixels(Imf::InputFile& file, const Channels& channels, const Box2i& window, std::vector<glm::vec4>& pixels) {
  Imf::FrameBuffer buffer;
  const auto add = [&](const std::string& channel, int component, double fill) {
    buffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, &pixels.data()->x + component, window, sizeof(glm::vec4),
                                            sizeof(glm::vec4) * static_cast<size_t>(window.max.x - window.min.x + 1), 1,
                                            1, fill));
  };
  if (channels.grey) {
    add("Y", 0, 0);
  } else {
    add(channels.prefix + "R", 0, 0);
    add(channels.prefix + "G", 1, 0);
    add(channels.prefix + "B", 2, 0);
  }
  if (channels.alpha) add(channels.prefix + "A", 3, 1);
  file.setFrameBuffer(buffer);
  file.readPixels(window.min.y, window.max.y);
  if (!channels.grey) return;
  for (auto& pixel : pixels) pixel.y = pixel.z = pixel.x;
}

// The part of the data window that the display window shows.
RadianceImage place(const std::vector<glm::vec4>& pixels, const Window& data, const Window& display) {
  RadianceImage image;
  image.width = static_cast<int>(display.width());
  image.height = static_cast<int>(display.height());
  image.pixels.resize(display.width() * display.height(), glm::vec4(0));
  const int64_t left = std::max(data.left, display.left), right = std::min(data.right, display.right);
  const int64_t top = std::max(data.top, display.top), bottom = std::min(data.bottom, display.bottom);
  if (right < left) return image;
  for (int64_t y = top; y <= bottom; ++y) {
    const auto* from = pixels.data() + static_cast<uint64_t>(y - data.top) * data.width() + (left - data.left);
    auto* to = image.pixels.data() + static_cast<uint64_t>(y - display.top) * display.width() + (left - display.left);
    std::copy(from, from + (right - left + 1), to);
  }
  return image;
}

// The library's pool; its own default is none.
int threads() {
  const int count = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  if (Imf::globalThreadCount() < count) Imf::setGlobalThreadCount(count);
  return count;
}

}  // namespace

bool isExr(Bytes bytes) { return bytes.size() >= 4 && littleEndian(bytes, 0) == 20000630; }

Result<RadianceImage> decodeExr(Bytes bytes, const std::string& name, const Limits& limits) {
  if (auto ok = checkVersion(bytes, name); !ok) return tl::unexpected(ok.error());
  const Windows windows = findWindows(bytes);
  if (auto ok = checkWindow(windows.data, "data window", name, limits); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkWindow(windows.display, "display window", name, limits); !ok) return tl::unexpected(ok.error());
  try {
    MemoryStream stream(bytes, name);
    Imf::InputFile file(stream, threads());
    const auto channels = chooseChannels(file.header().channels(), name);
    if (!channels) return tl::unexpected(channels.error());
    const Box2i box = file.header().dataWindow(), shown = file.header().displayWindow();
    const Window data{box.min.x, box.min.y, box.max.x, box.max.y};
    const Window display{shown.min.x, shown.min.y, shown.max.x, shown.max.y};
    // The library has read the header for itself; it must not have understood something larger.
    if (data.width() != windows.data->width() || data.height() != windows.data->height() ||
        display.width() != windows.display->width() || display.height() != windows.display->height()) {
      return fail(name, "", "the header contradicts itself", copyAgain);
    }
    std::vector<glm::vec4> pixels(data.width() * data.height(), glm::vec4(0, 0, 0, 1));
    readPixels(file, *channels, box, pixels);
    if (box == shown)
      return RadianceImage{static_cast<int>(data.width()), static_cast<int>(data.height()), std::move(pixels)};
    return place(pixels, data, display);
  } catch (const std::bad_alloc&) {
    return fail(name, "", "there is not enough memory for the picture", "use a smaller picture");
  } catch (const std::exception& e) {
    return fail(name, "", std::string("the picture is damaged: ") + e.what(), copyAgain);
  }
}

Result<void> writeExr(const std::filesystem::path& path, const RadianceImage& image) {
  try {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer buffer;
    const char* names[] = {"R", "G", "B", "A"};
    for (int c = 0; c < 4; ++c) {
      header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
      buffer.insert(names[c],
                    Imf::Slice::Make(Imf::FLOAT, &image.pixels.data()->x + c, header.dataWindow(), sizeof(glm::vec4),
                                     sizeof(glm::vec4) * static_cast<size_t>(image.width)));
    }
    Imf::OutputFile file(path.c_str(), header, threads());
    file.setFrameBuffer(buffer);
    file.writePixels(image.height);
    return {};
  } catch (const std::exception& e) {
    return fail(path.string(), "", std::string("cannot be written: ") + e.what(),
                "check the folder, its permissions and the space left");
  }
}

}  // namespace facet::io
