#pragma once

// What a picture needs of the file system, for commands that read what strangers wrote (base/sandbox.hpp).

#include <string>

#include "base/sandbox.hpp"
#include "frame/settings.hpp"

namespace facet::commands {

// The model's folder, or none of a built-in one; environment, measured BRDFs, height map, shaders.
void needPicture(Needed& needed, const std::string& model, const frame::PictureSettings& settings);
// The folder of a file that is written, also where it is a link.
void needOutput(Needed& needed, const std::filesystem::path& file);

// Before the driver starts: it keeps its compiled shaders below facet's cache, apart from those of other programs,
// unless the environment says where.
void keepDriverCacheApart();

// Once the driver is at work and before the first byte of a model is read. ownCache: facet's caches are used.
Confined confine(Needed needed, bool ownCache);

}  // namespace facet::commands
