#include "io/image.hpp"

#include <stb_image.h>
#include <stb_image_write.h>
#include <webp/decode.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <limits>
#include <memory>
#include <optional>

#include "base/parallel.hpp"
#include "io/safe_files.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

struct ImageHeader {
  int width = 0, height = 0, channels = 0;
  bool sixteenBit = false;
  bool webp = false;
  uint64_t pixels() const { return static_cast<uint64_t>(width) * static_cast<uint64_t>(height); }
};

bool startsWith(Bytes bytes, std::string_view magic, size_t at = 0) {
  return bytes.size() >= at + magic.size() && std::memcmp(bytes.data() + at, magic.data(), magic.size()) == 0;
}

constexpr std::string_view pngMagic("\x89PNG\r\n\x1a\n", 8), jpegMagic("\xff\xd8\xff", 3);

// Formats that are met in the wild and named, so that the message helps. stb would also read some of them, with bugs
// that take gigabytes for 18 bytes of TGA.
const char* foreignFormat(Bytes bytes) {
  const struct {
    std::string_view magic;
    size_t at;
    const char* name;
  } formats[] = {{std::string_view("\xabKTX 20\xbb", 8), 0, "KTX2"},
                 {std::string_view("\xabKTX 11\xbb", 8), 0, "KTX"},
                 {"DDS ", 0, "DDS"},
                 {"GIF8", 0, "GIF"},
                 {"BM", 0, "BMP"},
                 {"8BPS", 0, "PSD"},
                 {std::string_view("II*\0", 4), 0, "TIFF"},
                 {std::string_view("MM\0*", 4), 0, "TIFF"},
                 {"#?", 0, "Radiance HDR"},
                 {"v/1\x01", 0, "OpenEXR"},
                 {"ftypavif", 4, "AVIF"}};
  for (const auto& format : formats) {
    if (startsWith(bytes, format.magic, format.at)) return format.name;
  }
  return nullptr;
}

std::string sizeText(const ImageHeader& h) { return std::to_string(h.width) + " x " + std::to_string(h.height); }

// Deflate cannot shrink more than this (zlib's manual: 1032:1), so a header that claims more lies.
constexpr uint64_t largestDeflateRatio = 1040;

bool isWebp(Bytes bytes) { return startsWith(bytes, "RIFF") && startsWith(bytes, "WEBP", 8); }

// Errors come without a name.
Result<ImageHeader> readWebpHeader(Bytes bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK || features.width <= 0 ||
      features.height <= 0) {
    return fail("", "", "the image's header is damaged", "save it again");
  }
  if (features.has_animation) return fail("", "", "is an animated WebP image", "use a still image");
  return ImageHeader{features.width, features.height, features.has_alpha ? 4 : 3, false, true};
}

Result<ImageHeader> readStbHeader(Bytes bytes) {
  ImageHeader header;
  const int size = static_cast<int>(bytes.size());
  if (!stbi_info_from_memory(bytes.data(), size, &header.width, &header.height, &header.channels) ||
      header.width <= 0 || header.height <= 0) {
    return fail("", "", "the image's header is damaged", "save it again");
  }
  return header;
}

Result<ImageHeader> readHeader(Bytes bytes, const std::string& name, const Limits& limits) {
  constexpr const char* convert = "convert it to PNG or JPEG";
  const bool png = startsWith(bytes, pngMagic);
  const bool webp = isWebp(bytes);
  if (!png && !webp && !startsWith(bytes, jpegMagic)) {
    const char* format = foreignFormat(bytes);
    if (bytes.empty()) return fail(name, "", "the image is empty", "save it again");
    return fail(name, "",
                format ? std::string("is a ") + format + " image, which is not supported"
                       : std::string("is no PNG, JPEG or WebP image"),
                convert);
  }
  if (bytes.size() > static_cast<size_t>(std::numeric_limits<int>::max())) {
    return fail(name, "", "the image file is larger than 2 GiB", "use a smaller image");
  }
  auto read = webp ? readWebpHeader(bytes) : readStbHeader(bytes);
  if (!read) return fail(name, "", read.error().problem, read.error().remedy);
  ImageHeader header = *read;
  if (header.pixels() > limits.imagePixels) {
    return fail(
        name, "",
        "the image has " + sizeText(header) + " pixels, more than the limit of " + std::to_string(limits.imagePixels),
        "use a smaller image");
  }
  if (static_cast<uint64_t>(std::max(header.width, header.height)) > limits.imageSide) {
    return fail(name, "",
                "the image is " + sizeText(header) + ", and a side of " + std::to_string(limits.imageSide) +
                    " is the most that can be shown",
                "use a smaller image");
  }
  header.sixteenBit = png && stbi_is_16_bit_from_memory(bytes.data(), static_cast<int>(bytes.size()));
  if (png && header.pixels() / 8 > bytes.size() * largestDeflateRatio) {  // 1 bit per pixel is the least
    return fail(name, "", "the file is too short for " + sizeText(header) + " pixels", "save it again");
  }
  return header;
}

struct Free {
  void operator()(void* data) const { stbi_image_free(data); }
};

Result<Pixels> decodeWebp(Bytes bytes, const ImageHeader& header, const std::string& name) {
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.channels;
  pixels.data.resize(header.pixels() * static_cast<uint64_t>(header.channels));
  const auto function = header.channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
  if (!function(bytes.data(), bytes.size(), pixels.data.data(), pixels.data.size(), header.width * header.channels)) {
    return fail(name, "", "the image is damaged: its WebP data is faulty or too short", "save it again");
  }
  return pixels;
}

Result<Pixels> decode(Bytes bytes, const ImageHeader& header, const std::string& name) {
  if (header.webp) return decodeWebp(bytes, header, name);
  Pixels pixels;
  const int size = static_cast<int>(bytes.size());
  int *w = &pixels.width, *h = &pixels.height, *c = &pixels.channels;
  void* raw = header.sixteenBit ? static_cast<void*>(stbi_load_16_from_memory(bytes.data(), size, w, h, c, 0))
                                : static_cast<void*>(stbi_load_from_memory(bytes.data(), size, w, h, c, 0));
  const std::unique_ptr<void, Free> data(raw);
  if (!data || pixels.width != header.width || pixels.height != header.height) {
    const char* reason = data ? "its size changes" : stbi_failure_reason();
    return fail(name, "", std::string("the image is damaged: ") + (reason ? reason : "unknown reason"),
                "save it again");
  }
  pixels.bytesPerSample = header.sixteenBit ? 2 : 1;
  const auto* begin = static_cast<const uint8_t*>(data.get());
  pixels.data.assign(begin, begin + header.pixels() * static_cast<uint64_t>(pixels.channels * pixels.bytesPerSample));
  return pixels;
}

// One image of a model on its way to pixels.
struct Work {
  size_t index = 0;
  FileBytes file;
  Bytes bytes;
  ImageHeader header;
  std::string problem;  // not empty: placeholder
};

void readWork(const scene::Image& image, Work& work, const Limits& limits) {
  work.problem = image.problem;
  if (!work.problem.empty()) return;
  work.bytes = image.encoded;
  if (!image.file.empty()) {
    auto file = readRegularFile(image.file, limits.fileBytes);
    if (!file) {
      work.problem = file.error().problem;
      return;
    }
    work.file = std::move(*file);
    work.bytes = work.file.span();
  }
  const auto header = readHeader(work.bytes, "", limits);
  if (header) {
    work.header = *header;
  } else {
    work.problem = header.error().problem;
  }
}

// Exceptions must not leave a thread.
template <class Function>
void guarded(Work& work, const Function& function) {
  try {
    function();
  } catch (const std::exception&) {
    work.problem = "there is not enough memory for it";
  }
}

}  // namespace

Result<Pixels> decodeImage(Bytes encoded, const std::string& name, const Limits& limits) {
  try {
    const auto header = readHeader(encoded, name, limits);
    if (!header) return tl::unexpected(header.error());
    return decode(encoded, *header, name);
  } catch (const std::exception&) {
    return fail(name, "", "there is not enough memory for the image", "use a smaller image");
  }
}

std::vector<Pixels> decodeImages(const scene::Model& model, const std::vector<bool>& wanted, Notes& notes,
                                 const Limits& limits) {
  std::vector<Pixels> result(model.images.size());
  std::vector<Work> works;
  for (size_t i = 0; i < model.images.size() && i < wanted.size(); ++i) {
    if (wanted[i]) works.emplace_back().index = i;
  }
  parallelFor(works.size(),
              [&](size_t i) { guarded(works[i], [&] { readWork(model.images[works[i].index], works[i], limits); }); });
  uint64_t pixels = 0;  // in the order of the file, so that the same images are refused every time
  for (Work& work : works) {
    if (!work.problem.empty()) continue;
    if (work.header.pixels() > limits.totalPixels - std::min(pixels, limits.totalPixels)) {
      work.problem = "the images together have more than " + std::to_string(limits.totalPixels) + " pixels";
    } else {
      pixels += work.header.pixels();
    }
  }
  parallelFor(works.size(), [&](size_t i) {
    Work& work = works[i];
    if (!work.problem.empty()) return;
    guarded(work, [&] {
      auto decoded = decode(work.bytes, work.header, "");
      if (decoded) {
        result[work.index] = std::move(*decoded);
      } else {
        work.problem = decoded.error().problem;
      }
    });
  });
  for (const Work& work : works) {
    if (work.problem.empty()) continue;
    result[work.index] = placeholderImage();
    notes.push_back({Note::Severity::warning, "/images/" + std::to_string(work.index),
                     "the image " + inQuotes(model.images[work.index].name) + " cannot be shown: " + work.problem +
                         "; a placeholder takes its place"});
  }
  return result;
}

Pixels placeholderImage() {
  constexpr int size = 64, square = 8;
  Pixels pixels;
  pixels.width = pixels.height = size;
  pixels.channels = 3;
  pixels.placeholder = true;
  pixels.data.resize(size * size * 3);
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const bool magenta = (x / square + y / square) % 2 == 0;
      uint8_t* pixel = &pixels.data[static_cast<size_t>((y * size + x) * 3)];
      pixel[0] = pixel[2] = magenta ? 255 : 0;
    }
  }
  return pixels;
}

namespace {

Result<void> checkWritable(const Pixels& pixels, const std::string& name) {
  const auto bytes = static_cast<uint64_t>(pixels.width) * static_cast<uint64_t>(pixels.height) *
                     static_cast<uint64_t>(pixels.channels);
  if (pixels.width <= 0 || pixels.height <= 0 || pixels.bytesPerSample != 1 || bytes != pixels.data.size() ||
      bytes > static_cast<uint64_t>(std::numeric_limits<int>::max())) {
    return fail(name, "", "these pixels cannot be written as an 8-bit PNG", "choose a smaller size");
  }
  return {};
}

}  // namespace

Result<std::vector<uint8_t>> encodePng(const Pixels& pixels, const std::string& name) {
  if (auto ok = checkWritable(pixels, name); !ok) return tl::unexpected(ok.error());
  std::vector<uint8_t> out;
  const auto write = [](void* context, void* data, int size) {
    const auto* begin = static_cast<const uint8_t*>(data);
    static_cast<std::vector<uint8_t>*>(context)->insert(static_cast<std::vector<uint8_t>*>(context)->end(), begin,
                                                        begin + size);
  };
  if (stbi_write_png_to_func(write, &out, pixels.width, pixels.height, pixels.channels, pixels.data.data(), 0) == 0)
    return fail(name, "", "cannot be encoded as PNG", "choose a smaller size");
  return out;
}

Result<void> writePng(const std::filesystem::path& path, const Pixels& pixels) {
  if (auto ok = checkWritable(pixels, path.string()); !ok) return ok;
  const auto cannot = [&] {
    return fail(path.string(), "", std::string("cannot be written: ") + std::strerror(errno),
                "check the folder, its permissions and the space left");
  };
  // Process-wide in stb. Higher levels search longer for a few per cent.
  stbi_write_png_compression_level = 5;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return cannot();
  const auto write = [](void* context, void* data, int size) {
    std::fwrite(data, 1, static_cast<size_t>(size), static_cast<std::FILE*>(context));
  };
  const bool encoded =
      stbi_write_png_to_func(write, file, pixels.width, pixels.height, pixels.channels, pixels.data.data(), 0) != 0;
  const bool written = std::ferror(file) == 0;
  const bool closed = std::fclose(file) == 0;
  if (!encoded || !written || !closed) return cannot();
  return {};
}

Result<Pixels> readImage(const std::filesystem::path& path, const Limits& limits) {
  const auto bytes = readRegularFile(path, limits.fileBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  auto pixels = decodeImage(bytes->span(), path.string(), limits);
  if (!pixels || (pixels->channels == 4 && pixels->bytesPerSample == 1)) return pixels;

  Pixels rgba;
  rgba.width = pixels->width;
  rgba.height = pixels->height;
  rgba.channels = 4;
  const size_t count = static_cast<size_t>(rgba.width) * static_cast<size_t>(rgba.height);
  rgba.data.resize(count * 4);
  const auto channels = static_cast<size_t>(pixels->channels), sample = static_cast<size_t>(pixels->bytesPerSample);
  const bool grey = channels < 3, alpha = channels % 2 == 0;
  const auto value = [&](size_t pixel, size_t channel) -> uint8_t {
    const uint8_t* at = &pixels->data[(pixel * channels + channel) * sample];
    if (sample == 1) return *at;
    uint16_t wide;
    std::memcpy(&wide, at, sizeof wide);
    return static_cast<uint8_t>((wide * 255u + 32767u) / 65535u);
  };
  for (size_t i = 0; i < count; ++i) {
    for (size_t c = 0; c < 3; ++c) rgba.data[i * 4 + c] = value(i, grey ? 0 : c);
    rgba.data[i * 4 + 3] = alpha ? value(i, channels - 1) : 255;
  }
  return rgba;
}

}  // namespace facet::io
