#pragma once

// Environments on the GPU. One that is shown for the first time is lit by coarse tables at once; the final ones are
// made beside it in small steps. Those that were shown last stay, so that going back to one is free.

#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frame/plan.hpp"
#include "gl/timer.hpp"

namespace facet::view {

// Final tables in the making.
struct Sharpening {
  ibl::Precompute work;
  ibl::Needs needs;
  ibl::Method method;
  gl::Timer timer;
  bool pending = false;  // steps are on their way through the GPU
  uint64_t issuedFetches = 0;
  double issueMs = 0;     // CPU time of the last steps
  double msPerFetch = 0;  // of the last steps; 0: not known yet
  // What of the slot's tables is coarse, and which layers are final.
  std::vector<gl::Texture ibl::Tables::*> coarse = {};
  bool coarseBlur = false;
  std::array<bool, layout::ldLayerCount> finalLayers = {};
};

struct EnvironmentSlot : frame::LoadedEnvironment {
  bool stale = false;    // its file has been read again since
  bool preview = false;  // some of the tables are coarse
  std::optional<Sharpening> sharpening;
  std::vector<ibl::Piece> toStore;       // final, not in the disk cache yet
  std::vector<ibl::PackedPiece> packed;  // likewise, read back

  size_t bytes() const;  // texels in main memory and tables
};

// Makes what is needed: from the disk cache, else within the time, else coarse, and sharpen() makes the final ones.
// Does nothing where they are there or under way.
Result<void> provideTables(EnvironmentSlot& slot, const ibl::Needs& needs, shading::ProgramStore& programs,
                           double immediateMs);

// The next steps, where the last ones are through. True where the final tables have come.
Result<bool> sharpen(EnvironmentSlot& slot);

// What is coarse or under way is dropped; what is final stays.
void cancelSharpening(EnvironmentSlot& slot);

struct Environments {
  std::vector<std::unique_ptr<EnvironmentSlot>> slots;  // most recently shown first
  EnvironmentSlot* shown = nullptr;
  double immediateMs = 20;    // what takes longer is shown coarse first
  std::future<void> storing;  // into the disk cache, beside the window
};

EnvironmentSlot* findEnvironment(const Environments& environments, const std::string& source);

// Shows it; what the one before had under way is cancelled. Of those that are not shown as many stay as fit into
// keptBytes.
inline constexpr size_t keptBytes = size_t{256} << 20;
void showEnvironment(Environments& environments, EnvironmentSlot* slot);

// A little of what is left to be stored of the shown one's tables. False where nothing is left.
bool storeTables(Environments& environments);

}  // namespace facet::view
