#pragma once

// What a plan has put on the GPU -> one picture, read back.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/stages.hpp"
#include "frame/display_pass.hpp"
#include "frame/gather.hpp"
#include "frame/max_error.hpp"
#include "frame/plan.hpp"
#include "frame/value_range.hpp"

namespace facet::frame {

// Targets for one draw of settings.samples, or for gathering that many draws.
// rows: of the picture that they hold at once; 0: all.
// corrected: by rays, which takes a draw for each sample.
Targets createTargets(const PictureSettings& settings, const gl::ContextInfo& context, int rows = 0,
                      bool precise = false, bool corrected = false);

// What rays are traced through.
struct TracedStatistics {
  int triangles = 0;
  size_t bytes = 0;
  double buildMs = 0;  // of its trees
};

// The light on the floor.
struct GroundStatistics {
  int size = 0, samples = 0;  // points along an axis, samples of each
  uint64_t rays = 0;
  double milliseconds = 0;  // waited for
};

struct PictureStatistics {
  FrameStatistics frame;  // of all bands
  int bands = 1;
  std::vector<PassTime> passTimes;  // where asked for
  int imagesDecoded = 0;
  int programsCompiled = 0, programsFromDisk = 0;
  std::vector<ibl::TableStatistics> tables;
  std::vector<const ibl::Candidate*> methods;  // of the tables, where an error decides
  size_t textureBytes = 0, geometryBytes = 0, tableBytes = 0, targetBytes = 0;
  std::map<std::string, int> variants;  // programs by name (shading::variantName) -> draws, before culling
  uint64_t clampedPixels = 0;  // all samples of a channel at the largest that is stored; counted where radiance is read
  uint64_t nonFinitePixels = 0;                 // likewise
  std::vector<double> frameMs;                  // the first frame, then the repeated ones; each waited for
  std::optional<ComparisonFigures> comparison;  // of a measured BRDF with the model fitted to it, where both are drawn
  std::optional<double> gridSpacing;            // metres; where a grid is drawn over the picture
  std::string overlayRemark;                    // OverlayLines::remark
  std::optional<RangeShown> range;              // where a channel is shown in false colours
  VisibilityChosen visibility;
  std::optional<TracedStatistics> traced;  // where paths are
  std::optional<GroundStatistics> ground;  // where there is a floor
  std::vector<Attempt> attempts;           // with more and more samples; only where an error is to be kept to
};

struct Picture {
  io::RadianceImage radiance;  // where asked for
  io::Pixels display;          // where asked for
  // Of each pixel's radiance, where asked for and where the picture is gathered; its alpha's in alpha.
  io::RadianceImage standardError;
  PictureStatistics statistics;
};

struct PictureRequest {
  // Radiance alone is drawn in single precision; what is shown is drawn in halves, as the window draws it, and so is
  // radiance beside it.
  bool radiance = false, display = false;
  bool deep = false;      // what is shown in 16 bits a channel, drawn in single precision
  bool estimate = false;  // of the noise of what converges (FrameStatistics::parts), also without an error to keep to
  bool standardError = false;  // of each pixel
  bool passTimes = false;      // of the last frame that is drawn, which takes a little longer by that
  int repeat = 0;              // further frames, for timing
  // Nothing is rendered after this: Session frees in main memory what is on the GPU by then.
  bool last = false;

  bool precise() const { return deep || (radiance && !display); }
};

// Runs a plan to its end. notes: the list's. statistics: what that took.
Result<Drawable> preparePicture(const PictureSettings& settings, const PictureRequest& request, LoadedScene& scene,
                                const Supply& supply, shading::ProgramStore& programs, PictureStatistics& statistics,
                                Notes& notes, Stages& stages);

// Draws and reads back. Band by band where the targets of the whole would be large. statistics: preparePicture's.
Result<Picture> drawPicture(const PictureSettings& settings, const PictureRequest& request, const Drawable& drawable,
                            PictureStatistics statistics, shading::ProgramStore& programs,
                            const gl::ContextInfo& context, Stages& stages);

// A picture that is not gathered, on its way. What it is drawn from must stay while it lasts.
struct SlicedPicture {
  int bandRows = 0;  // of the picture that are drawn as one
  Targets band;      // of so many rows; none: they are all
  int firstRow = 0;  // of the band that is under way
  std::optional<Gathering> gathering;
  FrameStatistics statistics;  // of the bands that are done
};
// inBands: as drawPicture draws it, to the last bit; else as one.
SlicedPicture beginSlices(const FrameInput& in, const gl::ContextInfo& context, bool inBands);
// So many rows more, as far as the band has them, into targets of the whole. True where it is complete.
Result<bool> drawSlice(FrameInput in, const Targets& targets, SlicedPicture& picture, int64_t rows,
                       shading::ProgramStore& programs);

// All of it, in its bands.
Result<FrameStatistics> drawInBands(const FrameInput& in, const Targets& targets, shading::ProgramStore& programs,
                                    const gl::ContextInfo& context);

}  // namespace facet::frame
