#pragma once

#include "gl/context.hpp"
#include "shading/programs.hpp"

namespace facet::test {

void setContextInfo(const gl::ContextInfo* info);
const gl::ContextInfo& contextInfo();

// Without a disk cache, so that every test compiles what it asks for.
shading::ProgramStore makeProgramStore();

}  // namespace facet::test
