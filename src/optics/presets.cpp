#include "optics/presets.hpp"

#include <algorithm>

#include "optics/fresnel.hpp"

namespace facet::optics {

namespace {

// Rows of the tables as published (by way of refractiveindex.info, CC0): the ones nearest to 610, 549 and 465 nm, about
// the centres of gravity of Rec. 709's sensitivities; no interpolation.
constexpr std::string_view noble = "Johnson and Christy 1972, Phys. Rev. B 6, 4370",
                           transition = "Johnson and Christy 1974, Phys. Rev. B 9, 5056";

constexpr MetalPreset metals[] = {
    {"gold", {616.8, 548.6, 471.4}, {0.21, 0.43, 1.31}, {3.272, 2.455, 1.849}, noble},
    {"silver", {616.8, 548.6, 471.4}, {0.06, 0.06, 0.05}, {4.152, 3.586, 2.869}, noble},
    {"copper", {616.8, 548.6, 471.4}, {0.30, 1.02, 1.25}, {3.205, 2.577, 2.483}, noble},
    {"aluminium",
     {619.93, 563.57, 476.87},
     {1.3660, 1.0728, 0.72780},
     {7.4052, 6.7839, 5.7781},
     "Rakic 1995, Appl. Opt. 34, 4755"},
    {"iron", {617, 549, 471}, {2.88, 2.95, 2.67}, {3.05, 2.93, 2.82}, transition},
    {"chromium", {617, 549, 471}, {3.17, 3.18, 2.51}, {3.30, 3.33, 3.24}, transition},
    {"nickel", {617, 549, 471}, {1.99, 1.92, 1.78}, {4.02, 3.61, 3.09}, transition},
    {"titanium", {617, 549, 471}, {2.67, 2.54, 2.32}, {3.72, 3.43, 3.10}, transition},
    {"cobalt", {617, 549, 471}, {2.19, 2.05, 1.81}, {4.11, 3.82, 3.41}, transition},
    {"palladium", {617, 549, 471}, {1.75, 1.64, 1.46}, {4.21, 3.84, 3.39}, transition},
    {"platinum",
     {612.52, 544.37, 465.15},
     {2.2607, 2.0699, 1.8796},
     {4.0661, 3.6830, 3.2240},
     "Rakic et al. 1998, Appl. Opt. 37, 5271 (Brendel-Bormann model)"},
    {"brass",
     {610, 550, 470},
     {0.452, 0.527, 0.900},
     {3.345, 2.765, 1.957},
     "Querry 1985, CRDC-CR-85034 (70 % Cu, 30 % Zn)"},
};

// From the authors' dispersion formulas or tables (refractiveindex.info) at the d line, the glasses from the catalogue.
constexpr DielectricPreset dielectrics[] = {
    {"water", 1.3334, 55.8, "Daimon and Masumura 2007, Appl. Opt. 46, 3811 (20 C)"},
    {"ice", 1.3097, 0, "Warren and Brandt 2008, J. Geophys. Res. 113, D14220 (590 nm)"},
    {"ethanol", 1.3617, 0, "Rheims et al. 1997, Meas. Sci. Technol. 8, 601 (20 C)"},
    {"glycerol", 1.4723, 0, "Rheims et al. 1997, Meas. Sci. Technol. 8, 601 (25 C)"},
    {"fused silica", 1.4585, 67.8, "Malitson 1965, J. Opt. Soc. Am. 55, 1205"},
    {"quartz", 1.5443, 69.7, "Ghosh 1999, Opt. Commun. 163, 95 (ordinary ray)"},
    {"glass bk7", 1.5168, 64.17, "SCHOTT optical glass data sheet N-BK7"},
    {"glass f2", 1.62004, 36.37, "SCHOTT optical glass data sheet F2"},
    {"glass sf11", 1.78472, 25.68, "SCHOTT optical glass data sheet N-SF11"},
    {"acrylic", 1.4906, 53.2, "Sultanova et al. 2009, Acta Phys. Pol. A 116, 585 (PMMA)"},
    {"polycarbonate", 1.5848, 27.9, "Sultanova et al. 2009, Acta Phys. Pol. A 116, 585"},
    {"polystyrene", 1.5916, 29.5, "Sultanova et al. 2009, Acta Phys. Pol. A 116, 585"},
    {"plastic", 1.5, 0, "glTF 2.0, appendix B.2: f0 = 0.04 of any common dielectric"},
    {"sapphire", 1.7682, 72.3, "Malitson and Dodge 1972, J. Opt. Soc. Am. 62, 1405 (ordinary ray)"},
    {"cubic zirconia", 2.1588, 33.5, "Wood and Nassau 1982, Appl. Opt. 21, 2978 (12 % yttria)"},
    {"diamond", 2.4175, 55.3, "Peter 1923, Z. Phys. 15, 358"},
    {"cornea", 1.376, 0,
     "Patel and Tutchenko 2019, Cont. Lens Anterior Eye 42, 575: the figure often quoted; measured 1.37 to 1.44"},
    {"skin", 1.52, 0, "Yoshida et al. 2013, J. Biomed. Opt. 18, 037002 (cheek, 550 nm: 1.51 to 1.53)"},
};

template <class Preset>
const Preset* find(std::span<const Preset> presets, std::string_view name) {
  const auto found = std::ranges::find(presets, name, &Preset::name);
  return found == presets.end() ? nullptr : &*found;
}

}  // namespace

glm::dvec3 MetalPreset::f0() const { return F_Conductor(1, eta, k); }
glm::dvec3 MetalPreset::f82() const { return F_Conductor(cosine82, eta, k); }
double DielectricPreset::f0() const { return f0FromIor(ior); }
double DielectricPreset::dispersion() const { return abbe > 0 ? 20 / abbe : 0; }

std::span<const MetalPreset> metalPresets() { return metals; }
std::span<const DielectricPreset> dielectricPresets() { return dielectrics; }
const MetalPreset* findMetal(std::string_view name) { return find(metalPresets(), name); }
const DielectricPreset* findDielectric(std::string_view name) { return find(dielectricPresets(), name); }

}  // namespace facet::optics
