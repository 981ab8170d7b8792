#pragma once

// Measured BRDFs on the GPU: packed, with the lobe that samples of them are drawn from. The last few stay.

#include <cstdint>
#include <glm/glm.hpp>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/settings.hpp"
#include "gl/buffer.hpp"
#include "optics/measured.hpp"
#include "optics/measured_proxy.hpp"
#include "shading/features.hpp"

namespace facet::frame {

// Three halves a cell, 8 bytes, in units of a power of two that puts the largest value at 2^14 to 2^15: off by 2^-11 of
// the value (4.9e-4), below 2^-29 of the largest by 2^-40 of that. Missing cells: -1.
struct PackedBrdf {
  float scale = 1;
  std::vector<glm::uvec2> cells;
};
PackedBrdf packMeasured(const optics::MeasuredBrdf& brdf);
// The table with the values that the GPU reads.
optics::MeasuredBrdf unpackMeasured(const PackedBrdf& packed, const optics::MeasuredBrdf& like);

// What a BRDF is found by again.
struct MeasuredSource {
  std::string name;  // a path, builtin:NAME or the name of a database
  std::string folder;
  io::UtiaDecode decode = io::UtiaDecode::raw;
  bool operator==(const MeasuredSource&) const = default;
};
MeasuredSource measuredSource(const PictureSettings& settings);

struct MeasuredTimes {
  double readMs = 0, fitMs = 0, packMs = 0, uploadMs = 0;  // read: and checked
};

struct MeasuredOnGpu {
  MeasuredSource source;
  std::string name;
  optics::MeasuredKind kind = optics::MeasuredKind::merl;
  optics::MeasuredProxy proxy;
  gl::Buffer buffer;  // layout::MeasuredUniforms, then the cells
  Notes notes;
  MeasuredTimes times;
};

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(const optics::MeasuredBrdf& brdf);
size_t measuredBytes(const optics::MeasuredBrdf& brdf);  // of its buffer

inline constexpr size_t measuredBudget = size_t{128} << 20;  // bytes on the GPU; ten of MERL's

struct MeasuredStore {
  std::list<std::shared_ptr<const MeasuredOnGpu>> kept;  // the last used first
};
// From the store, else read and uploaded; what was not used longest goes where the budget is exceeded. Notes: the
// table's, each time. Errors: as io::resolveMeasured and io::readMeasured have them.
Result<std::shared_ptr<const MeasuredOnGpu>> findMeasured(MeasuredStore& store, const MeasuredSource& source,
                                                          Notes& notes);

void setMeasured(shading::FrameFeatures& features, const PictureSettings& settings, optics::MeasuredKind kind);

}  // namespace facet::frame
