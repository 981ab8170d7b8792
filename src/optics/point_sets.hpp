#pragma once

// Points of the unit square that integrals are summed over, from chance to the most even: what sampling is compared by.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "base/choice.hpp"

namespace facet::optics {

//   regular     the middles of a grid's cells
//   random      independent
//   stratified  one at a random place of each cell
//   halton      radical inverses in base 2 and 3 (Halton 1960)
//   sobol       dimensions 1 and 2 (Sobol 1967)
//   owen        the same, scrambled (sobol.hpp): what pictures are drawn with
enum class PointSet : uint8_t { regular, random, stratified, halton, sobol, owen };
inline constexpr Choice<PointSet> pointSets[] = {{PointSet::regular, "regular", "regular grid"},
                                                 {PointSet::random, "random", "random"},
                                                 {PointSet::stratified, "stratified", "stratified"},
                                                 {PointSet::halton, "halton", "Halton"},
                                                 {PointSet::sobol, "sobol", "Sobol"},
                                                 {PointSet::owen, "owen", "Owen-scrambled Sobol"}};
static_assert(inOrder(pointSets));

// The digits of i in that base behind the point, in reverse: [0, 1) (Halton 1960).
double radicalInverse(uint32_t i, uint32_t base);
// n points in [0, 1)^2; grids have 2^i x 2^j cells, as square as n = 2^(i + j) lets them be (other n: the next power of
// two, of which the first n are taken). seed: of chance; the points of regular, halton and sobol are the same under
// every seed.
std::vector<glm::dvec2> pointsOf(PointSet set, uint32_t n, uint32_t seed);
// All of them moved by a random vector modulo 1 (Cranley and Patterson 1976): sets without chance get some.
std::vector<glm::dvec2> shifted(std::vector<glm::dvec2> points, uint32_t seed);

// sup over boxes [0, x) x [0, y) of |share of the points within - x y|, exactly, by all boxes that points bound
// (Bundschuh and Zhu 1993): O(n^2).
double starDiscrepancy(std::vector<glm::dvec2> points);

}  // namespace facet::optics
