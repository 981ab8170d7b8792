#pragma once

// Measured BRDFs on the GPU. The last few stay.

#include <list>
#include <memory>

#include "base/error.hpp"
#include "frame/measured_read.hpp"
#include "frame/settings_fwd.hpp"
#include "gl/buffer.hpp"
#include "shading/features.hpp"

namespace facet::frame {

struct MeasuredOnGpu {
  MeasuredFacts facts;
  gl::Buffer buffer;
};

std::shared_ptr<const MeasuredOnGpu> uploadMeasured(MeasuredBytes read);
std::shared_ptr<const MeasuredOnGpu> uploadMeasured(const optics::MeasuredBrdf& brdf);

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
