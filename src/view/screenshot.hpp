#pragma once

#include <ctime>
#include <filesystem>
#include <string>

#include "frame/frame.hpp"

namespace facet::view {

// facet-YYYYMMDD-HHMMSS.png, or with -2, -3, ... where there is such a file in the folder already.
std::filesystem::path screenshotName(const std::tm& time, const std::filesystem::path& folder);

// The picture in the targets, without the panel, into the working directory; its name. Waits for the GPU.
Result<std::string> writeScreenshot(const frame::Targets& targets, const frame::PictureSettings& settings);

}  // namespace facet::view
