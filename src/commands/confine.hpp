#pragma once

// What a picture needs of the file system, for commands that read what strangers wrote (base/sandbox.hpp).

#include <CLI/CLI.hpp>
#include <string>

#include "base/sandbox.hpp"
#include "frame/settings.hpp"

namespace facet::commands {

// The model's folder, or none of a built-in one; environment, measured BRDFs, height map, shaders.
void needPicture(Needed& needed, const std::string& model, const frame::PictureSettings& settings);
// The folder of a file that is written, also where it is a link.
void needOutput(Needed& needed, const std::filesystem::path& file);
// A folder that is written to; where it is not there yet, the nearest one above that is.
void needOutputFolder(Needed& needed, const std::filesystem::path& folder);

// A file, or a folder with what its links name: people say which pictures are compared.
void needFiles(Needed& needed, const std::filesystem::path& fileOrFolder);
// A measured BRDF by name or path; the folders where databases are looked for.
void needMeasured(Needed& needed, const std::string& source, const std::filesystem::path& brdfDir);

// --no-sandbox
void addNoSandbox(CLI::App& app, bool& noSandbox);

// Before the driver starts: it keeps its compiled shaders below facet's cache, apart from those of other programs,
// unless the environment says where.
void keepDriverCacheApart();

// Once the driver is at work and before the first byte of a model is read. ownCache: facet's caches are used.
Confined confine(Needed needed, bool ownCache);

}  // namespace facet::commands
