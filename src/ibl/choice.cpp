#include "ibl/choice.hpp"

#include <algorithm>

namespace facet::ibl {

namespace {

constexpr Candidate table[] = {
    {Part::irradiance, "8 x 8 cells at 8 x 8", {.sumSize = 8, .irradianceSize = 8}, 0.054},
    {Part::irradiance, "8 x 8 cells at 16 x 16", {.sumSize = 8, .irradianceSize = 16}, 0.015},
    {Part::irradiance, "8 x 8 cells at 32 x 32", {.sumSize = 8, .irradianceSize = 32}, 0.0064},
    {Part::irradiance, "16 x 16 cells at 32 x 32", {.sumSize = 16, .irradianceSize = 32}, 0.0024},
    {Part::irradiance, "16 x 16 cells at 64 x 64", {.sumSize = 16, .irradianceSize = 64}, 0.0012},
    {Part::layers, "16 filtered samples", {.ld = LdMethod::filtered, .samples = 16}, 0.41},
    {Part::layers, "mixture, 4 x 4 cells", {.sumSize = 4}, 0.0083},
    {Part::layers, "mixture, 8 x 8 cells", {.sumSize = 8}, 0.0079},
    {Part::dfg, "16 x 16", {.dfgSize = 16}, 0.031},
    {Part::dfg, "32 x 32", {.dfgSize = 32}, 0.0075},
    {Part::dfg, "64 x 64", {.dfgSize = 64}, 0.0027},
};

}  // namespace

std::span<const Candidate> candidates() { return table; }

const Candidate& choose(Part part, double maxError) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : table) {
    if (candidate.part != part) continue;
    if (candidate.error <= maxError) return candidate;
    if (!best || candidate.error < best->error) best = &candidate;
  }
  return *best;
}

std::vector<const Candidate*> chosenFor(double maxError) {
  return {&choose(Part::irradiance, maxError), &choose(Part::layers, maxError), &choose(Part::dfg, maxError)};
}

Method methodFor(double maxError) {
  const Method& irradiance = choose(Part::irradiance, maxError).method;
  Method method = choose(Part::layers, maxError).method;
  method.sumSize = std::max(method.sumSize, irradiance.sumSize);
  method.irradianceSize = irradiance.irradianceSize;
  method.dfgSize = choose(Part::dfg, maxError).method.dfgSize;
  return method;
}

}  // namespace facet::ibl
