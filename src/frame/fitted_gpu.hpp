#pragma once

// The analytic model that was fitted to a measured BRDF, on the GPU in the table's place.

#include "frame/draw_list.hpp"
#include "frame/measured_gpu.hpp"

namespace facet::frame {

struct FittedOnGpu {
  FittedBrdf fitted;
  gl::Buffer buffer;  // layout::MeasuredUniforms, layout::FittedUniforms
};
std::shared_ptr<const FittedOnGpu> uploadFitted(FittedBrdf fitted);

// Of the store: null where it is not there; in front of the others, of which 64 stay; from it, else fitted and kept.
std::shared_ptr<const FittedOnGpu> keptFit(MeasuredStore& store, const MeasuredSource& source,
                                           optics::DiffuseModel diffuse);
void keepFit(MeasuredStore& store, std::shared_ptr<const FittedOnGpu> made);
Result<std::shared_ptr<const FittedOnGpu>> findFit(MeasuredStore& store, const MeasuredSource& source,
                                                   optics::DiffuseModel diffuse);
// A warning where it reflects more or less than the table by optics::toldAlbedoError.
Notes fitNotes(const FittedBrdf& fitted);

// The fitted model in the table's place, or beside it, as the settings have it.
void setFitted(DrawOptions& options, BrdfCompare compare);

}  // namespace facet::frame
