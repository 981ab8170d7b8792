#pragma once

// Numerical stability of the environment's tables and of what reads them: awkward maps, awkward places, and for each
// the number to expect. Part of `facet selftest`.

#include <vector>

#include "selftest/numerics.hpp"
#include "shading/programs.hpp"

namespace facet::selftest {

// Errors: a shader does not compile.
Result<std::vector<CheckResult>> tableCorners(shading::ProgramStore& programs, const shading::ShaderReader& reader);

}  // namespace facet::selftest
