#pragma once

// The measured BRDF in the materials' place: which of the databases, how it is looked up, what it holds.

#include "view/viewer_state.hpp"

namespace facet::view {

// What is to be told of the one that is shown.
std::vector<Detail> measuredDetails(const frame::MeasuredFacts& facts, optics::LookUp lookUp);

std::vector<Detail> fitDetails(const frame::FittedBrdf& fitted);

// Within the settings' material section.
void measuredChoice(ViewerState& state);

}  // namespace facet::view
