#pragma once

// From where the picture is seen, as text (rows of picture_options.cpp).

#include <string>
#include <string_view>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::options {

Result<void> parseOrbit(std::string_view text, frame::PictureSettings& settings);
std::string writeOrbit(const frame::PictureSettings& settings);
Result<void> parseTarget(std::string_view text, frame::PictureSettings& settings);
std::string writeTarget(const frame::PictureSettings& settings);
Result<void> parseUp(std::string_view text, frame::PictureSettings& settings);
std::string writeUp(const frame::PictureSettings& settings);
Result<void> parseViewHeight(std::string_view text, frame::PictureSettings& settings);

}  // namespace facet::options
