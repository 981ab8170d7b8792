#pragma once

#include <functional>
#include <string>

#include "base/text.hpp"

namespace facet::commands {

// For CLI's checks, whose own ranges let NaN pass: what is wrong with the text; empty where nothing is.
inline std::function<std::string(const std::string&)> numberIn(double min, double max) {
  return [min, max](const std::string& text) {
    const Result<double> value = parseNumber(text, min, max);
    return value ? std::string() : value.error().problem + "; " + value.error().remedy;
  };
}

}  // namespace facet::commands
