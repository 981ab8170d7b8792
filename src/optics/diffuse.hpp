#pragma once

namespace facet::optics {

// Lambert's BRDF for albedo 1 [1/sr], without the cosine: 1 / pi, so that the hemisphere returns all it gets.
double Fd_Lambert();

}  // namespace facet::optics
