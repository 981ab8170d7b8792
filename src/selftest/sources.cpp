#include "selftest/sources.hpp"

namespace facet::selftest {

namespace {

#include "selftest/sources.inc"

}  // namespace

std::span<const optics::Sources> checkSources() { return sources; }

}  // namespace facet::selftest
