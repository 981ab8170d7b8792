#pragma once

// Catch2 3 by the names of Catch2 2, which the tests use: this folder is searched where 3 is installed.

#include <catch2/catch_all.hpp>

namespace Catch {
using Matchers::EndsWith;
using Matchers::StartsWith;
inline auto Contains(const std::string& text) { return Matchers::ContainsSubstring(text); }
}  // namespace Catch

using Catch::Approx;
