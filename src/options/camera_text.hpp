#pragma once

// A camera as text: the options of a command that say from where the picture is seen. For people to copy, paste and
// keep.

#include <string>
#include <string_view>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::options {

// "--orbit 30,75,2 --target 0,0,0 --up z", quoted for a shell; empty: what is usual.
std::string cameraText(const frame::Viewpoint& viewpoint);

// Of a text like that, or of a whole command that has such options among others, which are passed over. Errors: none of
// them, a value that is wrong, a quote that does not end.
Result<frame::Viewpoint> viewpointOf(std::string_view text);

}  // namespace facet::options
