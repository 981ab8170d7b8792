#include "io/image.hpp"

#include <stb_image_write.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "base/parallel.hpp"
#include "base/whole_file.hpp"
#include "io/image_formats.hpp"
#include "io/safe_files.hpp"
#include "io/uri.hpp"
#include "scene/usage.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

bool startsWith(Bytes bytes, std::string_view magic, size_t at = 0) {
  return bytes.size() >= at + magic.size() && std::memcmp(bytes.data() + at, magic.data(), magic.size()) == 0;
}

struct Format {
  const char* name;
  bool (*is)(Bytes);
  Result<ImageHeader> (*readHeader)(Bytes);
  Result<Pixels> (*decode)(Bytes, const ImageHeader&);
};
constexpr Format formats[] = {{"PNG", isPng, readPngHeader, decodePng},
                              {"JPEG", isJpeg, readJpegHeader, decodeJpeg},
                              {"WebP", isWebp, readWebpHeader, decodeWebp},
                              {"AVIF", isAvif, readAvifHeader, decodeAvif},
                              {"KTX2", isKtx2, readKtx2Header, decodeKtx2}};

const Format* formatOf(Bytes bytes) {
  const auto found = std::ranges::find_if(formats, [&](const Format& format) { return format.is(bytes); });
  return found == std::end(formats) ? nullptr : found;
}

// Formats that are met in the wild and named, so that the message helps.
const char* foreignFormat(Bytes bytes) {
  const struct {
    std::string_view magic;
    size_t at;
    const char* name;
  } named[] = {{std::string_view("\xabKTX 11\xbb", 8), 0, "KTX 1"},
               {"DDS ", 0, "DDS"},
               {"GIF8", 0, "GIF"},
               {"BM", 0, "BMP"},
               {"8BPS", 0, "PSD"},
               {std::string_view("II*\0", 4), 0, "TIFF"},
               {std::string_view("MM\0*", 4), 0, "TIFF"},
               {"#?", 0, "Radiance HDR"},
               {"v/1\x01", 0, "OpenEXR"}};
  for (const auto& format : named) {
    if (startsWith(bytes, format.magic, format.at)) return format.name;
  }
  return nullptr;
}

// What an encoder's finest script for progressive pictures has, rounded up.
constexpr uint64_t passesOfLargest = 32;

std::string sizeText(const ImageHeader& h) { return std::to_string(h.width) + " x " + std::to_string(h.height); }

// Checked against the limits. Errors come without a name.
Result<ImageHeader> readHeader(Bytes bytes, const Limits& limits) {
  const Format* format = formatOf(bytes);
  if (format == nullptr) {
    if (bytes.empty()) return fail("", "", "the image is empty", "save it again");
    const char* foreign = foreignFormat(bytes);
    return fail("", "",
                foreign ? std::string("is a ") + foreign + " image, which is not supported"
                        : std::string("is no PNG, JPEG, WebP, AVIF or KTX2 image"),
                "convert it to PNG or JPEG");
  }
  const auto header = format->readHeader(bytes);
  if (!header) return header;
  if (header->pixels() > limits.imagePixels) {
    return fail(
        "", "",
        "the image has " + sizeText(*header) + " pixels, more than the limit of " + std::to_string(limits.imagePixels),
        "use a smaller image");
  }
  if (static_cast<uint64_t>(std::max(header->width, header->height)) > limits.imageSide) {
    return fail("", "",
                "the image is " + sizeText(*header) + ", and a side of " + std::to_string(limits.imageSide) +
                    " is the most that can be shown",
                "use a smaller image");
  }
  if (header->leastBytes > bytes.size())
    return fail("", "", "the file is too short for " + sizeText(*header) + " pixels", "save it again");
  if (header->pixels() * header->passes > limits.imagePixels * passesOfLargest) {
    return fail("", "",
                "the image has " + std::to_string(header->passes) + " scans of " + sizeText(*header) + " pixels",
                "save it again");
  }
  return header;
}

Result<Pixels> decode(Bytes bytes, const ImageHeader& header) { return formatOf(bytes)->decode(bytes, header); }

// One image of a model on its way to pixels.
struct Work {
  size_t index = 0, target = 0;  // in the model; where its pixels go
  FileBytes file;
  Bytes bytes;
  ImageHeader header;
  std::string problem;  // not empty: placeholder
};

void readWorkHeader(Work& work, const Limits& limits) {
  const auto header = readHeader(work.bytes, limits);
  if (header) {
    work.header = *header;
  } else {
    work.problem = header.error().problem;
  }
}

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
  readWorkHeader(work, limits);
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
    const auto named = [&](const Error& e) { return fail(name, e.place, e.problem, e.remedy); };
    const auto header = readHeader(encoded, limits);
    if (!header) return named(header.error());
    auto pixels = decode(encoded, *header);
    if (!pixels) return named(pixels.error());
    if (!pixels->flaw.empty()) return fail(name, "", "the image is damaged: " + pixels->flaw, "save it again");
    return pixels;
  } catch (const std::exception&) {
    return fail(name, "", "there is not enough memory for the image", "use a smaller image");
  }
}

namespace {

// Reads and decodes in parallel; `pixels`, that were decoded before, count towards the limit.
void decodeWorks(const scene::Model& model, std::vector<Work>& works, std::vector<Pixels>& result, uint64_t& pixels,
                 const Limits& limits) {
  parallelFor(works.size(),
              [&](size_t i) { guarded(works[i], [&] { readWork(model.images[works[i].index], works[i], limits); }); });
  for (Work& work : works) {  // in the order of the file, so that the same images are refused every time
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
      auto decoded = decode(work.bytes, work.header);
      if (decoded) {
        result[work.target] = std::move(*decoded);
      } else {
        work.problem = decoded.error().problem;
      }
    });
  });
}

// What is read as colours and says that it is none, or the other way round: the use decides, as glTF has it.
void noteTransfers(const scene::Model& model, const std::vector<Pixels>& result, Notes& notes) {
  std::vector<bool> told(model.images.size(), false);
  for (const scene::Material& material : model.materials) {
    for (const scene::TextureSlot slot : scene::textureSlots) {
      const int texture = scene::textureRef(material, slot).texture;
      const int image = texture >= 0 ? model.textures[static_cast<size_t>(texture)].image : -1;
      if (image < 0 || told[static_cast<size_t>(image)] || !scene::usesTexture(material, slot)) continue;
      const auto transfer = result[static_cast<size_t>(image)].transfer;
      const bool srgb = scene::texelUse(material, slot).srgb;
      if (transfer == Pixels::Transfer::unknown || (transfer == Pixels::Transfer::srgb) == srgb) continue;
      told[static_cast<size_t>(image)] = true;
      notes.push_back({Note::Severity::warning, "/images/" + std::to_string(image),
                       "the image " + inQuotes(model.images[static_cast<size_t>(image)].name) + " says that it is " +
                           (srgb ? "linear" : "sRGB") + ", and is read as " + (srgb ? "sRGB" : "linear") + " by " +
                           scene::name(slot)});
    }
  }
}

void noteWork(const scene::Model& model, const Work& work, const Pixels& pixels, Notes& notes) {
  const scene::Image& image = model.images[work.target];
  const auto warn = [&](const std::string& text) {
    notes.push_back({Note::Severity::warning, "/images/" + std::to_string(work.target),
                     "the image " + inQuotes(image.name) + text,
                     image.outside ? Setting::allowOutside : Setting::none});
  };
  if (!pixels.flaw.empty()) warn(" is damaged, and a part of it may look wrong: " + pixels.flaw);
  for (const std::string& remark : pixels.remarks) warn(": " + remark);
}

}  // namespace

std::vector<Pixels> decodeImages(const scene::Model& model, const std::vector<bool>& wanted, Notes& notes,
                                 const Limits& limits) {
  std::vector<Pixels> result(model.images.size());
  std::vector<Work> works;
  for (size_t i = 0; i < model.images.size() && i < wanted.size(); ++i) {
    if (!wanted[i]) continue;
    works.emplace_back().index = i;
    works.back().target = i;
  }
  uint64_t pixels = 0;
  decodeWorks(model, works, result, pixels, limits);
  std::vector<Work> instead;
  for (const Work& work : works) {
    const int fallback = model.images[work.index].fallback;
    if (work.problem.empty() || fallback < 0) continue;
    instead.emplace_back().index = static_cast<size_t>(fallback);
    instead.back().target = work.index;
  }
  decodeWorks(model, instead, result, pixels, limits);
  for (const Work& work : works) {
    if (work.problem.empty()) {
      noteWork(model, work, result[work.target], notes);
      continue;
    }
    const scene::Image& image = model.images[work.index];
    const auto other = std::ranges::find(instead, work.index, &Work::target);
    const bool replaced = other != instead.end() && other->problem.empty();
    std::string text = "the image " + inQuotes(image.name) + " cannot be shown: " + work.problem;
    if (other != instead.end() && !replaced)
      text += ", nor " + inQuotes(model.images[other->index].name) + " in its place: " + other->problem;
    text += replaced ? "; " + inQuotes(model.images[other->index].name) + " is shown in its place"
                     : std::string("; a placeholder takes its place");
    notes.push_back({Note::Severity::warning, "/images/" + std::to_string(work.index), text,
                     image.outside ? Setting::allowOutside : Setting::none});
    if (replaced)
      noteWork(model, *other, result[work.index], notes);
    else
      result[work.index] = placeholderImage();
  }
  noteTransfers(model, result, notes);
  return result;
}

namespace {

void describe(const Work& work, ImageInfo& info) {
  info.problem = work.problem;
  if (!work.problem.empty()) return;
  const ImageHeader& header = work.header;
  info.format = formatOf(work.bytes)->name + (header.texels.empty() ? "" : " (" + header.texels + ")");
  info.width = header.width;
  info.height = header.height;
  info.channels = header.channels;
  info.bytesPerSample = header.bytesPerSample;
  info.levels = header.levels;
}

}  // namespace

ImageInfo describeImage(Bytes encoded, const Limits& limits) {
  Work work;
  work.bytes = encoded;
  guarded(work, [&] { readWorkHeader(work, limits); });
  ImageInfo info;
  describe(work, info);
  return info;
}

std::vector<ImageInfo> describeImages(const scene::Model& model, const Limits& limits) {
  std::vector<ImageInfo> result(model.images.size());
  parallelFor(result.size(), [&](size_t i) {
    Work work;
    guarded(work, [&] { readWork(model.images[i], work, limits); });
    describe(work, result[i]);
  });
  return result;
}

std::string mediaType(std::span<const uint8_t> bytes) {
  if (isJpeg(bytes)) return "image/jpeg";
  if (isPng(bytes)) return "image/png";
  if (isWebp(bytes)) return "image/webp";
  if (isKtx2(bytes)) return "image/ktx2";
  return isAvif(bytes) ? "image/avif" : "";
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
  // Process-wide in stb. Higher levels search longer for a few per cent.
  stbi_write_png_compression_level = 5;
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

Result<void> writePng(const std::filesystem::path& path, const Pixels& pixels, std::span<const PngText> texts) {
  if (auto ok = checkWritable(pixels, path.string()); !ok) return ok;
  std::vector<uint8_t> bytes;
  try {
    bytes = pngOf(pixels, texts);
  } catch (const std::bad_alloc&) {
  }
  if (bytes.empty()) return fail(path.string(), "", "there is not enough memory for the PNG", "choose a smaller size");
  return writeWholeFile(path, std::as_bytes(std::span(bytes)));
}

std::string readPngText(const std::filesystem::path& path, std::string_view keyword, const Limits& limits) {
  const auto bytes = readRegularFile(path, limits.fileBytes);
  return bytes && isPng(bytes->span()) ? pngText(bytes->span(), keyword) : std::string();
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
