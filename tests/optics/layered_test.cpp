#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "optics/anisotropy.hpp"
#include "optics/bsdf.hpp"
#include "optics/quadrature.hpp"
#include "optics/sheen.hpp"

using namespace facet::optics;

namespace {

const glm::dvec3 up(0, 0, 1);

struct Case {
  const char* name;
  std::function<void(Surface&, double roughness)> apply;
};

void coat(Surface& s, double r) { s.coat = {1, r, up}; }
void cloth(Surface& s, double r) { s.sheen = {{1, 0.5, 0.2}, r}; }
void film(Surface& s, double) { s.film = {1, 1.3, 350}; }
void grain(Surface& s, double) { s.grain = {0.8, {1, 0, 0}}; }
void specular(Surface& s, double) { setDielectricSpecular(s, 2, 0.7, {1, 0.4, 2}); }
void metal(Surface& s, double) { s.metallic = 1; }

const Case cases[] = {
    {"none", [](Surface&, double) {}},
    {"specular, ior", specular},
    {"clearcoat", coat},
    {"sheen", cloth},
    {"iridescence", film},
    {"anisotropy", grain},
    {"metal, clearcoat", [](Surface& s, double r) { metal(s, r), coat(s, r); }},
    {"metal, sheen", [](Surface& s, double r) { metal(s, r), cloth(s, r); }},
    {"metal, iridescence", [](Surface& s, double r) { metal(s, r), film(s, r); }},
    {"metal, anisotropy", [](Surface& s, double r) { metal(s, r), grain(s, r); }},
    {"metal, anisotropy, iridescence", [](Surface& s, double r) { metal(s, r), grain(s, r), film(s, r); }},
    {"clearcoat, sheen", [](Surface& s, double r) { coat(s, r), cloth(s, r); }},
    {"clearcoat, iridescence", [](Surface& s, double r) { coat(s, r), film(s, r); }},
    {"specular, sheen", [](Surface& s, double r) { specular(s, r), cloth(s, r); }},
    {"specular, iridescence", [](Surface& s, double r) { specular(s, r), film(s, r); }},
    {"all", [](Surface& s, double r) { specular(s, r), coat(s, r), cloth(s, r), film(s, r), grain(s, r); }},
};

// E of the sheen over its cosine, for the many light directions.
std::vector<double> sheenTable(double alpha) {
  std::vector<double> table(129);
  for (size_t i = 0; i < table.size(); ++i) table[i] = sheenAlbedo(std::pow(double(i) / 128, 2), alpha);
  return table;
}
double lookUp(const std::vector<double>& table, double cosine) {
  const double x = std::sqrt(cosine) * 128;
  const size_t i = std::min(size_t(x), size_t(127));
  return glm::mix(table[i], table[i + 1], x - double(i));
}

// What comes back of radiance 1 from everywhere.
glm::dvec3 furnace(const Surface& surface, double NoV, const std::vector<double>& sheenE) {
  constexpr size_t heights = 160, azimuths = 400;
  static const Quadrature rule = gaussLegendre(heights);
  const glm::dvec3 V(std::sqrt(1 - NoV * NoV) * 0.8, std::sqrt(1 - NoV * NoV) * 0.6, NoV);
  Albedos albedos = albedosOf(surface, up, V, V);
  glm::dvec3 sum(0);
  for (size_t i = 0; i < heights; ++i) {
    const double t = rule.nodes[i], NoL = t * t, sine = std::sqrt(1 - NoL * NoL);
    albedos.sheenL = lookUp(sheenE, NoL);
    for (size_t j = 0; j < azimuths; ++j) {
      const double phi = 2 * pi * (double(j) + 0.5) / azimuths;
      const glm::dvec3 L(sine * std::cos(phi), sine * std::sin(phi), NoL);
      sum += evaluate(surface, albedos, up, V, L) * (rule.weights[i] * 2 * t * 2 * pi / azimuths);
    }
  }
  return sum;
}

}  // namespace

TEST_CASE("Layers: white furnaces under lights, by extension and for sums of them") {
  std::printf("white furnace of lights                 lowest  highest\n");
  const double roughnesses[] = {0.4, 0.7, 1};
  std::vector<std::vector<double>> tables;
  for (const double r : roughnesses) tables.push_back(sheenTable(r * r));
  for (const Case& c : cases) {
    double low = 1e9, high = 0;
    for (size_t k = 0; k < 3; ++k)
      for (const double NoV : {0.1, 0.5, 1.0}) {
        Surface surface{glm::dvec3(1), 0, roughnesses[k]};
        c.apply(surface, roughnesses[k]);
        const glm::dvec3 total = furnace(surface, NoV, tables[k]);
        low = std::min({low, total.x, total.y, total.z});
        high = std::max({high, total.x, total.y, total.z});
      }
    std::printf("  %-36s %8.4f %8.4f\n", c.name, low, high);
    INFO(c.name);
    CHECK(high <= 1.001);
    CHECK(low > 0.2);
  }
}

TEST_CASE("Layers: none of weight 0 changes a bit, a coat alone is its lobe") {
  const glm::dvec3 V(0.6, 0, 0.8), L(-0.48, 0.36, 0.8);
  const Surface plain{{0.8, 0.5, 0.1}, 0.3, 0.5};
  Surface covered = plain;
  covered.coat = {0, 0.3, up};
  covered.sheen = {{0, 0, 0}, 0.5};
  covered.film.weight = 0;
  setDielectricSpecular(covered, 1.5, 1, {1, 1, 1});
  const glm::dvec3 a = evaluate(plain, albedosOf(plain, up, V, L), up, V, L);
  const glm::dvec3 b = evaluate(covered, albedosOf(covered, up, V, L), up, V, L);
  for (int i = 0; i < 3; ++i) CHECK(a[i] == Approx(b[i]).epsilon(1e-12));
  // Weight 0: nothing but the diffuse base; index infinite: f0 is the colour.
  Surface noLobe = plain;
  setDielectricSpecular(noLobe, 1.5, 0, {1, 1, 1});
  noLobe.metallic = 0;
  const Reflected r = reflect(noLobe, dfgOf(noLobe, 0.8), up, V, L);
  CHECK(r.specular == glm::dvec3(0));
  CHECK(r.diffuse.x == Approx(0.8 / pi * 0.8));
  setDielectricSpecular(noLobe, 0, 1, {0.2, 1, 3});
  CHECK(noLobe.f0 == glm::dvec3(0.2, 1, 1));
}

TEST_CASE("Layers: the coat has its own normal, finite at the ends") {
  size_t bad = 0;
  for (const double v : {0.0, 1e-9, 0.3, 1.0})
    for (const double l : {0.0, 1e-9, 0.7, 1.0})
      for (const double r : {0.0, 1e-3, 1.0}) {
        Surface s{glm::dvec3(1), 0.5, r};
        setDielectricSpecular(s, 0, 1, {1, 0, 0.5});
        s.coat = {1, r, glm::normalize(glm::dvec3(1, 0, 0.2))};
        s.sheen = {{1, 1, 1}, r};
        s.film = {1, 1, 0};
        s.grain = {1, {1, 0, 0}};
        const glm::dvec3 V(std::sqrt(1 - v * v), 0, v), L(0, std::sqrt(1 - l * l), l);
        const glm::dvec3 value = evaluate(s, albedosOf(s, up, V, L), up, V, L);
        for (int i = 0; i < 3; ++i) bad += !(std::isfinite(value[i]) && value[i] >= 0);
      }
  CHECK(bad == 0);
  Surface tilted{glm::dvec3(0), 0, 1};
  tilted.f0 = glm::dvec3(0), tilted.f90 = 0;
  tilted.coat = {1, 0.5, glm::normalize(glm::dvec3(1, 0, 1))};
  const glm::dvec3 facing = tilted.coat.normal;
  const glm::dvec3 peak = evaluate(tilted, albedosOf(tilted, up, facing, facing), up, facing, facing);
  CHECK(peak.x == Approx(0.04 / (4 * pi * 0.25 * 0.25)));  // D V F NoL at the coat's own normal: alpha 1/4
}
