#pragma once

// A way of the camera: cameras as text (options/camera_text.hpp), a line each, "#" before remarks.

#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::options {

// At least two, each with --orbit; what else they say each of them says, and up axis and projection are the same in
// all. Errors name the line.
Result<std::vector<frame::Viewpoint>> parseCameraPath(std::string_view text, const std::string& name);

// At t in [0, 1]: the keys lie evenly, between them goes a Catmull-Rom spline; azimuths turn the shorter way, distances
// grow by factors.
frame::Viewpoint alongPath(const std::vector<frame::Viewpoint>& keys, double t);

}  // namespace facet::options
