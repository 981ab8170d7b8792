#include "ibl/choice.hpp"

#include <algorithm>

namespace facet::ibl {

namespace {

constexpr Candidate table[] = {
    {Part::irradiance, "summed over 8 x 8 at 8 x 8", {.sumSize = 8, .irradianceSize = 8}, 0.064},
    {Part::irradiance, "summed over 16 x 16 at 8 x 8", {.sumSize = 16, .irradianceSize = 8}, 0.057},
    {Part::irradiance, "summed over 16 x 16 at 16 x 16", {.sumSize = 16, .irradianceSize = 16}, 0.019},
    {Part::irradiance, "summed over 16 x 16 at 32 x 32", {.sumSize = 16, .irradianceSize = 32}, 0.0070},
    {Part::irradiance, "summed over 32 x 32 at 32 x 32", {.sumSize = 32, .irradianceSize = 32}, 0.0036},
    {Part::irradiance, "summed over 64 x 64 at 32 x 32", {.sumSize = 64, .irradianceSize = 32}, 0.0024},
    {Part::layers, "16 filtered samples", {.ld = LdMethod::filtered, .samples = 16}, 0.41},
    {Part::layers, "mixture, summed over 8 x 8", {.sumSize = 8}, 0.012},
    {Part::layers, "mixture, summed over 16 x 16", {.sumSize = 16}, 0.0086},
    {Part::layers, "mixture, summed over 32 x 32", {.sumSize = 32}, 0.0080},
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

Method methodFor(double maxError) {
  const Method& irradiance = choose(Part::irradiance, maxError).method;
  Method method = choose(Part::layers, maxError).method;
  method.sumSize = std::max(method.sumSize, irradiance.sumSize);
  method.irradianceSize = irradiance.irradianceSize;
  method.dfgSize = choose(Part::dfg, maxError).method.dfgSize;
  return method;
}

}  // namespace facet::ibl
