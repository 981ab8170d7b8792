const float PI = 3.14159265358979;
// Smallest alpha of an analytic lobe lit by a point: D's peak is then 1 / (pi 1e-6) = 3.2e5, exact in 32 bit.
const float minAnalyticAlpha = 1e-3;
// Smallest NoV that the visibility term and the tables get; interpolated normals may turn away from the viewer.
const float minNoV = 1e-4;
const float maxHalf = 65504.0;
