#include "view/screenshot.hpp"

#include "frame/settings.hpp"
#include "io/image.hpp"

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

Result<std::string> writeScreenshot(const frame::Targets& targets, const frame::PictureSettings& settings,
                                    const frame::OverlayTargets* overlay) {
  const std::string name = newNameHere(".png").string();
  const bool withAlpha = settings.frame.background == frame::Background::transparent;
  io::Pixels picture = frame::readDisplay(targets, withAlpha);
  if (overlay) frame::layOver(*overlay, 0, picture);
  if (Result<void> written = io::writePng(name, picture); !written) return tl::unexpected(written.error());
  return name;
}

}  // namespace facet::view
