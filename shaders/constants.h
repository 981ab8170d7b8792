// Bounds that shaders and what checks them share, read by C++ and by GLSL alike.
#ifdef __cplusplus
#pragma once

namespace facet::layout {
#define SHARED_FLOAT inline constexpr float
#else
#define SHARED_FLOAT const float
#endif

// Smallest alpha of an analytic lobe lit by a point: D's peak is then 1 / (pi 1e-6) = 3.2e5, exact in 32 bit.
SHARED_FLOAT minAnalyticAlpha = 1e-3f;
// Smallest NoV that the visibility term and the tables get; interpolated normals may turn away from the viewer.
SHARED_FLOAT minNoV = 1e-4f;
SHARED_FLOAT maxHalf = 65504.0f;

#ifdef __cplusplus
#undef SHARED_FLOAT
}  // namespace facet::layout
#endif
