#include "io/radiance.hpp"

#include <cmath>
#include <cstdio>

#include "io/exr.hpp"
#include "io/hdr.hpp"
#include "io/safe_files.hpp"

namespace facet::io {

Result<RadianceImage> readRadiance(const std::filesystem::path& path, const Limits& limits, const std::string& layer) {
  const std::string name = path.string();
  try {
    const auto bytes = readRegularFile(path, limits.fileBytes);
    if (!bytes) return tl::unexpected(bytes.error());
    if (isExr(bytes->span())) return decodeExr(bytes->span(), name, limits, layer);
    if (isHdr(bytes->span())) {
      if (!layer.empty()) return fail(name, "", "a Radiance picture has no layers", "leave the layer's name out");
      return decodeHdr(bytes->span(), name, limits);
    }
  } catch (const std::exception&) {
    return fail(name, "", "there is not enough memory for the picture", "use a smaller picture");
  }
  return fail(name, "", "is neither a Radiance (.hdr) nor an OpenEXR (.exr) picture", "convert it to one of them");
}

void toRec709(RadianceImage& image, const optics::Chromaticities& primaries) {
  if (optics::isRec709(primaries)) return;
  const auto text = [](const glm::dvec2& c) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.4g, %.4g", c.x, c.y);
    return std::string(buffer);
  };
  const std::string what = "the primaries " + text(primaries.red) + "; " + text(primaries.green) + "; " +
                           text(primaries.blue) + " and the white " + text(primaries.white);
  const auto matrix = optics::rec709FromRgb(primaries);
  if (!matrix) {
    image.notes.push_back({Note::Severity::warning, "", what + " span no colours: taken for those of Rec. 709"});
    return;
  }
  image.notes.push_back({Note::Severity::info, "", "converted to Rec. 709 from " + what});
  applyColorMatrix(image, *matrix);
}

void applyColorMatrix(RadianceImage& image, const glm::dmat3& matrix) {
  for (glm::vec4& pixel : image.pixels) {
    const glm::dvec3 rgb = matrix * glm::dvec3(pixel);
    if (std::isfinite(rgb.x) && std::isfinite(rgb.y) && std::isfinite(rgb.z))
      pixel = glm::vec4(glm::vec3(rgb), pixel.w);
  }
}

Result<scene::Environment> loadEnvironment(const std::filesystem::path& path, Notes& notes, const Limits& limits,
                                           const std::string& layer) {
  auto image = readRadiance(path, limits, layer);
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
  for (Note& said : image->notes) note(said.severity, std::move(said.text));
  if (environment.width != 2 * environment.height) {
    note(Note::Severity::warning, "has " + std::to_string(environment.width) + " x " +
                                      std::to_string(environment.height) +
                                      " pixels and not twice as many across as down: stretched over the sphere");
  }
  scene::mend(environment);
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
