#include "optics/iridescence.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

using Complex = std::complex<double>;

// IEC 61966-2-1, XYZ to linear Rec. 709; the rounding of the extension's text.
glm::dvec3 rec709FromXyz(const glm::dvec3& c) {
  return {3.2404542 * c.x - 1.5371385 * c.y - 0.4985314 * c.z, -0.9692660 * c.x + 1.8760108 * c.y + 0.0415560 * c.z,
          0.0556434 * c.x - 0.2040259 * c.y + 1.0572252 * c.z};
}

// Reflectance of an interface at normal incidence.
double reflectance(double behind, double before) {
  const double ratio = (behind - before) / (behind + before);
  return ratio * ratio;
}

// One lobe of the sensitivities: weight, position [1/m], variance [1/m^2].
double lobe(double weight, double position, double variance, double phase, double shift) {
  return weight * std::sqrt(2 * pi * variance) * std::cos(position * phase + shift) *
         std::exp(-variance * phase * phase);
}

}  // namespace

glm::dvec3 interferenceColor(double opticalPathNm, const glm::dvec3& shift) {
  const double phase = 2 * pi * std::min(opticalPathNm, 1e5) * 1e-9;
  const glm::dvec3 xyz(
      lobe(5.4856e-13, 1.6810e6, 4.3278e9, phase, shift.x) + lobe(9.7470e-14, 2.2399e6, 4.5282e9, phase, shift.x),
      lobe(4.4201e-13, 1.7953e6, 9.3046e9, phase, shift.y), lobe(5.2481e-13, 2.2084e6, 6.6121e9, phase, shift.z));
  return rec709FromXyz(xyz / 1.0685e-7);
}

glm::dvec3 F_Iridescence(double cosine, double outsideIor, double filmIor, double thicknessNm,
                         const glm::dvec3& baseF0) {
  const double cos1 = std::clamp(cosine, 0.0, 1.0);
  const double t = std::clamp(thicknessNm / 0.03, 0.0, 1.0);
  const double film = glm::mix(outsideIor, filmIor, t * t * (3 - 2 * t));
  const double ratio = outsideIor / film;
  const double cos2Squared = 1 - ratio * ratio * (1 - cos1 * cos1);
  if (cos2Squared < 0) return glm::dvec3(1);
  const double cos2 = std::sqrt(cos2Squared);

  const double R12 = F_Schlick(cos1, reflectance(film, outsideIor), 1);
  const double T121 = 1 - R12;
  const double phi21 = film < outsideIor ? 0 : pi;
  glm::dvec3 R23(0), phi(0);
  for (int i = 0; i < 3; ++i) {
    const double root = std::sqrt(std::clamp(baseF0[i] + 1e-4, 0.0, 0.9999));
    const double base = (1 + root) / (1 - root);
    R23[i] = F_Schlick(cos2, reflectance(base, film), 1);
    phi[i] = phi21 + (base < film ? pi : 0);
  }
  const glm::dvec3 R123 = glm::clamp(R12 * R23, 1e-5, 0.9999);
  const glm::dvec3 r123 = glm::sqrt(R123);
  const glm::dvec3 Rs = T121 * T121 * R23 / (1.0 - R123);
  // Order 0 and two orders of interference; Cm = (Rs - T121) r123^m.
  glm::dvec3 sum = R12 + Rs, Cm = Rs - T121;
  const double path = 2 * film * thicknessNm * cos2;
  for (double m : {1.0, 2.0}) {
    Cm *= r123;
    sum += Cm * 2.0 * interferenceColor(m * path, m * phi);
  }
  return glm::max(sum, glm::dvec3(0));
}

glm::dvec3 F_ThinFilm(double cosine, double outsideIor, double filmIor, double thicknessNm, const glm::dvec3& baseF0) {
  const double cos1 = std::clamp(cosine, 0.0, 1.0);
  const double t = std::clamp(thicknessNm / 0.03, 0.0, 1.0);
  const double film = glm::mix(outsideIor, filmIor, t * t * (3 - 2 * t));
  const double sine = outsideIor * std::sqrt((1 - cos1) * (1 + cos1));  // conserved n sin
  if (cos1 == 0 || (sine >= film && film != outsideIor)) return glm::dvec3(1);
  const double cos2 = film == outsideIor ? cos1 : std::sqrt(1 - sine * sine / (film * film));
  const double path = 2 * film * thicknessNm * cos2;
  const glm::dvec3 white = interferenceColor(0, glm::dvec3(0));
  const auto sensitivity = [&](double m) { return interferenceColor(m * path, glm::dvec3(0)) / white; };
  const glm::dvec3 S1 = sensitivity(1), S2 = sensitivity(2);

  glm::dvec3 F(0);
  for (int i = 0; i < 3; ++i) {
    const double root = std::sqrt(std::clamp(baseF0[i], 0.0, 0.9999)), base = (1 + root) / (1 - root);
    const double cos3 = std::sqrt(std::max(0.0, 1 - sine * sine / (base * base)));
    // Sum of one polarisation by its amplitudes r12, r23; one round trip in the film carries r21 r23.
    const auto series = [&](double r12, double r23) {
      const double R12 = r12 * r12, trip = -r12 * r23;
      const double Rs = (1 - R12) * (1 - R12) * r23 * r23 / (1 - std::min(trip * trip, 0.9999));
      return R12 + Rs + 2 * (Rs - (1 - R12)) * (trip * S1[i] + trip * trip * S2[i]);
    };
    const auto amplitude = [](double a, double b) { return a + b > 0 ? (a - b) / (a + b) : 0; };
    const double s = series(amplitude(outsideIor * cos1, film * cos2), amplitude(film * cos2, base * cos3));
    const double p = series(amplitude(film * cos1, outsideIor * cos2), amplitude(base * cos2, film * cos3));
    F[i] = std::max(0.0, (s + p) / 2);
  }
  return F;
}

glm::dvec3 f0FromSchlick(const glm::dvec3& F, double cosine) {
  const double weight = schlickWeight(cosine);
  if (weight >= 1) return glm::dvec3(0);
  return glm::clamp((F - weight) / (1 - weight), 0.0, 1.0);
}

double F_Airy(double cosine, double outsideIor, double filmIor, double thicknessNm, double baseIor, double lambdaNm) {
  const double cos1 = std::clamp(cosine, 0.0, 1.0);
  const double sin1 = outsideIor * std::sqrt((1 - cos1) * (1 + cos1));  // conserved n sin
  const auto cosIn = [&](double n) { return std::sqrt(Complex(1 - sin1 * sin1 / (n * n), 0)); };
  const Complex c1 = cos1, c2 = cosIn(filmIor), c3 = cosIn(baseIor);
  const Complex delta = 4 * pi * filmIor * thicknessNm * c2 / lambdaNm;
  const Complex turn = std::exp(Complex(0, 1) * delta);
  const auto total = [&](Complex r12, Complex r23) {
    return std::min(1.0, std::norm((r12 + r23 * turn) / (1.0 + r12 * r23 * turn)));
  };
  const auto rs = [](double n1, Complex a, double n2, Complex b) { return (n1 * a - n2 * b) / (n1 * a + n2 * b); };
  const auto rp = [](double n1, Complex a, double n2, Complex b) { return (n2 * a - n1 * b) / (n2 * a + n1 * b); };
  if (cos1 == 0) return 1;
  return (total(rs(outsideIor, c1, filmIor, c2), rs(filmIor, c2, baseIor, c3)) +
          total(rp(outsideIor, c1, filmIor, c2), rp(filmIor, c2, baseIor, c3))) /
         2;
}

glm::dvec3 xyzBar(double lambdaNm) {
  const auto g = [&](double weight, double mean, double below, double above) {
    const double t = (lambdaNm - mean) * (lambdaNm < mean ? below : above);
    return weight * std::exp(-0.5 * t * t);
  };
  return {g(0.362, 442.0, 0.0624, 0.0374) + g(1.056, 599.8, 0.0264, 0.0323) - g(0.065, 501.1, 0.0490, 0.0382),
          g(0.821, 568.8, 0.0213, 0.0247) + g(0.286, 530.9, 0.0613, 0.0322),
          g(1.217, 437.0, 0.0845, 0.0278) + g(0.681, 459.0, 0.0385, 0.0725)};
}

glm::dvec3 F_ThinFilmSpectral(double cosine, double outsideIor, double filmIor, double thicknessNm,
                              const glm::dvec3& baseIor, double stepNm) {
  glm::dvec3 sum(0), white(0);
  const bool grey = baseIor.x == baseIor.y && baseIor.x == baseIor.z;
  for (double lambda = 380; lambda <= 780; lambda += stepNm) {
    const glm::dvec3 weight = rec709FromXyz(xyzBar(lambda));
    white += weight;
    glm::dvec3 F(F_Airy(cosine, outsideIor, filmIor, thicknessNm, baseIor.x, lambda));
    for (int i = 1; i < 3 && !grey; ++i) F[i] = F_Airy(cosine, outsideIor, filmIor, thicknessNm, baseIor[i], lambda);
    sum += weight * F;
  }
  return sum / white;
}

}  // namespace facet::optics
