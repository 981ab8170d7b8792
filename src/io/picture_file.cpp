#include "io/picture_file.hpp"

#include <algorithm>
#include <new>

#include "base/file_ending.hpp"
#include "base/whole_file.hpp"
#include "io/image_formats.hpp"

namespace facet::io {

namespace {

constexpr PictureFormatRow formatRows[] = {{PictureFormat::png, "PNG", ".png", "", 0, true, true, false},
                                           {PictureFormat::jpeg, "JPEG", ".jpg", ".jpeg", 65500, false, false, true},
                                           {PictureFormat::webp, "WebP", ".webp", "", 16383, true, false, true},
                                           {PictureFormat::avif, "AVIF", ".avif", "", 65536, true, false, true},
                                           {PictureFormat::exr, "OpenEXR", ".exr", "", 0, true, true, false}};

Result<void> checkPixels(const PictureFormatRow& row, const Pixels& pixels, const std::string& name) {
  const std::string written = "cannot be written as " + std::string(row.name) + ": ";
  if (pixels.channels == 4 && !row.alpha)
    return fail(name, "", written + "it has no transparency", "name it .png, .webp or .avif");
  if (pixels.bytesPerSample == 2 && !row.deep)
    return fail(name, "", written + "it has 8 bits a channel", "name it .png, or ask for 8 bits");
  return checkPictureSize(row.format, pixels.width, pixels.height, name);
}

std::vector<uint8_t> encoded(PictureFormat format, const Pixels& pixels, int quality) {
  switch (format) {
    case PictureFormat::png:
      return pngOf(pixels, {});
    case PictureFormat::jpeg:
      return jpegOf(pixels, quality);
    case PictureFormat::webp:
      return webpOf(pixels, quality);
    case PictureFormat::avif:
      return avifOf(pixels, quality);
    case PictureFormat::exr:
      break;
  }
  return {};
}

}  // namespace

std::span<const PictureFormatRow> pictureFormats() { return formatRows; }

const PictureFormatRow& rowOf(PictureFormat format) { return formatRows[static_cast<size_t>(format)]; }

std::optional<PictureFormat> pictureFormat(const std::filesystem::path& path) {
  const std::string ending = fileEnding(path);
  for (const PictureFormatRow& row : formatRows)
    if (!ending.empty() && (ending == row.ending || ending == row.otherEnding)) return row.format;
  return std::nullopt;
}

std::optional<PictureFormat> pictureFormatNamed(std::string_view word) {
  return pictureFormat("x." + std::string(word));
}

std::string pictureEndings(bool exr) {
  std::string text;
  const size_t count = std::size(formatRows) - (exr ? 0 : 1);
  for (size_t i = 0; i < count; ++i)
    text += (i == 0 ? "" : i + 1 == count ? " or " : ", ") + std::string(formatRows[i].ending);
  return text;
}

Result<void> checkPictureSize(PictureFormat format, int width, int height, const std::string& name) {
  const PictureFormatRow& row = rowOf(format);
  if (row.longest == 0 || std::max(width, height) <= row.longest) return {};
  return fail(name, "",
              std::string(row.name) + " holds pictures of up to " + std::to_string(row.longest) +
                  " pixels along a side, not " + std::to_string(width) + " x " + std::to_string(height),
              "choose a smaller size, or name it .png");
}

Result<std::vector<uint8_t>> encodePicture(PictureFormat format, const Pixels& pixels, int quality,
                                           const std::string& name) {
  const PictureFormatRow& row = rowOf(format);
  if (Result<void> r = checkPixels(row, pixels, name); !r) return tl::unexpected(r.error());
  if (format == PictureFormat::avif && !canReadAvif())
    return fail(name, "", "AVIF needs a library that is not installed", "install libavif, or name it .webp or .png");
  std::vector<uint8_t> bytes;
  try {
    bytes = encoded(format, pixels, quality);
  } catch (const std::bad_alloc&) {
  }
  if (bytes.empty())
    return fail(name, "", "there is not enough memory for the " + std::string(row.name), "choose a smaller size");
  return bytes;
}

Result<void> writePicture(const std::filesystem::path& path, PictureFormat format, const Pixels& pixels, int quality) {
  const Result<std::vector<uint8_t>> bytes = encodePicture(format, pixels, quality, path.string());
  return bytes ? writeOutputFile(path, std::as_bytes(std::span(*bytes))) : tl::unexpected(bytes.error());
}

}  // namespace facet::io
