#pragma once

// Methods for the environment's tables by the error that they may have: the cheapest of those that were measured.

#include <span>
#include <string_view>
#include <vector>

#include "ibl/method.hpp"

namespace facet::ibl {

enum class Part { irradiance, layers, dfg };

// error: of an irradiance map and of layers (all of them from roughness 0.1 on) the relative RMSE over the sphere, a
// tenth of the map's mean added to what is divided by, the sun apart; of the DFG table the largest relative error of a
// dielectric's albedo (0.04 A + B). Each is the worst of three synthetic environments and eight photographed ones;
// `facet report methods [--env E]` measures anew. The adaptive cut is not among them: it takes ten times the mixture's
// time and serves as a reference.
struct Candidate {
  Part part;
  std::string_view name;
  Method method;  // of the part; the rest is the default
  double error;
};
std::span<const Candidate> candidates();  // of each part the cheapest first

// The cheapest candidate of the part whose error is within; the most accurate where none is.
const Candidate& choose(Part part, double maxError);
// What is chosen of each part.
std::vector<const Candidate*> chosenFor(double maxError);
// All of them in one. Without an error to keep to, Method{} is used: within 1 %, and its DFG table finer, because
// a white furnace shows its error at once.
Method methodFor(double maxError);

}  // namespace facet::ibl
