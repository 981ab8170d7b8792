#pragma once

// Bytes that a file names.

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

// Of a data: URI or a file; kept by the asset. Nothing, and a finding, where they can't be had.
std::optional<std::span<const uint8_t>> readUri(Asset& asset, const std::string& uri, const std::string& place);

// "application/octet-stream" of "data:application/octet-stream;base64,AAAA"; text/plain where none is given (RFC 2397).
std::string mediaTypeOf(std::string_view dataUri);

// Of a buffer view; empty where they aren't there or compressed.
std::span<const uint8_t> bytesOf(const Asset& asset, int view);

}  // namespace facet::io::validate
