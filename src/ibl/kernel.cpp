#include "ibl/kernel.hpp"

#include <cmath>

#include "base/angle.hpp"

namespace facet::ibl {

namespace {

// With x = sin^2(theta_h) = (1 - NoL) / 2 the kernel's density in x is g(x) = b (1 - 2x) / (b + k x)^2, b = alpha^2,
// k = 1 - b; integrated from 0 (substituting y = b + k x).
double density(double b, double x) {
  const double y = b + (1 - b) * x;
  return b * (1 - 2 * x) / (y * y);
}

double integral(double b, double x) {
  const double k = 1 - b;
  if (k < 0.02) {
    // Towards the cosine lobe (k = 0) the closed form cancels like 1 / k^2: 1 / y^2 as a series in q t, q = k / b,
    // whose terms are below 0.011^n.
    double sum = 0, power = x / b;
    for (int n = 0; n < 9; ++n, power *= -k / b * x) sum += power * (1 - 2 * x * (n + 1) / (n + 2));
    return sum;
  }
  const double y = b + k * x;
  return b / (k * k) * ((1 + b) * (1 / b - 1 / y) - 2 * std::log(y / b));
}

}  // namespace

double kernelShare(double alpha, double mu) {
  const double b = alpha * alpha;
  return integral(b, (1 - mu) / 2) / integral(b, 0.5);
}

std::vector<KernelSample> kernelSamples(double alpha, int count, int faceSize) {
  if (alpha <= 0) return {{glm::dvec3(0, 0, 1), 0}};
  const double b = alpha * alpha;
  const double total = integral(b, 0.5);
  const double goldenAngle = pi * (3 - std::sqrt(5.0));
  const double texel = 4 * pi / (6.0 * faceSize * faceSize);
  std::vector<KernelSample> samples;
  for (int i = 0; i < count; ++i) {
    const double target = (i + 0.5) / count * total;
    double low = 0, high = 0.5;
    for (int step = 0; step < 80; ++step) {
      const double middle = (low + high) / 2;
      (integral(b, middle) < target ? low : high) = middle;
    }
    const double x = (low + high) / 2;
    const double mu = 1 - 2 * x;
    const double sine = 2 * std::sqrt(x * (1 - x));
    const double phi = i * goldenAngle;
    const double pdf = density(b, x) / (total * 4 * pi);  // dw = 2 pi d(mu) = 4 pi dx
    const double share = 1 / (count * pdf);               // steradians
    samples.push_back(
        {{sine * std::cos(phi), sine * std::sin(phi), mu}, std::max(0.0, 0.5 * std::log2(share / texel))});
  }
  return samples;
}

}  // namespace facet::ibl
