#pragma once

// How a masked texture's smaller levels tell which share of their area passes the alpha test (shaders/alpha_mask.glsl).

namespace facet::optics {

// Alpha that stands for a half. threshold: least alpha of a texel that passes, > 0; the pivot is that, but away from 0
// and 1, where 8 bits would hold too few shares.
double maskPivot(double threshold);
// Alpha that stands for a share of the area, [0, 1]: 0 for none of it, 1 for all, linear on either side of the pivot.
double maskAlpha(double share, double pivot);

}  // namespace facet::optics
