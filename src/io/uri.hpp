#pragma once

// URIs as glTF uses them: relative references, percent-encoded, and data: URIs (RFC 3986, RFC 2397).

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace facet::io {

// "%41" -> "A". A per cent sign without two hexadecimal digits stays as it is.
std::string percentDecode(std::string_view uri);

bool isDataUri(std::string_view uri);

// "http:", "file:", "C:" and so on.
bool hasScheme(std::string_view uri);

// The bytes of a data: URI; nothing if it is malformed. White space and missing padding in base64 are forgiven.
std::optional<std::vector<uint8_t>> decodeDataUri(std::string_view uri);

// In quotation marks for a message: at most 80 bytes, control characters replaced.
std::string inQuotes(std::string_view text);

}  // namespace facet::io
