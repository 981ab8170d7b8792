#pragma once

// Measured BRDFs as the GPU will have them: packed, with the lobe that samples of them are drawn from; and the analytic
// model that comes closest. No OpenGL, on any thread.

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"
#include "io/utia.hpp"
#include "optics/measured.hpp"
#include "optics/measured_fit.hpp"
#include "optics/measured_proxy.hpp"

namespace facet::frame {

// Four halves a cell, 8 bytes: red, green and blue in units of the fourth, a power of two of the cell's own, so that
// the dim cells beside a highlight 10^9 times as bright keep their digits: off by 2^-11 of the value (4.9e-4), of a
// channel below 2^-14 of the cell's largest by 2^-25 of that. From 2^-38 to 2^31 per steradian. Missing cells: -1.
std::vector<glm::uvec2> packMeasured(const optics::MeasuredBrdf& brdf);
// The table with the values that the GPU reads.
optics::MeasuredBrdf unpackMeasured(const std::vector<glm::uvec2>& cells, const optics::MeasuredBrdf& like);

// What a BRDF is found by again.
struct MeasuredSource {
  std::string name;  // a path, builtin:NAME or the name of a database
  std::string folder;
  io::UtiaDecode decode = io::UtiaDecode::raw;
  bool operator==(const MeasuredSource&) const = default;
};
MeasuredSource measuredSource(const Sources& sources);

struct MeasuredTimes {
  double readMs = 0, fitMs = 0, packMs = 0, uploadMs = 0;  // read: and checked; fit: of the lobe
};

// What is known of a measured BRDF besides its values.
struct MeasuredFacts {
  MeasuredSource source;
  std::string path;  // where it was found; a built-in one: its name
  std::string name;
  optics::MeasuredKind kind = optics::MeasuredKind::merl;
  size_t cells = 0, missing = 0, holes = 0;  // holes: missing ones above the horizon, which were filled
  double guessed = 0;                        // their share of the light that it reflects
  optics::MeasuredProxy proxy;
  Notes notes;
  MeasuredTimes times;
};

// layout::MeasuredUniforms, then the cells, as they are uploaded.
struct MeasuredBytes {
  MeasuredFacts facts;
  std::unique_ptr<std::byte[]> bytes;
  size_t size = 0;
};
size_t measuredBytes(const optics::MeasuredBrdf& brdf);  // their size
MeasuredBytes packedBytes(const optics::MeasuredBrdf& brdf);
// Errors: as io::resolveMeasured and io::readMeasured have them.
Result<optics::MeasuredBrdf> readMeasuredTable(const MeasuredSource& source);
Result<MeasuredBytes> readMeasuredBytes(const MeasuredSource& source);

// GGX over one diffuse model, by the least mean square of ln(1 + f NoL).
struct FittedBrdf {
  MeasuredSource source;
  std::string name;
  optics::MeasuredKind kind = optics::MeasuredKind::merl;
  optics::BrdfFit fit;
  double readMs = 0, fitMs = 0;
};
// Reads the table again. Errors: as readMeasuredBytes has them.
Result<FittedBrdf> fitMeasured(const MeasuredSource& source, optics::DiffuseModel diffuse);

}  // namespace facet::frame
