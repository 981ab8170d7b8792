#pragma once

// Pages for man(1), in troff's man macros.

#include <span>
#include <string>

#include "commands/described.hpp"

namespace facet::commands {

// "facet-render"; "facet" of the program itself.
std::string manualName(const CommandText& command);

// The page of `command`, which is one of `all`; that of the nameless one lists the others.
std::string manualPage(const CommandText& command, std::span<const CommandText> all);

}  // namespace facet::commands
