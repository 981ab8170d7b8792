#include "scene/builtin_environments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/angle.hpp"
#include "base/parallel.hpp"

namespace facet::scene {

namespace {

constexpr std::array<BuiltinEnvironment, 3> environments = {{
    {"studio", "softboxes in a dark room"},
    {"sky", "clear sky with the sun 40 degrees high"},
    {"white", "radiance 1 from everywhere: the furnace"},
}};

// rowRadiance(y of the row's directions) gives a function of the direction, which is asked at each texel's centre.
template <class RowRadiance>
Environment fill(std::string name, int width, int height, const RowRadiance& rowRadiance) {
  Environment e;
  e.name = std::move(name), e.width = width, e.height = height;
  e.radiance.resize(size_t(width) * size_t(height));
  std::vector<glm::vec2> around(static_cast<size_t>(width));  // cosine and sine of each column's azimuth
  for (int x = 0; x < width; ++x) {
    const double azimuth = 2 * pi * ((x + 0.5) / width - 0.5);
    around[size_t(x)] = glm::vec2(float(std::cos(azimuth)), float(std::sin(azimuth)));
  }
  parallelFor(size_t(height), [&](size_t y) {
    const double elevation = pi * (0.5 - (double(y) + 0.5) / height);
    const auto level = float(std::cos(elevation)), up = float(std::sin(elevation));
    const auto radiance = rowRadiance(up);
    for (size_t x = 0; x < size_t(width); ++x)
      e.radiance[y * size_t(width) + x] = radiance(glm::vec3(level * around[x].x, up, level * around[x].y));
  });
  return e;
}

// ---- studio ---------------------------------------------------------------------------------------------------------

// A rectangle that glows: seen from the origin along its axis at distance 1, with half sizes in that plane.
struct Softbox {
  glm::vec3 axis, right, up;
  glm::vec2 half;
  float softness;  // share of the half size over which the edge fades
  glm::vec3 radiance;
};

Softbox softbox(const glm::vec3& towards, float halfWidth, float halfHeight, float softness,
                const glm::vec3& radiance) {
  const glm::vec3 axis = glm::normalize(towards);
  const glm::vec3 up = std::abs(axis.y) > 0.999f ? glm::vec3(0, 0, -1) : glm::vec3(0, 1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(up, -axis));
  return {axis, right, glm::cross(-axis, right), {halfWidth, halfHeight}, softness, radiance};
}

glm::vec3 glow(const Softbox& box, const glm::vec3& d) {
  const float along = glm::dot(d, box.axis);
  if (along <= 0.05f) return glm::vec3(0);
  const float x = std::abs(glm::dot(d, box.right)) / (along * box.half.x);
  const float y = std::abs(glm::dot(d, box.up)) / (along * box.half.y);
  if (x >= 1 || y >= 1) return glm::vec3(0);
  const float edge =
      (1 - glm::smoothstep(1 - box.softness, 1.0f, x)) * (1 - glm::smoothstep(1 - box.softness, 1.0f, y));
  return box.radiance * edge * (1 - 0.3f * (x * x + y * y) * 0.5f);  // the lamp behind the cloth shows in the middle
}

Environment studio() {
  const std::array boxes = {
      softbox({-0.85f, 0.60f, 0.70f}, 0.36f, 0.44f, 0.12f, {10.0f, 9.7f, 9.2f}),  // key, left of the camera
      softbox({1.00f, 0.20f, 0.45f}, 0.13f, 0.70f, 0.25f, {5.2f, 5.6f, 6.2f}),    // strip, right
      softbox({0.00f, 1.00f, -0.15f}, 0.50f, 0.26f, 0.20f, {3.0f, 3.0f, 3.0f}),   // overhead
      softbox({0.95f, 0.40f, -0.90f}, 0.11f, 0.60f, 0.30f, {7.0f, 6.6f, 6.0f}),   // rim, right behind
      softbox({-1.00f, 0.25f, -0.80f}, 0.08f, 0.50f, 0.30f, {3.4f, 3.8f, 4.6f}),  // rim, left behind
  };
  const glm::vec3 ceiling(0.020f, 0.021f, 0.024f), wall(0.085f, 0.088f, 0.096f), floor(0.11f, 0.105f, 0.10f);
  return fill("studio", 512, 256, [&](float up) {
    const glm::vec3 room = up > 0 ? glm::mix(wall, ceiling, glm::smoothstep(0.0f, 0.8f, up))
                                  : glm::mix(wall, floor, glm::smoothstep(0.0f, 0.35f, -up));
    // A lamp grazes the backdrop behind the subject.
    const glm::vec3 backdrop = glm::vec3(0.17f, 0.18f, 0.20f) * std::exp(-3.0f * up * up);
    return [&boxes, room, backdrop](const glm::vec3& d) {
      const float behind = glm::max(-d.z, 0.0f), behind2 = behind * behind;
      glm::vec3 c = room + backdrop * (behind2 * behind2 * behind2);
      for (const Softbox& box : boxes) c += glow(box, d);
      return c;
    };
  });
}

// ---- sky ------------------------------------------------------------------------------------------------------------

// Preetham, Shirley, Smits 1999, "A Practical Analytic Model for Daylight", appendix A.2; valid for turbidity 2 to 6
// and a sun above the horizon. Luminance in kcd/m^2, chromaticity CIE x, y.
constexpr double turbidity = 2.5;
constexpr double sunElevation = 40 * degree;
constexpr double sunRadius = 0.5 * 0.533 * degree;

// Of radiance 1, in kcd/m^2: makes a level white Lambertian surface under sky and sun radiate 1.
constexpr double kilocandelaPerUnit = 26.58;

const glm::dvec3 sunDirection = glm::normalize(glm::dvec3(-0.7, 0, 0.714142842854285) * std::cos(sunElevation) +
                                               glm::dvec3(0, std::sin(sunElevation), 0));

// Perez, Seals, Michalsky 1993: F = (1 + A exp(B / cos theta)) (1 + C exp(D gamma) + E cos^2 gamma).
struct Perez {
  float a, b, c, d, e;
  float scale;  // zenith value / F(0, thetaSun)

  float horizon(float cosTheta) const { return 1 + a * std::exp(b / cosTheta); }
  float circumsolar(float gamma, float cosGamma) const { return 1 + c * std::exp(d * gamma) + e * cosGamma * cosGamma; }
};

Perez perez(const std::array<double, 5>& slope, const std::array<double, 5>& offset, double zenith) {
  std::array<float, 5> k{};
  for (size_t i = 0; i < k.size(); ++i) k[i] = float(slope[i] * turbidity + offset[i]);
  Perez p{k[0], k[1], k[2], k[3], k[4], 1};
  const double thetaSun = pi / 2 - sunElevation;
  p.scale = float(zenith) / (p.horizon(1) * p.circumsolar(float(thetaSun), float(std::cos(thetaSun))));
  return p;
}

// The circumsolar factor is smooth in gamma: 512 steps interpolate it to 2e-4 of its value.
constexpr int gammaSteps = 512;

struct SkyModel {
  Perez luminance, x, y;
  std::array<glm::vec3, gammaSteps + 1> circumsolar = {};  // of luminance, x, y, over gamma in [0, pi]
};

SkyModel skyModel() {
  const double t = turbidity, s = pi / 2 - sunElevation;
  const double chi = (4.0 / 9 - t / 120) * (pi - 2 * s);
  const double zenithY = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
  const auto cubic = [&](double c3, double c2, double c1, double c0) { return ((c3 * s + c2) * s + c1) * s + c0; };
  const double zenithx = t * t * cubic(0.00166, -0.00375, 0.00209, 0) +
                         t * cubic(-0.02903, 0.06377, -0.03202, 0.00394) + cubic(0.11693, -0.21196, 0.06052, 0.25886);
  const double zenithy = t * t * cubic(0.00275, -0.00610, 0.00317, 0) +
                         t * cubic(-0.04214, 0.08970, -0.04153, 0.00516) + cubic(0.15346, -0.26756, 0.06670, 0.26688);
  SkyModel model{
      perez({0.1787, -0.3554, -0.0227, 0.1206, -0.0670}, {-1.4630, 0.4275, 5.3251, -2.5771, 0.3703}, zenithY),
      perez({-0.0193, -0.0665, -0.0004, -0.0641, -0.0033}, {-0.2592, 0.0008, 0.2125, -0.8989, 0.0452}, zenithx),
      perez({-0.0167, -0.0950, -0.0079, -0.0441, -0.0109}, {-0.2608, 0.0092, 0.2102, -1.6537, 0.0529}, zenithy)};
  for (int i = 0; i <= gammaSteps; ++i) {
    const auto gamma = float(pi * i / gammaSteps);
    const auto at = [&](const Perez& p) { return p.circumsolar(gamma, std::cos(gamma)); };
    model.circumsolar[size_t(i)] = {at(model.luminance), at(model.x), at(model.y)};
  }
  return model;
}

// CIE xyY -> linear Rec. 709 (IEC 61966-2-1); what lies outside the gamut is clipped.
glm::vec3 rec709(float x, float y, float luminance) {
  const float X = x / y * luminance, Y = luminance, Z = (1 - x - y) / y * luminance;
  return glm::max(glm::vec3(3.2406f * X - 1.5372f * Y - 0.4986f * Z, -0.9689f * X + 1.8758f * Y + 0.0415f * Z,
                            0.0557f * X - 0.2040f * Y + 1.0570f * Z),
                  glm::vec3(0));
}

// What all directions of one height share: luminance, x, y without the circumsolar factor.
glm::vec3 skyRow(const SkyModel& m, float up) {
  const float cosTheta = std::max(up, 1e-3f);  // below the horizon the model has no value
  return {m.luminance.scale * m.luminance.horizon(cosTheta) / float(kilocandelaPerUnit),
          m.x.scale * m.x.horizon(cosTheta), m.y.scale * m.y.horizon(cosTheta)};
}

glm::vec3 skyRadiance(const SkyModel& model, const glm::vec3& row, const glm::vec3& d) {
  const float cosGamma = glm::clamp(glm::dot(d, glm::vec3(sunDirection)), -1.0f, 1.0f);
  const float at = std::acos(cosGamma) * float(gammaSteps / pi);
  const int i = std::min(int(at), gammaSteps - 1);
  const glm::vec3 c = row * glm::mix(model.circumsolar[size_t(i)], model.circumsolar[size_t(i) + 1], at - float(i));
  return rec709(c.y, c.z, c.x);
}

// Spreads the disc over its texels by the share of each that it covers (24 x 24 points), scaled so that the sum over
// radiance and solid angle is the sun's irradiance.
void addSun(Environment& e) {
  const double u = std::atan2(sunDirection.z, sunDirection.x) / (2 * pi) + 0.5,
               v = std::asin(sunDirection.y) / pi + 0.5;
  const int column = int(u * e.width), row = int((1 - v) * e.height);
  constexpr int reach = 3, points = 24;  // texels to each side; enough up to 2048 columns
  struct Covered {
    size_t texel;
    double share;
  };
  std::vector<Covered> covered;
  double solidAngle = 0;
  for (int y = row - reach; y <= row + reach; ++y)
    for (int x = column - reach; x <= column + reach; ++x) {
      int inside = 0;
      for (int i = 0; i < points * points; ++i) {
        const double azimuth = 2 * pi * ((x + (i % points + 0.5) / points) / e.width - 0.5);
        const double elevation = pi * (0.5 - (y + (i / points + 0.5) / points) / e.height);
        const glm::dvec3 d(std::cos(elevation) * std::cos(azimuth), std::sin(elevation),
                           std::cos(elevation) * std::sin(azimuth));
        inside += glm::dot(d, sunDirection) > std::cos(sunRadius);
      }
      if (inside == 0) continue;
      const double share = double(inside) / (points * points);
      covered.push_back({size_t(y) * size_t(e.width) + size_t(x), share});
      solidAngle += share * (2 * pi / e.width) *
                    (std::sin(pi * (0.5 - double(y) / e.height)) - std::sin(pi * (0.5 - (y + 1.0) / e.height)));
    }
  const glm::dvec3 radiance = builtinSunIrradiance() / solidAngle;
  for (const Covered& c : covered) e.radiance[c.texel] += glm::vec3(radiance * c.share);
}

Environment sky() {
  const SkyModel model = skyModel();
  const glm::vec3 ground(0.21f, 0.20f, 0.185f);  // albedo of dry ground under irradiance pi
  Environment e = fill("sky", 1024, 512, [&](float up) {
    const float haze = up < 0 ? std::exp(20 * up) : 1;  // the ground fades into the horizon over some 5 degrees
    return [&, haze, row = skyRow(model, up)](const glm::vec3& d) {
      if (haze < 1e-3f) return ground;
      return glm::mix(ground, skyRadiance(model, row, glm::normalize(glm::vec3(d.x, std::max(d.y, 0.0f), d.z))), haze);
    };
  });
  addSun(e);
  return e;
}

}  // namespace

glm::dvec3 builtinSunDirection() { return sunDirection; }

// Extraterrestrial illuminance 133.1 klx, dimmed along the path by air and aerosol (Preetham 1999, appendix A.1:
// Rayleigh and Angstrom) at 610, 550 and 460 nm, which stand for red, green and blue.
glm::dvec3 builtinSunIrradiance() {
  const double airMass = 1 / (std::sin(sunElevation) + 0.15 * std::pow(sunElevation / degree + 3.885, -1.253));
  const double beta = 0.04608365822050 * turbidity - 0.04586025928522;
  const glm::dvec3 white(1.06, 0.99, 0.94);  // 5800 K relative to D65, luminance 1
  const double wavelength[3] = {0.61, 0.55, 0.46};
  glm::dvec3 irradiance;
  for (int c = 0; c < 3; ++c) {
    const double rayleigh = 0.008735 * std::pow(wavelength[c], -4.08), aerosol = beta * std::pow(wavelength[c], -1.3);
    irradiance[c] = white[c] * 133.1 / kilocandelaPerUnit * std::exp(-airMass * (rayleigh + aerosol));
  }
  return irradiance;
}

std::span<const BuiltinEnvironment> builtinEnvironments() { return environments; }

Result<Environment> builtinEnvironment(std::string_view name) {
  constexpr std::string_view prefix = "builtin:";
  const std::string_view bare = name.starts_with(prefix) ? name.substr(prefix.size()) : name;
  if (bare == "studio") return studio();
  if (bare == "sky") return sky();
  if (bare == "white")
    return fill("white", 64, 32, [](float) { return [](const glm::vec3&) { return glm::vec3(1); }; });
  std::string known;
  for (const BuiltinEnvironment& e : environments) known += (known.empty() ? "" : ", ") + std::string(e.name);
  return fail(std::string(prefix) + std::string(bare), "", "there is no such built-in environment",
              "choose one of " + known);
}

}  // namespace facet::scene
