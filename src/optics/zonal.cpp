#include "optics/zonal.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "optics/lights.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

constexpr size_t degrees = 2600;  // the cube's own texels are resolved: degree 2600 is 0.0012 rad

// Mean squared edge of a cube's texels, rad^2.
double texelArea(int size) { return 4 * pi / 6 / size / size; }

// What bilinear look-ups add to the variance per axis, where points of a finer or coarser grid of the same cube read
// this one: they lie at texel centres, at their corners, at quarters, or anywhere.
double lookUpVariance(int from, int to) {
  const double h2 = texelArea(from);
  if (to == from) return 0;
  if (to < from) return h2 / 4;
  return to == 2 * from ? h2 * 3 / 16 : h2 / 6;
}

double gaussianCoefficient(double variance, size_t degree) {
  const auto l = static_cast<double>(degree);
  return std::exp(-0.5 * l * (l + 1) * variance);
}

// Angles, dense about the centre, with their share of the sphere.
struct FitAngles {
  std::vector<double> theta, weight;
};
FitAngles fitAngles() {
  constexpr int count = 320;
  FitAngles angles;
  for (int i = 0; i < count; ++i) {
    const double t = (i + 0.5) / count, theta = pi * t * t * t;
    angles.theta.push_back(theta);
    angles.weight.push_back(2 * pi * std::sin(theta) * 3 * pi * t * t / count);
  }
  return angles;
}

using Kernels = std::vector<std::vector<double>>;

// Values of every copy's kernel at the angles, as a layer of that size sees it.
Kernels copyKernels(const FitAngles& angles, int layerSize) {
  const std::vector<BlurredCopy> copies = blurredCopies();
  std::vector<std::vector<double>> filters;  // coefficients
  std::vector<double> filter(degrees);
  for (size_t l = 0; l < degrees; ++l) filter[l] = gaussianCoefficient(texelArea(copies[0].size) / 12, l);
  for (size_t i = 0; i < copies.size(); ++i) {
    if (i > 0) {
      const std::vector<double> blur = coefficients(copies[i].rings, degrees);
      for (size_t l = 0; l < degrees; ++l)
        filter[l] *= blur[l] * gaussianCoefficient(texelArea(copies[i - 1].size) / 6, l);
    }
    std::vector<double>& seen = filters.emplace_back(filter);
    const double variance = lookUpVariance(copies[i].size, layerSize);
    for (size_t l = 0; l < degrees; ++l)
      seen[l] *= gaussianCoefficient(variance, l) * (2 * static_cast<double>(l) + 1) / (4 * pi);
  }
  Kernels kernels(filters.size(), std::vector<double>(angles.theta.size(), 0));
  for (size_t a = 0; a < angles.theta.size(); ++a) {
    const std::vector<double> P = legendre(std::cos(angles.theta[a]), degrees);
    for (size_t i = 0; i < filters.size(); ++i)
      for (size_t l = 0; l < degrees; ++l) kernels[i][a] += filters[i][l] * P[l];
  }
  for (const double alpha : summedAlphas) {
    std::vector<double>& kernel = kernels.emplace_back();
    for (const double theta : angles.theta) kernel.push_back(prefilterKernel(alpha, theta));
  }
  return kernels;
}

// A map's texels under bilinear look-ups: a Gaussian of their variance.
std::vector<double> mapKernel(const FitAngles& angles, int mapWidth) {
  const double texel = 2 * pi / mapWidth, variance = texel * texel * (1.0 / 12 + 1.0 / 6);
  std::vector<double> kernel;
  for (const double theta : angles.theta)
    kernel.push_back(std::exp(-theta * theta / (2 * variance)) / (2 * pi * variance));
  return kernel;
}
Kernels backgroundKernels(const FitAngles& angles, int size, int mapWidth) {
  Kernels kernels = copyKernels(angles, size);
  kernels.push_back(mapKernel(angles, mapWidth));
  return kernels;
}

std::vector<double> fittedWeights(double alpha, const FitAngles& angles, const Kernels& kernels) {
  const size_t unknowns = kernels.size();
  std::vector<std::vector<double>> normal(unknowns, std::vector<double>(unknowns, 0));
  std::vector<double> right(unknowns, 0);
  const auto addRow = [&](const auto& value, double target, double weight) {
    for (size_t j = 0; j < unknowns; ++j) {
      for (size_t k = 0; k < unknowns; ++k) normal[j][k] += weight * value(j) * value(k);
      right[j] += weight * value(j) * target;
    }
  };
  const double floor = 1e-3 * prefilterKernel(alpha, 0) * alpha * alpha + 1e-4;
  for (size_t a = 0; a < angles.theta.size(); ++a) {
    const double target = prefilterKernel(alpha, angles.theta[a]);
    addRow([&](size_t j) { return kernels[j][a]; }, target, angles.weight[a] / (target + floor));
  }
  addRow([](size_t) { return 1.0; }, 1, 1);  // a constant map stays constant
  std::vector<double> weights(unknowns, 0);
  double change = 1;
  for (int sweep = 0; sweep < 200000 && change > 1e-12; ++sweep) {
    change = 0;
    for (size_t j = 0; j < unknowns; ++j) {
      double gradient = right[j];
      for (size_t k = 0; k < unknowns; ++k)
        if (k != j) gradient -= normal[j][k] * weights[k];
      const double before = std::exchange(weights[j], std::max(0.0, gradient / normal[j][j]));
      change = std::max(change, std::abs(weights[j] - before));
    }
  }
  double sum = 0;
  for (const double w : weights) sum += w;
  for (double& w : weights) w = w / sum < 1e-3 ? 0 : w;  // not worth a look-up
  sum = 0;
  for (const double w : weights) sum += w;
  for (double& w : weights) w /= sum;
  return weights;
}

MixtureError errorOf(double alpha, const FitAngles& angles, const Kernels& kernels,
                     const std::vector<double>& weights) {
  MixtureError error;
  double core = 0, scale = 0;
  for (size_t a = 0; a < angles.theta.size(); ++a) {
    double mixture = 0;
    for (size_t j = 0; j < weights.size(); ++j) mixture += weights[j] * kernels[j][a];
    const double kernel = prefilterKernel(alpha, angles.theta[a]);
    error.l1 += angles.weight[a] * std::abs(mixture - kernel);
    if (angles.theta[a] > 4 * alpha) continue;
    core += angles.weight[a] * (mixture - kernel) * (mixture - kernel);
    scale += angles.weight[a] * kernel * kernel;
  }
  error.core = std::sqrt(core / scale);
  return error;
}

}  // namespace

std::vector<double> legendre(double x, size_t count) {
  std::vector<double> P(std::max<size_t>(count, 2));
  P[0] = 1, P[1] = x;
  for (size_t l = 1; l + 1 < count; ++l) {
    const auto d = static_cast<double>(l);
    P[l + 1] = ((2 * d + 1) * x * P[l] - d * P[l - 1]) / (d + 1);
  }
  P.resize(count);
  return P;
}

double spreadCosine(double c, double variance) {
  const double halfWidth = std::sqrt(3 * variance);
  if (std::abs(c) >= halfWidth) return std::max(c, 0.0);
  const double above = c + halfWidth;
  return above * above / (4 * halfWidth);
}

double spreadZonalKernel(double c, double variance, double alpha) {
  const double y = (1 - c) / 2 + alpha * alpha * (1 + c) / 2;
  return spreadCosine(c, variance) / (y * y);
}

double prefilterKernel(double alpha, double theta) {
  // With x = sin^2(theta / 2), b = alpha^2, y = b + (1 - b) x: D NoL ~ (1 - 2x) / y^2, whose integral over x has a
  // closed form; towards b = 1 it cancels, and the kernel is the cosine there.
  const double b = alpha * alpha, k = 1 - b, x = std::pow(std::sin(theta / 2), 2);
  if (x >= 0.5) return 0;
  const double y = b + k * x;
  double integral = 0;
  if (k < 1e-3) {
    integral = 0.25 + 2 * k * (0.25 - 1.0 / 24);  // int (1 - 2x) (1 + 2k (1 - x)) to first order in k
  } else {
    const double end = b + k / 2;
    integral = ((1 + b) * (1 / b - 1 / end) - 2 * std::log(end / b)) / (k * k);
  }
  return (1 - 2 * x) / (y * y) / (4 * pi * integral);
}

std::vector<Ring> hexagonalBlur(double tau) {
  const double step = 1.15 * tau;
  std::vector<Ring> rings = {{0, 1, 1, 0}, {step, 6, 6, 0}, {step * std::sqrt(3.0), 6, 6, 0.5}, {2 * step, 6, 6, 0}};
  double total = 0;
  for (Ring& ring : rings) {
    ring.weight *= std::exp(-ring.angle * ring.angle / (2 * tau * tau));
    total += ring.weight;
  }
  for (Ring& ring : rings) ring.weight /= total;
  return rings;
}

std::vector<double> coefficients(const std::vector<Ring>& rings, size_t count) {
  std::vector<double> sum(count, 0);
  for (const Ring& ring : rings) {
    const std::vector<double> P = legendre(std::cos(ring.angle), count);
    for (size_t l = 0; l < count; ++l) sum[l] += ring.weight * P[l];
  }
  return sum;
}

std::vector<BlurredCopy> blurredCopies() {
  constexpr struct {
    double sigma;
    int size;
  } wanted[] = {{0.0065, 256}, {0.0092, 256}, {0.013, 128}, {0.0184, 128}, {0.026, 128}, {0.037, 64}, {0.052, 64},
                {0.074, 64},   {0.104, 32},   {0.147, 32},  {0.21, 32},    {0.3, 32},    {0.42, 32}};
  std::vector<BlurredCopy> copies = {{256, {}, std::sqrt(texelArea(256) / 12)}};
  for (const auto& [sigma, size] : wanted) {
    const BlurredCopy& from = copies.back();
    const double variance = from.sigma * from.sigma + texelArea(from.size) / 6;
    const std::vector<Ring> rings = hexagonalBlur(std::sqrt(sigma * sigma - variance));
    // The truncated grid is a little narrower than its Gaussian.
    const double made = variance - std::log(coefficients(rings, 2)[1]);
    copies.push_back({size, rings, std::sqrt(made)});
  }
  return copies;
}

std::vector<double> mixtureWeights(double alpha, int layerSize) {
  const FitAngles angles = fitAngles();
  return fittedWeights(alpha, angles, copyKernels(angles, layerSize));
}

std::vector<double> backgroundWeights(double alpha, int size, int mapWidth) {
  const FitAngles angles = fitAngles();
  Kernels kernels = backgroundKernels(angles, size, mapWidth);
  if (alpha > narrowestBlur(mapWidth)) return fittedWeights(alpha, angles, kernels);
  std::vector<double> weights(kernels.size(), 0);
  weights.back() = 1;
  return weights;
}

MixtureError mixtureError(double alpha, int layerSize, const std::vector<double>& weights) {
  const FitAngles angles = fitAngles();
  return errorOf(alpha, angles, copyKernels(angles, layerSize), weights);
}

MixtureError backgroundError(double alpha, int size, int mapWidth, const std::vector<double>& weights) {
  const FitAngles angles = fitAngles();
  return errorOf(alpha, angles, backgroundKernels(angles, size, mapWidth), weights);
}

double backgroundLightAlpha(double alpha, double share, double angularRadius) {
  return std::min(1.0, alphaOfDisc(alpha / std::sqrt(share), angularRadius));
}

}  // namespace facet::optics
