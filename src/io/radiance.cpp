#include "io/radiance.hpp"

#include "io/exr.hpp"
#include "io/hdr.hpp"
#include "io/safe_files.hpp"

namespace facet::io {

Result<RadianceImage> readRadiance(const std::filesystem::path& path, const Limits& limits) {
  const std::string name = path.string();
  try {
    const auto bytes = readRegularFile(path, limits.fileBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    if (isHdr(bytes->span())) return decodeHdr(bytes->span(), name, limits);
    if (isExr(bytes->span())) return decodeExr(bytes->span(), name, limits);
  } catch (const std::exception&) {
    return fail(name, "", "there is not enough memory for the picture", "use a smaller picture");
  }
  return fail(name, "", "is neither a Radiance (.hdr) nor an OpenEXR (.exr) picture", "convert it to one of them");
}

Result<scene::Environment> loadEnvironment(const std::filesystem::path& path, Notes& notes, const Limits& limits) {
  auto image = readRadiance(path, limits);
  if (!image) return tl::unexpected(image.error());
  if (static_cast<uint64_t>(std::max(image->width, image->height)) > limits.imageSide) {
    return fail(path.string(), "",
                "has " + std::to_string(image->width) + " x " + std::to_string(image->height) +
                    " pixels, and a side of " + std::to_string(limits.imageSide) + " is the most that can be shown",
                "use a smaller picture");
  }
  scene::Environment environment;
  environment.name = path.filename().string();
  environment.width = image->width;
  environment.height = image->height;
  try {
    environment.radiance.assign(image->pixels.begin(), image->pixels.end());  // drops alpha
  } catch (const std::exception&) {
    return fail(path.string(), "", "there is not enough memory for the picture", "use a smaller picture");
  }
  const auto note = [&](Note::Severity severity, std::string text) {
    notes.push_back({severity, environment.name, std::move(text)});
  };
  if (environment.width != 2 * environment.height) {
    note(Note::Severity::warning, "has " + std::to_string(environment.width) + " x " +
                                      std::to_string(environment.height) +
                                      " pixels and not twice as many across as down: stretched over the sphere");
  }
  mend(environment);
  const std::pair<uint64_t, const char*> mended[] = {
      {environment.nanTexels, "are not numbers: replaced by their neighbours"},
      {environment.infiniteTexels, "are infinite: replaced by the largest value"},
      {environment.negativeTexels, "are negative: replaced by zero"}};
  for (const auto& [count, what] : mended) {
    if (count > 0) note(Note::Severity::warning, std::to_string(count) + " texels " + what);
  }
  return environment;
}

}  // namespace facet::io
