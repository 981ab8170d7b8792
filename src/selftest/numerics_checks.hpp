#pragma once

// The rows of numericalChecks() by subject.

#include "selftest/numerics.hpp"

namespace facet::selftest {

// Distance between 1 and the next float: tolerances are multiples of it.
inline constexpr double floatEpsilon = 0x1p-23;

std::vector<Check> surfaceChecks();      // microfacet, fresnel, diffuse, energy, bsdf, image_light
std::vector<Check> modelChecks();        // fresnel (exact), diffuse models, ndf
std::vector<Check> choiceChecks();       // models: what --diffuse, --fresnel, --ndf, --masking, --energy choose
std::vector<Check> lobeChecks();         // single lobes and terms of the extensions
std::vector<Check> layerChecks();        // transmission, layers
std::vector<Check> layeredChecks();      // bsdf with all layers, anisotropy's albedo
std::vector<Check> transmittedChecks();  // what is seen through glass
std::vector<Check> lightChecks();        // lights
std::vector<Check> samplingChecks();     // the lobes' samplers and densities, bsdf_sampling
std::vector<Check> measuredChecks();     // measured, measured_table, measured_fitted
std::vector<Check> lookUpChecks();       // dfg_table, sheen_table, image_light_taps
std::vector<Check> displayChecks();      // color
std::vector<Check> mappingChecks();      // mapping, environment_layers, zonal

}  // namespace facet::selftest
