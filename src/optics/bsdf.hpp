#pragma once

// The metallic-roughness surface of glTF 2.0, lit from one direction: GGX and Lambert, energy kept.

#include <glm/glm.hpp>

#include "optics/energy.hpp"

namespace facet::optics {

struct Surface {
  glm::dvec3 baseColor{1};  // linear
  double metallic = 1;
  double perceptualRoughness = 1;
};

double alphaOf(const Surface& surface);             // perceptualRoughness^2
glm::dvec3 f0Of(const Surface& surface);            // mix(0.04, baseColor, metallic)
glm::dvec3 diffuseColorOf(const Surface& surface);  // baseColor (1 - metallic)
Dfg dfgOf(const Surface& surface, double NoV);

// BSDF times NoL [1/sr], the two lobes apart.
struct Reflected {
  glm::dvec3 specular{0}, diffuse{0};
};
// specular = D V F NoL (1 + f0 (1 / E - 1)), Turquin's compensation; diffuse = diffuseColor / pi (1 - Es) NoL with Es
// the directional albedo, at V, of that very specular lobe, per channel. So white reflects exactly all of a white
// furnace (metallic 0 or 1). Both factors look at V only: the sum is not reciprocal, D V F is. 0 if V or L is below the
// horizon; alpha = 0 has no specular value here (a delta). dfg = dfgOf(surface, NoV), passed in because it costs an
// integral.
Reflected reflect(const Surface& surface, const Dfg& dfg, const glm::dvec3& N, const glm::dvec3& V,
                  const glm::dvec3& L);

}  // namespace facet::optics
