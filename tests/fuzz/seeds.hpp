#pragma once

// Small files of every kind, made here: what the fuzzers start from.

#include "fuzz/targets.hpp"

namespace facet::fuzz {

std::vector<Bytes> gltfSeeds();
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
