#include "compare/flip.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/angle.hpp"
#include "base/parallel.hpp"

namespace facet::compare {

namespace {

// ---- Colours --------------------------------------------------------------------------------------------------------

// Rec. 709 primaries and D65 (IEC 61966-2-1), divided by white: (1, 1, 1) stays (1, 1, 1). Rows sum to 1.
const glm::dmat3& whiteRelativeXyz() {
  static const glm::dmat3 matrix = [] {
    const glm::dmat3 xyz = glm::transpose(glm::dmat3(0.4124564, 0.3575761, 0.1804375,  //
                                                     0.2126729, 0.7151522, 0.0721750,  //
                                                     0.0193339, 0.1191920, 0.9503041));
    const glm::dvec3 white = xyz * glm::dvec3(1);
    glm::dmat3 relative = xyz;
    for (int column = 0; column < 3; ++column) relative[column] /= white;
    return relative;
  }();
  return matrix;
}

const glm::dmat3& linearFromRelativeXyz() {
  static const glm::dmat3 matrix = glm::inverse(whiteRelativeXyz());
  return matrix;
}

// CIE 15: the cube root and the straight piece below (6/29)^3.
double lightnessCurve(double t) {
  constexpr double knee = 6.0 / 29;
  return t > knee * knee * knee ? std::cbrt(t) : t / (3 * knee * knee) + 4.0 / 29;
}

// Colours seem less saturated in the dark (Hunt 1952): a and b times L / 100.
glm::dvec3 huntAdjusted(const glm::dvec3& lab) { return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z}; }

// Abasi, Tehran, Fairchild 2019: city block between lightness and chroma, which suits large differences.
double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

// The paper's q_c, p_c, p_t.
constexpr double colorExponent = 0.7, smallShare = 0.4, smallRange = 0.95;

double poweredHyab(const glm::dvec3& a, const glm::dvec3& b) { return std::pow(hyab(a, b), colorExponent); }

// Green against blue: no pair of the gamut is further apart.
double largestDifference() {
  static const double largest =
      poweredHyab(huntAdjusted(labFromLinear({0, 1, 0})), huntAdjusted(labFromLinear({0, 0, 1})));
  return largest;
}

double huntDifference(const glm::dvec3& a, const glm::dvec3& b) {
  const double difference = poweredHyab(a, b), largest = largestDifference(), knee = smallShare * largest;
  if (difference < knee) return smallRange / knee * difference;
  return std::min(1.0, smallRange + (difference - knee) / (largest - knee) * (1 - smallRange));
}

// ---- Filters --------------------------------------------------------------------------------------------------------

template <class Weight>
std::vector<double> kernel(int radius, Weight weight) {
  std::vector<double> weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(weight(x));
  return weights;
}

double sum(const std::vector<double>& weights) {
  double s = 0;
  for (const double w : weights) s += w;
  return s;
}

// Positive weights sum to 1, negative ones to -1.
std::vector<double> balanced(std::vector<double> weights) {
  double positive = 0, negative = 0;
  for (const double w : weights) (w > 0 ? positive : negative) += w;
  for (double& w : weights) w /= w > 0 ? positive : -negative;
  return weights;
}

// The paper's table 1: sensitivity a exp(-b f^2) at f cycles per degree, which in space is a Gaussian of variance
// b / (2 pi^2) and height a sqrt(pi / b).
struct Sensitivity {
  double a, b;
};

std::vector<FlipKernels::Gaussian> channel(std::initializer_list<Sensitivity> terms, int radius, double ppd) {
  std::vector<FlipKernels::Gaussian> gaussians;
  double total = 0;
  for (const Sensitivity& term : terms) {
    FlipKernels::Gaussian g;
    g.weights = kernel(radius, [&](int x) { return std::exp(-pi * pi * x * x / (ppd * ppd * term.b)); });
    const double mass = sum(g.weights);
    for (double& w : g.weights) w /= mass;
    total += g.share = term.a * std::sqrt(pi / term.b) * mass * mass;
    gaussians.push_back(std::move(g));
  }
  for (FlipKernels::Gaussian& g : gaussians) g.share /= total;
  return gaussians;
}

// A picture of one number a pixel.
struct Plane {
  int width = 0, height = 0;
  std::vector<double> values;

  Plane(int w, int h) : width(w), height(h), values(static_cast<size_t>(w) * static_cast<size_t>(h)) {}
};

// result += share * (picture filtered by `alongX`, then `alongY`); both kernels are of one radius.
void addFiltered(Plane& result, const Plane& picture, double share, const std::vector<double>& alongX,
                 const std::vector<double>& alongY) {
  assert(alongX.size() == alongY.size());
  const int radius = static_cast<int>(alongX.size()) / 2, width = picture.width, height = picture.height;
  const auto w = static_cast<size_t>(width);
  Plane rows(width, height);
  parallelFor(static_cast<size_t>(height), [&](size_t y) {
    const double* from = &picture.values[y * w];
    for (int x = 0; x < width; ++x) {
      double s = 0;
      for (int k = -radius; k <= radius; ++k)
        s += alongX[static_cast<size_t>(k + radius)] * from[std::clamp(x + k, 0, width - 1)];
      rows.values[y * w + static_cast<size_t>(x)] = s;
    }
  });
  parallelFor(static_cast<size_t>(height), [&](size_t y) {
    for (int k = -radius; k <= radius; ++k) {
      const double weight = share * alongY[static_cast<size_t>(k + radius)];
      const auto row = static_cast<size_t>(std::clamp(static_cast<int>(y) + k, 0, height - 1));
      for (size_t x = 0; x < w; ++x) result.values[y * w + x] += weight * rows.values[row * w + x];
    }
  });
}

Plane filtered(const Plane& picture, const std::vector<FlipKernels::Gaussian>& gaussians) {
  Plane result(picture.width, picture.height);
  for (const FlipKernels::Gaussian& g : gaussians) addFiltered(result, picture, g.share, g.weights, g.weights);
  return result;
}

// Lengths of the two derivatives of the picture.
Plane featureStrength(const Plane& luminance, const std::vector<double>& derivative,
                      const std::vector<double>& smooth) {
  Plane x(luminance.width, luminance.height), y = x;
  addFiltered(x, luminance, 1, derivative, smooth);
  addFiltered(y, luminance, 1, smooth, derivative);
  for (size_t i = 0; i < x.values.size(); ++i) x.values[i] = std::hypot(x.values[i], y.values[i]);
  return x;
}

// What the difference is computed of.
struct Seen {
  std::vector<glm::dvec3> colors;  // Hunt-adjusted CIELAB of what the eye resolves
  Plane edges, points;
};

Seen see(std::span<const glm::dvec3> linear, int width, int height, const FlipKernels& kernels) {
  Plane y(width, height), cx = y, cz = y, luminance = y;
  for (size_t i = 0; i < linear.size(); ++i) {
    const glm::dvec3 c = ycxczFromLinear(glm::clamp(linear[i], 0.0, 1.0));
    y.values[i] = c.x, cx.values[i] = c.y, cz.values[i] = c.z;
    luminance.values[i] = (c.x + 16) / 116;
  }
  y = filtered(y, kernels.achromatic);
  cx = filtered(cx, kernels.redGreen);
  cz = filtered(cz, kernels.blueYellow);
  std::vector<glm::dvec3> colors(linear.size());
  for (size_t i = 0; i < colors.size(); ++i) {
    const glm::dvec3 rgb = linearFromYcxcz({y.values[i], cx.values[i], cz.values[i]});
    colors[i] = huntAdjusted(labFromLinear(glm::clamp(rgb, 0.0, 1.0)));
  }
  return {std::move(colors), featureStrength(luminance, kernels.edge, kernels.smooth),
          featureStrength(luminance, kernels.point, kernels.smooth)};
}

}  // namespace

glm::dvec3 ycxczFromLinear(const glm::dvec3& linear) {
  const glm::dvec3 xyz = whiteRelativeXyz() * linear;
  return {116 * xyz.y - 16, 500 * (xyz.x - xyz.y), 200 * (xyz.y - xyz.z)};
}

glm::dvec3 linearFromYcxcz(const glm::dvec3& ycxcz) {
  const double y = (ycxcz.x + 16) / 116;
  return linearFromRelativeXyz() * glm::dvec3(y + ycxcz.y / 500, y, y - ycxcz.z / 200);
}

glm::dvec3 labFromLinear(const glm::dvec3& linear) {
  const glm::dvec3 xyz = whiteRelativeXyz() * linear;
  const double x = lightnessCurve(xyz.x), y = lightnessCurve(xyz.y), z = lightnessCurve(xyz.z);
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

double flipColorDifference(const glm::dvec3& a, const glm::dvec3& b) {
  return huntDifference(huntAdjusted(labFromLinear(a)), huntAdjusted(labFromLinear(b)));
}

FlipKernels flipKernels(double pixelsPerDegree) {
  const double ppd = pixelsPerDegree;
  constexpr double widest = 0.04;  // b; three standard deviations of it hold every filter
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * ppd));
  FlipKernels kernels;
  kernels.achromatic = channel({{1, 0.0047}}, radius, ppd);
  kernels.redGreen = channel({{1, 0.0053}}, radius, ppd);
  kernels.blueYellow = channel({{34.1, 0.04}, {13.5, 0.025}}, radius, ppd);

  // Half of 0.082 degrees, the width of the edge detectors of the eye.
  const double deviation = 0.5 * 0.082 * ppd;
  const int featureRadius = static_cast<int>(std::ceil(3 * deviation));
  const auto gaussian = [&](int x) { return std::exp(-x * x / (2 * deviation * deviation)); };
  kernels.smooth = kernel(featureRadius, gaussian);
  const double mass = sum(kernels.smooth);
  for (double& w : kernels.smooth) w /= mass;
  kernels.edge = balanced(kernel(featureRadius, [&](int x) { return -x * gaussian(x); }));
  kernels.point =
      balanced(kernel(featureRadius, [&](int x) { return (x * x / (deviation * deviation) - 1) * gaussian(x); }));
  return kernels;
}

std::vector<float> flipMap(std::span<const glm::dvec3> reference, std::span<const glm::dvec3> picture, int width,
                           int height, double pixelsPerDegree) {
  assert(reference.size() == static_cast<size_t>(width) * static_cast<size_t>(height));
  assert(picture.size() == reference.size());
  const FlipKernels kernels = flipKernels(pixelsPerDegree);
  const Seen a = see(reference, width, height, kernels), b = see(picture, width, height, kernels);
  constexpr double featureExponent = 0.5;  // q_f
  std::vector<float> map(reference.size());
  for (size_t i = 0; i < map.size(); ++i) {
    const double color = huntDifference(a.colors[i], b.colors[i]);
    const double edges = std::abs(a.edges.values[i] - b.edges.values[i]);
    const double points = std::abs(a.points.values[i] - b.points.values[i]);
    const double feature = std::min(1.0, std::pow(std::max(edges, points) / std::sqrt(2.0), featureExponent));
    // Nothing is raised to nothing: equal colours differ by 0 whatever the features say.
    map[i] = color <= 0 ? 0.0f : static_cast<float>(std::pow(color, 1 - feature));
  }
  return map;
}

}  // namespace facet::compare
