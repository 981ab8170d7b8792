#pragma once

// Compiled shaders and light tables of this user, kept on disk.

#include <string>

#include "gl/context.hpp"
#include "ibl/cache.hpp"
#include "shading/programs.hpp"

namespace facet::frame {

// shaderDir: empty: the embedded shaders.
shading::ProgramStore userPrograms(const gl::ContextInfo& context, const std::string& shaderDir, bool diskCache);

// None where the shaders are the user's, which may make other tables.
ibl::TableCache userTables(const gl::ContextInfo& context, const std::string& shaderDir, bool diskCache);

}  // namespace facet::frame
