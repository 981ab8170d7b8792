#include "optics/measured_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "base/parallel.hpp"
#include "optics/anisotropy.hpp"
#include "optics/fresnel.hpp"
#include "optics/models.hpp"

namespace facet::optics {

namespace {

constexpr double smallestRootArgument = 1e-6;
constexpr double smallestFitAlpha = 1e-4;

double compressed(double x, FitMetric metric) {
  return metric == FitMetric::log ? std::log1p(x) : std::cbrt(std::max(x, smallestRootArgument));
}
double slope(double x, FitMetric metric) {
  if (metric == FitMetric::log) return 1 / (1 + x);
  const double root = std::cbrt(std::max(x, smallestRootArgument));
  return 1 / (3 * root * root);
}

// What the model's lobe and diffuse part are at each sample, so that f = f0 linear + constant + diffuse(albedo).
struct Basis {
  std::vector<double> linear, constant, diffuse;  // diffuse: for albedo 1
};

double lobeValue(const AnalyticBrdf& model, const FitSample& sample) {
  const Angles& a = sample.angles;
  if (model.alpha.t == model.alpha.b)
    return D_GGX(a, model.alpha.t) * V_SmithGGXCorrelated(a.NoV, a.NoL, model.alpha.t);
  return D_GGXAnisotropic(turned(a.H, model.phi), model.alpha) *
         V_GGXAnisotropic(turned(sample.V, model.phi), turned(sample.L, model.phi), model.alpha);
}

DiffuseAngles diffuseAngles(const FitSample& sample) { return {sample.angles.NoV, sample.angles.NoL, sample.VoL}; }

Basis basisOf(const AnalyticBrdf& model, const std::vector<FitSample>& samples) {
  Basis basis;
  const double roughness = roughnessOf(model);
  for (const FitSample& sample : samples) {
    const double lobe = lobeValue(model, sample), Fc = schlickWeight(sample.angles.VoH);
    basis.linear.push_back(lobe * (1 - Fc));
    basis.constant.push_back(lobe * Fc);
    basis.diffuse.push_back(
        model.diffuse == DiffuseModel::eon ? 0 : diffuseBrdf(model.diffuse, diffuseAngles(sample), roughness));
  }
  return basis;
}

// The diffuse part and its derivative by albedo.
struct DiffusePart {
  glm::dvec3 value, derivative;
};
DiffusePart diffusePart(const AnalyticBrdf& model, const FitSample& sample, double basis, double roughness) {
  if (model.diffuse != DiffuseModel::eon) return {basis * model.albedo, glm::dvec3(basis)};
  constexpr double h = 1e-5;
  const DiffuseAngles angles = diffuseAngles(sample);
  const glm::dvec3 lower = glm::max(model.albedo - h, 0.0), upper = glm::min(model.albedo + h, 1.0);
  const glm::dvec3 low = diffuseTerm(model.diffuse, angles, roughness, lower);
  const glm::dvec3 high = diffuseTerm(model.diffuse, angles, roughness, upper);
  return {(low + high) / 2.0, (high - low) / (upper - lower)};
}

// Sums of squares and of the normal equations of one channel in (f0, albedo).
struct Normal {
  double squares = 0, a11 = 0, a12 = 0, a22 = 0, b1 = 0, b2 = 0;
};
std::array<Normal, 3> normalEquations(const AnalyticBrdf& model, const Basis& basis,
                                      const std::vector<FitSample>& samples, FitMetric metric) {
  std::array<Normal, 3> sums;
  const double roughness = roughnessOf(model);
  for (size_t i = 0; i < samples.size(); ++i) {
    const double cosine = samples[i].angles.NoL;
    const DiffusePart diffuse = diffusePart(model, samples[i], basis.diffuse[i], roughness);
    for (int c = 0; c < 3; ++c) {
      const double x = (model.f0[c] * basis.linear[i] + basis.constant[i] + diffuse.value[c]) * cosine;
      const double rest = samples[i].value[c] - compressed(x, metric);  // fitAnalytic compressed the values
      const double weight = slope(x, metric) * cosine;
      const double j1 = weight * basis.linear[i], j2 = weight * diffuse.derivative[c];
      Normal& sum = sums[static_cast<size_t>(c)];
      sum.squares += rest * rest;
      sum.a11 += j1 * j1;
      sum.a12 += j1 * j2;
      sum.a22 += j2 * j2;
      sum.b1 += j1 * rest;
      sum.b2 += j2 * rest;
    }
  }
  return sums;
}

// Least of the quadratic form over the box [0, 1]^2, from x by the damped normal equations.
glm::dvec2 boxedStep(const Normal& n, double damping, const glm::dvec2& x) {
  const double a11 = n.a11 * (1 + damping) + 1e-30, a22 = n.a22 * (1 + damping) + 1e-30;
  const double determinant = a11 * a22 - n.a12 * n.a12;
  const auto boxed = [](double value) { return std::clamp(value, 0.0, 1.0); };
  if (determinant > 1e-14 * a11 * a22) {
    const glm::dvec2 free = x + glm::dvec2(a22 * n.b1 - n.a12 * n.b2, a11 * n.b2 - n.a12 * n.b1) / determinant;
    if (free.x == boxed(free.x) && free.y == boxed(free.y)) return free;
  }
  // On the border: the best of its four sides.
  glm::dvec2 best = x;
  double least = 1e300;
  const auto consider = [&](const glm::dvec2& to) {
    const glm::dvec2 d = to - x;
    const double form = a11 * d.x * d.x + 2 * n.a12 * d.x * d.y + a22 * d.y * d.y - 2 * (n.b1 * d.x + n.b2 * d.y);
    if (form < least) least = form, best = to;
  };
  for (const double side : {0.0, 1.0}) {
    consider({side, boxed(x.y + (n.b2 - n.a12 * (side - x.x)) / a22)});
    consider({boxed(x.x + (n.b1 - n.a12 * (side - x.y)) / a11), side});
  }
  return best;
}

// f0 and albedo for the model's alphas; from those it has. Returns the mean square.
double solveColors(AnalyticBrdf& model, const std::vector<FitSample>& samples, FitMetric metric) {
  const Basis basis = basisOf(model, samples);
  std::array<Normal, 3> now = normalEquations(model, basis, samples, metric);
  std::array<double, 3> damping{1e-4, 1e-4, 1e-4};
  for (int iteration = 0; iteration < 20; ++iteration) {
    AnalyticBrdf tried = model;
    double moved = 0;
    for (int c = 0; c < 3; ++c) {
      const glm::dvec2 x(model.f0[c], model.albedo[c]);
      const glm::dvec2 to = boxedStep(now[static_cast<size_t>(c)], damping[static_cast<size_t>(c)], x);
      tried.f0[c] = to.x;
      tried.albedo[c] = to.y;
      moved = std::max({moved, std::abs(to.x - x.x), std::abs(to.y - x.y)});
    }
    if (moved < 1e-7) break;
    const std::array<Normal, 3> then = normalEquations(tried, basis, samples, metric);
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<size_t>(c);
      const bool better = then[k].squares <= now[k].squares;
      damping[k] = better ? damping[k] / 10 : damping[k] * 100;
      if (!better) continue;
      now[k] = then[k];
      model.f0[c] = tried.f0[c];
      model.albedo[c] = tried.albedo[c];
    }
  }
  return (now[0].squares + now[1].squares + now[2].squares) / static_cast<double>(3 * samples.size());
}

// Nelder and Mead 1965 with the usual factors (1, 2, 1/2, 1/2); stops where the simplex is smaller than `tolerance`.
std::vector<double> downhill(std::vector<std::vector<double>> simplex, double tolerance, int most,
                             const std::function<double(const std::vector<double>&)>& f) {
  const size_t n = simplex.size() - 1;
  std::vector<std::pair<double, std::vector<double>>> points;
  for (auto& point : simplex) {
    const double value = f(point);
    points.emplace_back(value, std::move(point));
  }
  for (int evaluations = 0; evaluations < most;) {
    std::sort(points.begin(), points.end());
    double size = 0;
    for (size_t i = 1; i <= n; ++i)
      for (size_t k = 0; k < n; ++k) size = std::max(size, std::abs(points[i].second[k] - points[0].second[k]));
    if (size < tolerance) break;
    std::vector<double> centre(n, 0.0);
    for (size_t i = 0; i < n; ++i)
      for (size_t k = 0; k < n; ++k) centre[k] += points[i].second[k] / static_cast<double>(n);
    const auto tryAt = [&](double factor) {
      std::vector<double> point(n);
      for (size_t k = 0; k < n; ++k) point[k] = centre[k] + factor * (points[n].second[k] - centre[k]);
      ++evaluations;
      const double value = f(point);
      return std::pair(value, std::move(point));
    };
    auto reflected = tryAt(-1);
    if (reflected.first < points[0].first) {
      auto expanded = tryAt(-2);
      points[n] = expanded.first < reflected.first ? expanded : reflected;
    } else if (reflected.first < points[n - 1].first && n > 1) {
      points[n] = reflected;
    } else {
      auto contracted = tryAt(reflected.first < points[n].first ? -0.5 : 0.5);
      if (contracted.first < std::min(reflected.first, points[n].first)) {
        points[n] = contracted;
        continue;
      }
      for (size_t i = 1; i <= n; ++i) {
        for (size_t k = 0; k < n; ++k) points[i].second[k] = (points[i].second[k] + points[0].second[k]) / 2;
        points[i].first = f(points[i].second);
        ++evaluations;
      }
    }
  }
  return std::min_element(points.begin(), points.end())->second;
}

double alphaOfLog(double value) { return std::clamp(std::exp(value), smallestFitAlpha, 1.0); }

// alpha.t the larger one, its azimuth in [0, pi).
void normalise(AnalyticBrdf& model) {
  if (model.alpha.t < model.alpha.b) {
    std::swap(model.alpha.t, model.alpha.b);
    model.phi += pi / 2;
  }
  model.phi = std::fmod(std::fmod(model.phi, pi) + pi, pi);
}

}  // namespace

std::vector<FitSample> fitSamples(const MeasuredBrdf& brdf) {
  const double lowest = std::cos((utiaLastTheta + 1e-6) * pi / 180);
  std::vector<FitSample> samples;
  const auto add = [&](const glm::dvec3& V, const glm::dvec3& L, size_t cell) {
    const glm::vec3& value = brdf.values[cell];
    if (value.x < 0 || V.z < lowest || L.z < lowest || std::ranges::binary_search(brdf.guess.cells, cell)) return;
    samples.push_back({anglesBetween({0, 0, 1}, V, L), V, L, glm::dvec3(value), glm::dot(V, L)});
  };
  if (brdf.kind == MeasuredKind::merl) {
    for (int x = 1; x < merlThetaSteps; x += 3)
      for (int y = 1; y < merlThetaSteps; y += 4)
        for (int z = 6; z < brdf.phiSteps; z += 12) {
          const Directions pair = directionsFrom(merlAngles({x + 0.5, y + 0.5, z + 0.5}));
          add(pair.V, pair.L, static_cast<size_t>((x * merlThetaSteps + y) * brdf.phiSteps + z));
        }
    return samples;
  }
  for (int l = 0; l < utiaDirections; l += 8)
    for (int v = 0; v < utiaDirections; v += 2) {
      const auto direction = [](int i) { return utiaDirection({i / utiaPhiSteps, i % utiaPhiSteps}); };
      add(direction(v), direction(l), static_cast<size_t>(l * utiaDirections + v));
    }
  return samples;
}

double fitError(const AnalyticBrdf& model, const std::vector<FitSample>& samples, FitMetric metric) {
  double sum = 0;
  for (const FitSample& sample : samples) {
    const glm::dvec3 f = analyticBrdf(model, sample.V, sample.L);
    for (int c = 0; c < 3; ++c) {
      const double cosine = sample.angles.NoL;
      const double off = compressed(sample.value[c] * cosine, metric) - compressed(f[c] * cosine, metric);
      sum += off * off;
    }
  }
  return samples.empty() ? 0 : std::sqrt(sum / static_cast<double>(3 * samples.size()));
}

BrdfFit fitAnalytic(const MeasuredBrdf& brdf, const std::vector<FitSample>& samples, const MeasuredProxy& proxy,
                    DiffuseModel diffuse, FitMetric metric) {
  BrdfFit fit{.model = {.f0 = glm::dvec3(0.2), .albedo = proxy.diffuse, .diffuse = diffuse}};
  if (samples.empty()) return fit;
  std::vector<FitSample> target = samples;
  for (FitSample& sample : target)
    for (int c = 0; c < 3; ++c) sample.value[c] = compressed(sample.value[c] * sample.angles.NoL, metric);
  AnalyticBrdf warm = fit.model;
  const auto meanSquare = [&](const std::vector<double>& x) {
    warm.alpha = {alphaOfLog(x[0]), alphaOfLog(x[x.size() > 1 ? 1 : 0])};
    warm.phi = x.size() > 1 ? x[2] : 0;
    return solveColors(warm, target, metric);
  };
  std::vector<std::vector<double>> simplex;
  if (brdf.kind == MeasuredKind::merl) {
    // The error can have two valleys (a sharp lobe, or a broad one for the diffuse part): the deepest of a few places.
    double start = std::log(proxy.alpha.t), least = meanSquare({start});
    for (double place = std::log(0.004); place < 0.1; place += std::log(2.0)) {
      if (const double value = meanSquare({place}); value < least) least = value, start = place;
    }
    simplex = {{start}, {start - 0.3}};
  } else {
    const std::vector<double> start = {std::log(proxy.alpha.t), std::log(proxy.alpha.b), proxy.phi};
    simplex = {start, start, start, start};
    simplex[1][0] -= 0.3, simplex[2][1] -= 0.3, simplex[3][2] += 0.3;
  }
  const std::vector<double> best = downhill(simplex, 1e-4, 150, meanSquare);
  const double square = meanSquare(best);
  fit.model = warm;
  normalise(fit.model);
  fit.error = std::sqrt(square);
  return fit;
}

std::vector<BrdfFit> fitAll(const MeasuredBrdf& brdf, FitMetric metric) {
  const std::vector<FitSample> samples = fitSamples(brdf);
  const MeasuredProxy proxy = fitProxy(brdf);
  std::vector<BrdfFit> fits(std::size(diffuseModels));
  parallelFor(fits.size(),
              [&](size_t i) { fits[i] = fitAnalytic(brdf, samples, proxy, diffuseModels[i].value, metric); });
  return fits;
}

double anisotropyStrength(const AnisotropicAlpha& alpha) {
  return alpha.b >= 1 ? 0 : std::sqrt(std::clamp((alpha.t - alpha.b) / (1 - alpha.b), 0.0, 1.0));
}

}  // namespace facet::optics
