#pragma once

#include <string_view>

namespace facet::log {

enum class Level { quiet, error, warning, info, debug };

// Lines go to standard error as "facet: warning: text". The level is the process's only mutable setting here.
void setLevel(Level level);
Level level();
void write(Level level, std::string_view text);
inline void error(std::string_view text) { write(Level::error, text); }
inline void warning(std::string_view text) { write(Level::warning, text); }
inline void info(std::string_view text) { write(Level::info, text); }
inline void debug(std::string_view text) { write(Level::debug, text); }

}  // namespace facet::log
