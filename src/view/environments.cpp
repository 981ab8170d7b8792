#include "view/environments.hpp"

#include <algorithm>
#include <chrono>

#include "base/log.hpp"
#include "gl/context.hpp"

namespace facet::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double sliceMs = 25;  // GPU time of the steps between two frames

// Coarse tables: wide filters and few samples.
constexpr ibl::Method previewMethod{.cube = ibl::CubeMethod::oneTap,
                                    .equirectWidth = 256,
                                    .ld = ibl::LdMethod::filtered,
                                    .samples = 4,
                                    .sumSize = 8,
                                    .irradianceSize = 8};

bool covers(const ibl::Needs& have, const ibl::Needs& wanted) {
  return have.background >= wanted.background && have.irradiance >= wanted.irradiance && have.layers >= wanted.layers &&
         have.cube >= wanted.cube && have.samples >= wanted.samples && have.texels >= wanted.texels &&
         have.backgroundBlur == wanted.backgroundBlur && have.lowestRoughness <= wanted.lowestRoughness &&
         have.highestRoughness >= wanted.highestRoughness;
}

void logTables(const ibl::Tables& tables) {
  for (const ibl::TableStatistics& table : tables.statistics)
    log::debug("table: " + table.name + ", " + std::to_string(std::lround(table.milliseconds)) + " ms");
}

bool isSmall(const EnvironmentSlot& slot) {
  return slot.environment && slot.environment->radiance.size() <= ibl::backgroundTexelsAtOnce;
}

// Of what depends on the environment.
std::vector<gl::Texture ibl::Tables::*> absentTables(const ibl::Tables& tables) {
  using ibl::Tables;
  std::vector<gl::Texture Tables::*> absent;
  for (gl::Texture Tables::*table : {&Tables::irradiance, &Tables::mirrorLayers, &Tables::roughLayers, &Tables::cube,
                                     &Tables::rest, &Tables::lamps, &Tables::lampPoints, &Tables::background})
    if (!(tables.*table)) absent.push_back(table);
  return absent;
}

// Steps, waiting for each, until the time is over.
Result<void> runFor(ibl::Precompute& work, double ms) {
  const auto start = Clock::now();
  while (!work.done() && std::chrono::duration<double, std::milli>(Clock::now() - start).count() < ms) {
    if (Result<void> r = ibl::runStep(work); !r) return r;
    glFinish();
  }
  return {};
}

}  // namespace

size_t EnvironmentSlot::bytes() const {
  size_t texels = environment ? environment->radiance.size() : 0;
  if (prepared) texels += prepared->reduced.radiance.size();
  return texels * sizeof(glm::vec3) + tables.bytes();
}

Result<void> provideTables(EnvironmentSlot& slot, const ibl::Needs& needs, shading::ProgramStore& programs,
                           double immediateMs) {
  ibl::Tables& tables = slot.tables;
  if (slot.sharpening && slot.sharpening->method != slot.method) cancelSharpening(slot);
  // What does not depend on the environment, and a small map as background, which is not worth a preview.
  const ibl::Needs cheap{
      .dfg = needs.dfg, .taps = needs.taps, .sheen = needs.sheen, .background = needs.background && isSmall(slot)};
  if (Result<void> r = frame::prepareTables(slot, cheap, programs); !r) return r;
  logTables(tables);
  if (slot.preview && covers(slot.sharpening->needs, needs)) return {};
  if (slot.preview) cancelSharpening(slot);
  if (Result<void> r = ibl::loadTables(tables, slot.environment.get(), slot.content, needs, slot.cache, slot.method);
      !r)
    return r;
  logTables(tables);
  const std::vector<ibl::Piece> missing = ibl::missingPieces(tables, needs);
  const bool texels = needs.texels && !tables.texels;
  const bool blur = ibl::missesBlur(tables, needs);
  if (missing.empty() && (!needs.background || tables.background) && !texels && !blur) return {};
  const ibl::PreparedEnvironment* const prepared = slot.prepared.get();
  ibl::Precompute work = ibl::planTables(tables, slot.environment.get(), prepared, needs, programs, slot.method);
  slot.toStore.insert(slot.toStore.end(), missing.begin(), missing.end());
  if (Result<void> r = runFor(work, immediateMs); !r) return slot.toStore.clear(), r;
  if (Result<void> r = gl::checkDriver(ibl::tablesOfLight); !r) return slot.toStore.clear(), r;
  if (work.done()) return ibl::finish(std::move(work), tables), Result<void>();
  // Of the reduced map, the background among them.
  Sharpening sharpening{.work = std::move(work),
                        .needs = needs,
                        .method = slot.method,
                        .timer = gl::Timer::create(),
                        .coarse = absentTables(tables),
                        .coarseBlur = blur,
                        .finalLayers = tables.layersMade};
  const ibl::PreparedEnvironment small = ibl::reducedFurther(*prepared, previewMethod.equirectWidth);
  if (Result<void> r = ibl::computeTables(tables, &prepared->reduced, needs, programs, previewMethod, &small); !r)
    return r;
  logTables(tables);
  slot.sharpening = std::move(sharpening);
  slot.preview = true;
  return {};
}

Result<bool> sharpen(EnvironmentSlot& slot) {
  if (!slot.sharpening) return false;
  Sharpening& s = *slot.sharpening;
  if (s.pending) {
    if (!s.timer.ready()) return false;
    s.pending = false;
    s.msPerFetch =
        std::max(s.timer.milliseconds(), s.issueMs) / static_cast<double>(std::max<uint64_t>(1, s.issuedFetches));
  }
  if (s.work.done()) {
    if (Result<void> r = gl::checkDriver(ibl::tablesOfLight); !r) return tl::unexpected(r.error());
    ibl::finish(std::move(s.work), slot.tables);
    slot.sharpening.reset();
    slot.preview = false;
    log::debug("tables sharpened: " + slot.source);
    return true;
  }
  const auto start = Clock::now();
  s.timer.begin();
  s.issuedFetches = 0;
  Result<void> done;
  do {  // one where their cost is not known yet
    s.issuedFetches += s.work.steps[s.work.next].fetches;
    done = ibl::runStep(s.work);
  } while (done && !s.work.done() && s.msPerFetch > 0 &&
           static_cast<double>(s.issuedFetches + s.work.steps[s.work.next].fetches) * s.msPerFetch < sliceMs);
  s.timer.end();
  glFlush();
  s.pending = true;
  s.issueMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  if (!done) return tl::unexpected(done.error());
  return false;
}

void cancelSharpening(EnvironmentSlot& slot) {
  const std::optional<Sharpening> cancelled = std::exchange(slot.sharpening, std::nullopt);
  slot.toStore.clear();
  slot.packed.clear();
  if (!std::exchange(slot.preview, false)) return;
  for (gl::Texture ibl::Tables::*table : cancelled->coarse) slot.tables.*table = {};
  if (cancelled->coarseBlur) slot.tables.blurred = {};
  slot.tables.layersMade = cancelled->finalLayers;
}

EnvironmentSlot* findEnvironment(const Environments& environments, const std::string& source) {
  for (const auto& slot : environments.slots)
    if (slot->source == source && !slot->stale) return slot.get();
  return nullptr;
}

void showEnvironment(Environments& environments, EnvironmentSlot* slot) {
  if (environments.shown && environments.shown != slot) cancelSharpening(*environments.shown);
  environments.shown = slot;
  auto& slots = environments.slots;
  const auto found = std::ranges::find(slots, slot, [](const auto& s) { return s.get(); });
  std::rotate(slots.begin(), found, found + 1);
  size_t kept = 0;
  std::erase_if(slots, [&](const auto& s) { return s->stale && s.get() != slot; });
  std::erase_if(slots, [&](const auto& s) { return s.get() != slot && (kept += s->bytes()) > keptBytes; });
}

bool storeTables(Environments& environments) {
  EnvironmentSlot* slot = environments.shown;
  if (!slot || slot->sharpening || (slot->toStore.empty() && slot->packed.empty())) return false;
  if (slot->cache.disk.folder.empty()) return slot->toStore.clear(), false;
  if (!slot->toStore.empty()) {
    slot->packed.push_back(
        ibl::packPiece(slot->tables, slot->toStore.back(), slot->content, slot->cache, slot->method));
    slot->toStore.pop_back();
    return true;
  }
  const bool busy = environments.storing.valid() &&
                    environments.storing.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
  if (busy) return true;
  environments.storing = std::async(std::launch::async, [disk = slot->cache.disk, packed = std::move(slot->packed)] {
    for (const ibl::PackedPiece& piece : packed) writeCached(disk, piece.key, piece.bytes);
  });
  slot->packed.clear();
  return false;
}

}  // namespace facet::view
