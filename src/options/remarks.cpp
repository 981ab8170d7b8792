#include "options/remarks.hpp"

#include <cstdio>

#include "frame/max_error.hpp"
#include "frame/settings.hpp"

namespace facet::options {

namespace {

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

void add(Remarks& remarks, const std::string& reached) {
  remarks.reached += (remarks.reached.empty() ? ": " : "; ") + reached;
}

void warn(Remarks& remarks, std::string text) {
  remarks.notes.push_back({Note::Severity::warning, "", std::move(text)});
}

// What --max-error came to.
void addError(Remarks& remarks, double wanted, const frame::Attempt& last) {
  const std::string samples = std::to_string(last.samples) + " samples";
  const std::string reached = percent(last.error.most / 255);
  if (frame::errorMargin * last.error.most / 255 > wanted)
    warn(remarks, "--max-error: after " + samples + " the error may be up to " + reached + ", where " +
                      percent(wanted / frame::errorMargin) +
                      " would keep to it; give more --samples, or a larger error than " + percent(wanted));
  add(remarks, samples + ", error up to " + reached);
}

}  // namespace

Remarks remarksOn(const frame::PictureSettings& settings, const frame::PictureStatistics& statistics, bool radiance) {
  Remarks remarks;
  if (statistics.nonFinitePixels > 0)
    warn(remarks, std::to_string(statistics.nonFinitePixels) + " pixels are not finite");
  if (!statistics.attempts.empty()) addError(remarks, *settings.quality.maxError, statistics.attempts.back());
  if (statistics.gridSpacing) {
    char text[48];
    std::snprintf(text, sizeof text, "grid of %.3g m", *statistics.gridSpacing);
    add(remarks, text);
  }
  if (settings.frame.backgroundBlur > 0 &&
      (settings.frame.background != frame::Background::environment || settings.sources.environment == "none"))
    warn(remarks, "--background-blur: no environment is seen behind the model");
  if (!statistics.overlayRemark.empty()) warn(remarks, "--overlay: " + statistics.overlayRemark);
  if (settings.overlays.shown != 0 && radiance)
    warn(remarks, "--overlay: an EXR is the radiance below it; end -o in .png");
  if (statistics.range && !radiance) add(remarks, frame::describe(*statistics.range));
  return remarks;
}

}  // namespace facet::options
