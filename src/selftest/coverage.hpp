#pragma once

// Which functions of the shaders the self-test holds against double precision, and why the others are left out.

#include "selftest/numerics.hpp"

namespace facet::selftest {

struct FunctionCoverage {
  std::string file, function;
  std::string check;     // the first that has it; empty: none
  bool through = false;  // not named by it, but by something that it calls
  std::string reason;    // of having none; empty: not known, which a test does not let pass
};

// Of every function, by file. A function that a check calls through others counts as held under whatever condition it
// is called: by the chunks' text, not by what their #ifs leave of it.
std::vector<FunctionCoverage> functionCoverage(const std::vector<Check>& checks, const shading::ShaderReader& reader);

// Rows of the list of those left out that are no longer functions, or are held now.
std::vector<std::string> staleExceptions(const std::vector<FunctionCoverage>& coverage);

}  // namespace facet::selftest
