#pragma once

// Small files of every kind, made here: what the fuzzers start from.

#include <initializer_list>
#include <string_view>

#include "fuzz/targets.hpp"

namespace facet::fuzz {

Bytes bytesOf(std::string_view text);
Bytes ramp(size_t count, size_t step = 37);
std::vector<Bytes> texts(std::initializer_list<std::string_view> all);

std::vector<Bytes> gltfSeeds();
std::vector<Bytes> lightsSeeds();
std::vector<Bytes> iesSeeds();
std::vector<Bytes> glbSeeds();
std::vector<Bytes> jsonSeeds();
std::vector<Bytes> uriSeeds();
std::vector<Bytes> pngSeeds();
std::vector<Bytes> jpegSeeds();
std::vector<Bytes> webpSeeds();
std::vector<Bytes> avifSeeds();
std::vector<Bytes> ktx2Seeds();
std::vector<Bytes> hdrSeeds();
std::vector<Bytes> exrSeeds();
std::vector<Bytes> merlSeeds();
std::vector<Bytes> utiaSeeds();
std::vector<Bytes> dracoSeeds();
std::vector<Bytes> meshoptSeeds();
std::vector<Bytes> suiteSeeds();
std::vector<Bytes> jobsSeeds();
std::vector<Bytes> sweepSeeds();
std::vector<Bytes> anglesSeeds();
std::vector<Bytes> reportSeeds();
std::vector<Bytes> preferencesSeeds();
std::vector<Bytes> keysSeeds();
std::vector<Bytes> cacheSeeds();

}  // namespace facet::fuzz
