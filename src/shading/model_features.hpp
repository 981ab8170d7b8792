#pragma once

// Which of the models that may be chosen (optics::Models) a variant has, and how its shader is told.

#include "shading/features.hpp"

namespace facet::shading {

// Those that the draw can show; the key's features and samples are set.
void setModels(const FeatureInput& input, VariantKey& key);

void addModelDefines(const VariantKey& key, std::vector<Define>& defines);
void addModelNames(const VariantKey& key, std::string& name);  // those other than the default, after commas

}  // namespace facet::shading
