#pragma once

// What is wrong with a glTF 2.0 file, by the letter: structure, references, meaning, data, images. It stands beside the
// reader (io/gltf.hpp), shares no state with it and runs for `facet inspect` and on wish alone: what can be shown is
// another question than what is right.

#include <filesystem>
#include <span>
#include <string>

#include "base/error.hpp"
#include "io/gltf.hpp"
#include "io/validate/findings.hpp"

namespace facet::io {

// A .gltf or .glb file, or "builtin:NAME". Errors: there is nothing to read.
Result<validate::Report> validateModel(const std::string& source, const Limits& limits = {});

// Files that it names are looked for below baseFolder (empty: none may be named).
validate::Report validateBytes(std::span<const uint8_t> bytes, const std::string& name,
                               const std::filesystem::path& baseFolder = {}, const Limits& limits = {});

}  // namespace facet::io
