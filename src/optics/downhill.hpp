#pragma once

#include <functional>
#include <vector>

namespace facet::optics {

// Where f is least, near a simplex of one corner more than it has unknowns. Nelder and Mead 1965 with the usual factors
// (1, 2, 1/2, 1/2); stops where the simplex is smaller than `tolerance`, or after `most` values of f.
std::vector<double> downhill(std::vector<std::vector<double>> simplex, double tolerance, int most,
                             const std::function<double(const std::vector<double>&)>& f);

}  // namespace facet::optics
