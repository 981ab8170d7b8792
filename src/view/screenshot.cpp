#include "view/screenshot.hpp"

#include "frame/settings.hpp"
#include "io/picture_file.hpp"

namespace facet::view {

std::filesystem::path newName(const std::tm& time, const std::filesystem::path& folder, const std::string& ending) {
  char stem[64];
  std::strftime(stem, sizeof stem, "facet-%Y%m%d-%H%M%S", &time);
  std::filesystem::path path = folder / (stem + ending);
  std::error_code ignored;
  for (int i = 2; std::filesystem::exists(path, ignored); ++i)
    path = folder / (std::string(stem) + "-" + std::to_string(i) + ending);
  return path;
}

std::filesystem::path newNameHere(const std::string& ending) {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  std::error_code ignored;
  return newName(local, std::filesystem::current_path(ignored), ending);
}

Result<void> writeScreenshot(const std::filesystem::path& file, const frame::Targets& targets,
                             const frame::PictureSettings& settings, const frame::OverlayTargets* overlay) {
  constexpr int quality = 90;  // as of `facet render`
  const std::optional<io::PictureFormat> format = io::pictureFormat(file);
  if (!format || *format == io::PictureFormat::exr)
    return fail(file.string(), "", "is no name of a picture of what the screen shows",
                "end it in " + io::pictureEndings(false));
  const bool withAlpha = settings.frame.background == frame::Background::transparent;
  io::Pixels picture = frame::readDisplay(targets, withAlpha);
  if (overlay) frame::layOver(*overlay, 0, picture);
  return io::writePicture(file, *format, picture, quality);
}

}  // namespace facet::view
