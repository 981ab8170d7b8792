#include "support/gpu.hpp"

#include <cassert>

namespace facet::test {

namespace {
const gl::ContextInfo* info = nullptr;
}

void setContextInfo(const gl::ContextInfo* value) { info = value; }

const gl::ContextInfo& contextInfo() {
  assert(info);
  return *info;
}

shading::ProgramStore makeProgramStore() { return shading::ProgramStore(shading::shaderReader(), {}, ""); }

}  // namespace facet::test
