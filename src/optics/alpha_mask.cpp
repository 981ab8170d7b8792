#include "optics/alpha_mask.hpp"

#include <algorithm>

namespace facet::optics {

double maskPivot(double threshold) { return std::clamp(threshold, 0.1, 0.9); }

double maskAlpha(double share, double pivot) {
  return share < 0.5 ? 2 * share * pivot : pivot + (2 * share - 1) * (1 - pivot);
}

}  // namespace facet::optics
