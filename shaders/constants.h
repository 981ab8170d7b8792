// Bounds that shaders and what checks them share, read by C++ and by GLSL alike.
#pragma once
#include "both_languages.h"

LAYOUT_BEGIN

// Smallest alpha of an analytic lobe lit by a point: D's peak is then 1 / (pi 1e-6) = 3.2e5, exact in 32 bit.
LAYOUT_FLOAT minAnalyticAlpha = 1e-3f;
// Smallest NoV that the visibility term and the tables get; interpolated normals may turn away from the viewer.
LAYOUT_FLOAT minNoV = 1e-4f;
LAYOUT_FLOAT maxHalf = 65504.0f;

LAYOUT_END
