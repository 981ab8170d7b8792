#pragma once

// What is changed of a model without changing its file, as text (rows of picture_options.cpp).

#include <glm/glm.hpp>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::options {

// "X,Y,Z" within [-most, most].
Result<glm::dvec3> parseVector(std::string_view text, double most, std::string_view what, std::string_view example);
std::string writeVector(const glm::dvec3& vector);

Result<void> parseSet(std::string_view text, frame::PictureSettings& settings);
std::string writeSet(const frame::PictureSettings& settings);
Result<void> parseMaterialSet(std::string_view text, frame::PictureSettings& settings);
std::string writeMaterialSet(const frame::PictureSettings& settings);
Result<void> parseOnly(std::string_view text, frame::PictureSettings& settings);
std::string writeOnly(const frame::PictureSettings& settings);
Result<void> parseRotation(std::string_view text, frame::PictureSettings& settings);
std::string writeRotation(const frame::PictureSettings& settings);
Result<void> parsePosition(std::string_view text, frame::PictureSettings& settings);
std::string writePosition(const frame::PictureSettings& settings);
Result<void> parseScale(std::string_view text, frame::PictureSettings& settings);
std::string writeScale(const frame::PictureSettings& settings);

}  // namespace facet::options
