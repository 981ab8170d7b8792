#include "view/load_time.hpp"

#include <algorithm>
#include <cmath>

#include "base/log.hpp"

namespace facet::view {

namespace {

std::string rounded(double milliseconds) { return std::to_string(std::lround(milliseconds)) + " ms"; }

}  // namespace

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void noteGap(LoadTime& load, bool loading) {
  const double gap = millisecondsSince(load.frame);
  if (load.running && loading) load.longestGap = std::max(load.longestGap, gap);
  if (load.running && !loading)
    log::debug("loaded; the longest gap between frames was " + rounded(load.longestGap) + ", the first new one took " +
               rounded(gap));
  if (!loading) load.longestGap = 0;
  load.running = loading;
  load.frame = std::chrono::steady_clock::now();
}

void noteSlowTurn(std::chrono::steady_clock::time_point start) {
  if (const double spent = millisecondsSince(start); spent > 50) log::debug("turn of " + rounded(spent));
}

void noteMeasuredShown(Viewport& viewport) {
  if (!viewport.measured.asked || shownMeasured(viewport.shown) != viewport.measured.asked->source) return;
  log::debug("measured BRDF on the screen after " + rounded(millisecondsSince(viewport.measured.asked->since)) + ": " +
             viewport.shown.inputs.list.measured->facts.name);
  viewport.measured.asked.reset();
}

}  // namespace facet::view
