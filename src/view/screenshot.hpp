#pragma once

#include <ctime>
#include <filesystem>
#include <string>

#include "frame/frame.hpp"
#include "frame/overlay.hpp"

namespace facet::view {

// facet-YYYYMMDD-HHMMSS with the ending, or with -2, -3, ... where there is such a file in the folder already.
std::filesystem::path newName(const std::tm& time, const std::filesystem::path& folder, const std::string& ending);
// The same of now, in the working directory.
std::filesystem::path newNameHere(const std::string& ending);

// The picture in the targets, without the panel, in the format that the name says. Waits for the GPU.
// overlay: lines over the picture, or null.
Result<void> writeScreenshot(const std::filesystem::path& file, const frame::Targets& targets,
                             const frame::PictureSettings& settings, const frame::OverlayTargets* overlay = nullptr);

}  // namespace facet::view
