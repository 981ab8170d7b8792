#pragma once

// Measured BRDFs on the GPU: packed, with the lobe that samples of them are drawn from. The last few stay.

#include <cstddef>
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
// No OpenGL here: on any thread. Errors: as io::resolveMeasured and io::readMeasured have them.
Result<MeasuredBytes> readMeasuredBytes(const MeasuredSource& source);

struct MeasuredOnGpu {
  MeasuredFacts facts;
  gl::Buffer buffer;
};

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(MeasuredBytes read);
std::shared_ptr<const MeasuredOnGpu> uploadMeasured(const optics::MeasuredBrdf& brdf);
size_t measuredBytes(const optics::MeasuredBrdf& brdf);  // of its buffer

inline constexpr size_t measuredBudget = size_t{128} << 20;  // bytes on the GPU; ten of MERL's

struct FittedOnGpu;  // fitted_gpu.hpp

struct MeasuredStore {
  std::list<std::shared_ptr<const MeasuredOnGpu>> kept;  // the last used first
  std::list<std::shared_ptr<const FittedOnGpu>> fits;    // likewise
};
// Null where it is not there.
std::shared_ptr<const MeasuredOnGpu> keptMeasured(MeasuredStore& store, const MeasuredSource& source);
// In the place of what was made of the same source before, fits too; what was not used longest goes where the budget is
// exceeded.
void keepMeasured(MeasuredStore& store, std::shared_ptr<const MeasuredOnGpu> made);
// From the store, else read, uploaded and kept. Notes: the table's, each time.
Result<std::shared_ptr<const MeasuredOnGpu>> findMeasured(MeasuredStore& store, const MeasuredSource& source,
                                                          Notes& notes);

void setMeasured(shading::FrameFeatures& features, const Look& look, optics::MeasuredKind kind,
                 const optics::MeasuredProxy& proxy);

}  // namespace facet::frame
