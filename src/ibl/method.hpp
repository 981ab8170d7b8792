#pragma once

// How the environment's tables are made: the choices that stand side by side, and their parameters. `facet report
// light` measures what each costs and how wrong it is.

namespace facet::ibl {

// Equirectangular map -> cube.
enum class CubeMethod {
  oneTap,     // a bilinear look-up in each texel's middle, as is usual
  areaExact,  // mean over the texel's solid angle from taps x taps samples, steepTaps where they differ much
};

// Layers of LD.
enum class LdMethod {
  importance,  // the lobe sampled, Hammersley points, unfiltered (Karis 2013)
  filtered,  // the same number of equal shares on a spiral, each reading the level of its size (Krivanek, Colbert 2008)
  mixture,   // a mixture of blurred copies (optics/zonal.hpp)
  cut,       // a sum over an adaptive cut through a tree of texels (ibl/cut.hpp): slow, and near the truth everywhere
};

enum class IrradianceMethod {
  summed,     // over few cells of the cube, by centroid and spread: the layer of roughness 1, because LD(n, 1) =
              // irradiance / pi
  riemann,    // steps of 0.025 in both angles over the whole cube, as is usual
  harmonics,  // spherical harmonics up to an order (Ramamoorthi and Hanrahan 2001)
};

enum class DfgMethod {
  legendre,    // Gauss-Legendre over the visible normals; columns NoV = u^2, end points included
  importance,  // NDF sampled, Hammersley; columns NoV = u, texel centres, as is usual
};

struct Method {
  CubeMethod cube = CubeMethod::areaExact;
  int cubeTaps = 4;          // per texel along each axis
  int steepTaps = 16;        // where the taps differ by more than steepness times the map's mean radiance: suns, lamps.
  double steepness = 16;     // At most a sixteenth of the sphere is that bright, so the cost is bounded
  int equirectWidth = 1024;  // a wider map is first reduced, texels weighted by solid angle

  LdMethod ld = LdMethod::mixture;
  int samples = 1024;          // importance, filtered: in each texel
  double filterGain = 1;       // filtered: K, the level's texels in shares of a sample
  int sumSize = 8;             // mixture, irradiance: cells along the edge of a face that are summed over
  double cutTolerance = 0.01;  // cut: largest error of a node, of the result
  double cutAcross = 1.5;      // cut: nodes across the kernel's scale, at least
  bool cutByG2 = false;        // cut: the kernel D G2(N = V) in place of D NoL
  bool takeSunOut = false;     // scene::findSun: Tables::sun is what was taken, the tables hold the rest

  IrradianceMethod irradiance = IrradianceMethod::summed;
  int irradianceSize = 32;  // face of the irradiance map
  int harmonicsOrder = 4;

  DfgMethod dfg = DfgMethod::legendre;
  int dfgSize = 64;
  int dfgRadii = 32, dfgAngles = 8;  // legendre: nodes over the visible normals
  int dfgSamples = 1024;             // importance

  int sheenSize = 64;
  int sheenHeights = 32, sheenAngles = 16;  // Gauss-Legendre nodes over the light's height and azimuth

  bool operator==(const Method&) const = default;
};

}  // namespace facet::ibl
