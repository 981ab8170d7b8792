#include "optics/diffuse.hpp"

#include "optics/microfacet.hpp"

namespace facet::optics {

double Fd_Lambert() { return 1 / pi; }

}  // namespace facet::optics
