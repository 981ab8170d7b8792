#include "optics/measured_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

#include "base/parallel.hpp"
#include "optics/downhill.hpp"
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

// What the model's lobe and diffuse part are at each sample, so that f = f0 facing + f90 grazing + diffuse(albedo).
struct Basis {
  std::vector<double> facing, grazing, diffuse;  // diffuse: for albedo 1
};

DiffuseAngles diffuseAngles(const FitSample& sample) { return {sample.angles.NoV, sample.angles.NoL, sample.VoL}; }

Basis basisOf(const AnalyticBrdf& model, const std::vector<FitSample>& samples) {
  Basis basis;
  const double roughness = roughnessOf(model);
  for (const FitSample& sample : samples) {
    const double lobe = analyticLobe(model, sample.angles, sample.V, sample.L), Fc = schlickWeight(sample.angles.VoH);
    basis.facing.push_back(lobe * (1 - Fc));
    basis.grazing.push_back(lobe * Fc);
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

// Sums of squares and of the normal equations of one channel in (f0, f90, albedo).
struct Normal {
  double squares = 0;
  glm::dmat3 a{0};
  glm::dvec3 b{0};
  // A residual and its derivatives, as often as `weight` says.
  void add(double rest, const glm::dvec3& j, double weight = 1) {
    squares += weight * rest * rest;
    a += weight * glm::outerProduct(j, j);
    b += weight * rest * j;
  }
};

// What is reflected of a ring of directions of V: of f = 1 / pi, and the inverse of the table's, by channel.
constexpr int rings = 5;
constexpr double energyWeight = 1;           // of a mean square relative error to one in the metric
constexpr double smallestRingAlbedo = 0.01;  // below it errors are absolute
struct Ring {
  double white = 0;
  glm::dvec3 table{0};
};
using Rings = std::array<Ring, rings>;
int ringOf(double cosine) { return std::min(static_cast<int>(std::acos(std::min(cosine, 1.0)) / (15 * degree)), 4); }

// Each pair counts from both sides: V and L exchanged.
template <class Add>
void eachRing(const FitSample& sample, const Add& add) {
  add(ringOf(sample.angles.NoV), sample.pairs * sample.angles.NoL);
  add(ringOf(sample.angles.NoL), sample.pairs * sample.angles.NoV);
}

Rings ringsOf(const std::vector<FitSample>& samples) {
  Rings result;
  for (const FitSample& sample : samples)
    eachRing(sample, [&](int ring, double weight) {
      Ring& sum = result[static_cast<size_t>(ring)];
      sum.white += weight / pi;
      sum.table += weight * sample.value;
    });
  return result;
}
// What is fitted to, compressed once.
struct Target {
  std::vector<FitSample> samples;  // their values are compressed(f NoL)
  Rings rings;                     // of the values as they were
};

std::array<Normal, 3> normalEquations(const AnalyticBrdf& model, const Basis& basis, const Target& target,
                                      FitMetric metric) {
  std::array<Normal, 3> sums;
  struct Reflected {
    glm::dvec3 value{0}, albedo{0};  // of a ring by channel, and its derivative by albedo
    double facing = 0, grazing = 0;  // its derivatives by f0 and f90
  };
  std::array<Reflected, rings> reflected;
  const double roughness = roughnessOf(model);
  for (size_t i = 0; i < target.samples.size(); ++i) {
    const FitSample& sample = target.samples[i];
    const double cosine = sample.angles.NoL;
    const DiffusePart diffuse = diffusePart(model, sample, basis.diffuse[i], roughness);
    const glm::dvec3 f = model.f0 * basis.facing[i] + model.f90 * basis.grazing[i] + diffuse.value;
    for (int c = 0; c < 3; ++c) {
      const double x = f[c] * cosine, weight = slope(x, metric) * cosine;
      sums[static_cast<size_t>(c)].add(sample.value[c] - compressed(x, metric),
                                       weight * glm::dvec3(basis.facing[i], basis.grazing[i], diffuse.derivative[c]));
    }
    eachRing(sample, [&](int ring, double weight) {
      Reflected& sum = reflected[static_cast<size_t>(ring)];
      sum.value += weight * f;
      sum.albedo += weight * diffuse.derivative;
      sum.facing += weight * basis.facing[i];
      sum.grazing += weight * basis.grazing[i];
    });
  }
  const double count = energyWeight * static_cast<double>(target.samples.size()) / rings;
  for (size_t r = 0; r < rings; ++r) {
    const Ring& ring = target.rings[r];
    if (ring.white <= 0) continue;
    const Reflected& of = reflected[r];
    for (int c = 0; c < 3; ++c) {
      const double scale = 1 / std::max(ring.table[c], smallestRingAlbedo * ring.white);
      sums[static_cast<size_t>(c)].add((ring.table[c] - of.value[c]) * scale,
                                       scale * glm::dvec3(of.facing, of.grazing, of.albedo[c]), count);
    }
  }
  return sums;
}

// Least of the quadratic form over the box [0, 1]^3, from x by the damped normal equations: of the faces, edges and
// corners that hold some of the unknowns at 0 or 1, the least point that lies in the box.
glm::dvec3 boxedStep(const Normal& n, double damping, const glm::dvec3& x) {
  glm::dmat3 a = n.a;
  for (int k = 0; k < 3; ++k) a[k][k] = a[k][k] * (1 + damping) + 1e-30;
  glm::dvec3 best = x;
  double least = 0;                        // of staying at x
  for (int held = 0; held < 27; ++held) {  // in base 3, an unknown each: free, 0 or 1
    const int digits[3] = {held % 3, held / 3 % 3, held / 9};
    glm::dmat3 m = a;
    glm::dvec3 right = n.b, d;
    for (int k = 0; k < 3; ++k)
      if (digits[k] > 0) right -= a[k] * (digits[k] - 1 - x[k]);
    for (int k = 0; k < 3; ++k) {
      if (digits[k] == 0) continue;
      for (int j = 0; j < 3; ++j) m[k][j] = m[j][k] = j == k ? 1 : 0;
      right[k] = digits[k] - 1 - x[k];
    }
    if (!(std::abs(glm::determinant(m)) > 1e-14 * m[0][0] * m[1][1] * m[2][2])) continue;
    d = glm::inverse(m) * right;
    const glm::dvec3 to = x + d;
    if (to != glm::clamp(to, -1e-12, 1 + 1e-12)) continue;
    const double form = glm::dot(d, a * d) - 2 * glm::dot(n.b, d);
    if (form < least) least = form, best = glm::clamp(to, 0.0, 1.0);
  }
  return best;
}

// f0, f90 and albedo for the model's alphas; from those it has. Returns what is to be least.
double solveColors(AnalyticBrdf& model, const Target& target, FitMetric metric) {
  const Basis basis = basisOf(model, target.samples);
  std::array<Normal, 3> now = normalEquations(model, basis, target, metric);
  std::array<double, 3> damping{1e-4, 1e-4, 1e-4};
  for (int iteration = 0; iteration < 20; ++iteration) {
    AnalyticBrdf tried = model;
    double moved = 0;
    for (int c = 0; c < 3; ++c) {
      const glm::dvec3 x(model.f0[c], model.f90[c], model.albedo[c]);
      const glm::dvec3 to = boxedStep(now[static_cast<size_t>(c)], damping[static_cast<size_t>(c)], x);
      tried.f0[c] = to.x;
      tried.f90[c] = to.y;
      tried.albedo[c] = to.z;
      for (int k = 0; k < 3; ++k) moved = std::max(moved, std::abs(to[k] - x[k]));
    }
    if (moved < 1e-7) break;
    const std::array<Normal, 3> then = normalEquations(tried, basis, target, metric);
    for (int c = 0; c < 3; ++c) {
      const auto k = static_cast<size_t>(c);
      const bool better = then[k].squares <= now[k].squares;
      damping[k] = better ? damping[k] / 10 : damping[k] * 100;
      if (!better) continue;
      now[k] = then[k];
      model.f0[c] = tried.f0[c];
      model.f90[c] = tried.f90[c];
      model.albedo[c] = tried.albedo[c];
    }
  }
  return (now[0].squares + now[1].squares + now[2].squares) / static_cast<double>(3 * target.samples.size());
}

double alphaOfLog(double value) { return std::clamp(std::exp(value), smallestFitAlpha, 1.0); }

// alpha.t the larger one, its azimuth in [0, pi); the widening what of it acts.
void normalise(AnalyticBrdf& model) {
  if (model.alpha.t < model.alpha.b) {
    std::swap(model.alpha.t, model.alpha.b);
    model.phi += pi / 2;
  }
  model.phi = std::fmod(std::fmod(model.phi, pi) + pi, pi);
  model.widening = std::min(model.widening, 1 / model.alpha.b);  // wider than alpha 1 is none
}

}  // namespace

double FitAlbedo::off() const {
  const glm::dvec3 relative = glm::abs(model - table) / glm::max(table, smallestRingAlbedo);
  return std::max({relative.x, relative.y, relative.z});
}

std::vector<FitSample> fitSamples(const MeasuredBrdf& brdf) {
  const double lowest = std::cos((utiaLastTheta + 1e-6) * pi / 180);
  std::vector<FitSample> samples;
  const auto add = [&](const glm::dvec3& V, const glm::dvec3& L, size_t cell, double measure) {
    const glm::vec3& value = brdf.values[cell];
    if (value.x < 0 || V.z < lowest || L.z < lowest || std::ranges::binary_search(brdf.guess.cells, cell)) return;
    samples.push_back({anglesBetween({0, 0, 1}, V, L), V, L, glm::dvec3(value), glm::dot(V, L), measure});
  };
  if (brdf.kind == MeasuredKind::merl) {
    for (int x = 1; x < merlThetaSteps; x += 3)
      for (int y = 1; y < merlThetaSteps; y += 4)
        for (int z = 6; z < brdf.phiSteps; z += 12) {
          const Directions pair = directionsFrom(merlAngles({x + 0.5, y + 0.5, z + 0.5}));
          add(pair.V, pair.L, static_cast<size_t>((x * merlThetaSteps + y) * brdf.phiSteps + z), merlPairs(x, y));
        }
    return samples;
  }
  for (int l = 0; l < utiaDirections; l += 8)
    for (int v = 0; v < utiaDirections; v += 2) {
      const auto direction = [](int i) { return utiaDirection({i / utiaPhiSteps, i % utiaPhiSteps}); };
      add(direction(v), direction(l), static_cast<size_t>(l * utiaDirections + v),
          utiaProjected(v / utiaPhiSteps) * utiaProjected(l / utiaPhiSteps) / (direction(v).z * direction(l).z));
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

namespace {

void compareAlbedo(BrdfFit& fit, const MeasuredBrdf& brdf, const MeasuredProxy& proxy) {
  for (size_t i = 0; i < std::size(fitAlbedoAngles); ++i) {
    const double theta = fitAlbedoAngles[i] * degree;
    const glm::dvec3 V(std::sin(theta), 0, std::cos(theta));
    FitAlbedo& albedo = fit.albedo[i];
    albedo.table = measuredAlbedo(brdf, proxy, V, LookUp::interpolated);
    albedo.model = analyticAlbedo(fit.model, proxy, V);
    if (albedo.off() > fit.albedoError) fit.albedoError = albedo.off(), fit.albedoErrorAngle = fitAlbedoAngles[i];
  }
}

}  // namespace

namespace {

// What the simplex moves: the logarithms of alpha, or of both and their azimuth, then what the shape has of its own.
struct Unknowns {
  LobeShape shape;
  bool turned;  // two alphas
  std::vector<double> startAt(const MeasuredProxy& proxy) const {
    std::vector<double> x{std::log(proxy.alpha.t)};
    if (turned) x.insert(x.end(), {std::log(proxy.alpha.b), proxy.phi});
    if (shape == LobeShape::gtr) x.push_back(std::log(2.0));
    if (shape == LobeShape::twoGgx) x.insert(x.end(), {std::log(4.0), 0.3});
    return x;
  }
  void put(AnalyticBrdf& model, const std::vector<double>& x) const {
    model.alpha = {alphaOfLog(x[0]), alphaOfLog(x[turned ? 1 : 0])};
    model.phi = turned ? x[2] : 0;
    const double* own = x.data() + (turned ? 3 : 1);
    if (shape == LobeShape::gtr) model.exponent = std::clamp(std::exp(own[0]), leastExponent, mostExponent);
    if (shape != LobeShape::twoGgx) return;
    model.widening = std::clamp(std::exp(own[0]), 1.0, 1 / smallestFitAlpha);
    model.wideShare = std::clamp(own[1], 0.0, 1.0);
  }
};

// The error can have two valleys (a sharp lobe, or a broad one for the diffuse part): the deepest of a few places.
std::vector<double> deepest(std::vector<double> x, const std::function<double(const std::vector<double>&)>& f) {
  std::vector<double> best = x;
  double least = f(x);
  for (double place = std::log(0.004); place < 0.1; place += std::log(2.0)) {
    x[0] = place;
    if (const double value = f(x); value < least) least = value, best = x;
  }
  return best;
}

}  // namespace

BrdfFit fitAnalytic(const MeasuredBrdf& brdf, const std::vector<FitSample>& samples, const MeasuredProxy& proxy,
                    DiffuseModel diffuse, FitMetric metric, LobeShape shape) {
  BrdfFit fit{.model = {.f0 = glm::dvec3(0.2), .albedo = proxy.diffuse, .diffuse = diffuse, .shape = shape}};
  if (samples.empty()) return fit;
  Target target{samples, ringsOf(samples)};
  for (FitSample& sample : target.samples)
    for (int c = 0; c < 3; ++c) sample.value[c] = compressed(sample.value[c] * sample.angles.NoL, metric);
  const Unknowns unknowns{shape, brdf.kind == MeasuredKind::utia && shape != LobeShape::gtr};
  AnalyticBrdf warm = fit.model;
  const auto meanSquare = [&](const std::vector<double>& x) {
    unknowns.put(warm, x);
    return solveColors(warm, target, metric);
  };
  std::vector<double> start = unknowns.startAt(proxy);
  if (!unknowns.turned) start = deepest(start, meanSquare);
  std::vector<std::vector<double>> simplex(start.size() + 1, start);
  for (size_t k = 0; k < start.size(); ++k) simplex[k + 1][k] += unknowns.turned && k == 2 ? 0.3 : -0.3;
  const std::vector<double> best = downhill(simplex, 1e-4, start.size() > 3 ? 400 : 150, meanSquare);
  fit.misfit = std::sqrt(meanSquare(best));
  fit.model = warm;
  normalise(fit.model);
  fit.error = fitError(fit.model, samples, metric);
  compareAlbedo(fit, brdf, proxy);
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

std::vector<BrdfFit> fitShapes(const MeasuredBrdf& brdf, const BrdfFit& ggx, FitMetric metric) {
  const std::vector<FitSample> samples = fitSamples(brdf);
  const MeasuredProxy proxy = fitProxy(brdf);
  std::vector<BrdfFit> fits(std::size(lobeShapes), ggx);
  parallelFor(fits.size() - 1, [&](size_t i) {
    fits[i + 1] = fitAnalytic(brdf, samples, proxy, ggx.model.diffuse, metric, lobeShapes[i + 1].value);
  });
  return fits;
}

std::vector<bool> bestFits(const std::vector<BrdfFit>& fits) {
  double least = 1e300;
  for (const BrdfFit& fit : fits) least = std::min(least, fit.misfit);
  std::vector<bool> best;
  for (const BrdfFit& fit : fits) best.push_back(fit.misfit <= std::max(1.01 * least, least + 3e-5));
  return best;
}

std::string albedoRemark(const BrdfFit& fit) {
  if (fit.albedoError < toldAlbedoError) return {};
  char text[80];
  std::snprintf(text, sizeof text, "its albedo is off by %.2g %% at %g degrees", 100 * fit.albedoError,
                fit.albedoErrorAngle);
  return text;
}

double anisotropyStrength(const AnisotropicAlpha& alpha) {
  return alpha.b >= 1 ? 0 : std::sqrt(std::clamp((alpha.t - alpha.b) / (1 - alpha.b), 0.0, 1.0));
}

}  // namespace facet::optics
