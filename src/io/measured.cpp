#include "io/measured.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

#include "base/nearest.hpp"
#include "io/merl.hpp"
#include "io/safe_files.hpp"
#include "io/sources.hpp"
#include "io/uri.hpp"
#include "optics/measured_holes.hpp"
#include "optics/synthetic_brdf.hpp"

namespace facet::io {

namespace fs = std::filesystem;

namespace {

constexpr double toldEnergy = 1e-3;  // a guessed share of the light from which on it is a warning

constexpr std::array<std::string_view, 3> decodeNames = {"raw", "srgb", "srgb140"};

// Picture formats that are often confused with data, by their first bytes.
std::string_view otherFormat(std::span<const uint8_t> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), std::min<size_t>(bytes.size(), 12));
  if (text.starts_with("\x89PNG")) return "a PNG picture";
  if (text.starts_with("\xff\xd8\xff")) return "a JPEG picture";
  if (text.starts_with("\x76\x2f\x31\x01")) return "an OpenEXR picture";
  if (text.starts_with("PK")) return "a ZIP archive";
  if (text.starts_with("tensor_file")) return "an RGL .bsdf file";
  return {};
}

tl::unexpected<Error> unknownKind(const std::string& path, std::span<const uint8_t> bytes) {
  const std::string remedy = "a MERL .binary file has " + std::to_string(merlBytes(optics::merlPhiSteps)) +
                             " bytes, a UTIA .bin file " + std::to_string(utiaBytes);
  if (bytes.empty()) return fail(path, "", "is empty", remedy);
  if (const std::string_view other = otherFormat(bytes); !other.empty())
    return fail(path, "", "is " + std::string(other) + ", not a measured BRDF", remedy);
  if (bytes.size() == merlBytes(optics::merlPhiSteps) || bytes.size() == largestMerl)
    return tl::unexpected(decodeMerl(bytes, path).error());  // which says what is wrong with the dimensions
  return fail(path, "", "is no measured BRDF that facet reads: " + std::to_string(bytes.size()) + " bytes", remedy);
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100 * share);
  return text;
}

Result<optics::MeasuredBrdf> makeBuiltin(std::string_view name) {
  if (const optics::SyntheticBrdf* found = optics::findSynthetic(name))
    return optics::makeMeasured(found->formula, found->kind, found->name);
  std::vector<std::string_view> names;
  for (const optics::SyntheticBrdf& brdf : optics::syntheticBrdfs()) names.push_back(brdf.name);
  return fail({}, inQuotes(std::string(builtinPrefix) + std::string(name)), "there is no such built-in BRDF",
              suggestion(name, names));
}

}  // namespace

std::span<const std::string_view> utiaDecodeNames() { return decodeNames; }

Result<UtiaDecode> parseUtiaDecode(std::string_view name) {
  const auto found = std::find(decodeNames.begin(), decodeNames.end(), name);
  if (found != decodeNames.end()) return static_cast<UtiaDecode>(found - decodeNames.begin());
  return fail({}, {}, inQuotes(name) + " is not known", suggestion(name, {decodeNames.begin(), decodeNames.end()}));
}

Result<optics::MeasuredBrdf> readMeasured(const std::string& pathOrName, const MeasuredOptions& options) {
  if (pathOrName.starts_with(builtinPrefix)) {
    Result<optics::MeasuredBrdf> brdf = makeBuiltin(std::string_view(pathOrName).substr(builtinPrefix.size()));
    if (brdf) optics::fillHoles(*brdf);  // has none, but cells that reach above the horizon with a corner alone
    return brdf;
  }
  const Result<FileBytes> bytes = readRegularFile(pathOrName, largestMerl);
  if (!bytes) return tl::unexpected(bytes.error());
  Result<optics::MeasuredBrdf> brdf = isMerl(bytes->span()) ? decodeMerl(bytes->span(), pathOrName)
                                      : bytes->size == utiaBytes
                                          ? decodeUtia(bytes->span(), pathOrName, options.utiaDecode)
                                          : unknownKind(pathOrName, bytes->span());
  if (!brdf) return brdf;
  brdf->name = fs::path(pathOrName).stem().string();
  if (const size_t unreached = optics::fillHoles(*brdf); unreached > 0)
    return fail(pathOrName, "",
                std::to_string(unreached) + " of its " + std::to_string(brdf->values.size()) +
                    " cells hold no value, are above the horizon and have no neighbours to fill them from",
                "copy or download it again");
  return brdf;
}

Notes measuredNotes(const optics::MeasuredBrdf& brdf) {
  using enum Note::Severity;
  const bool merl = brdf.kind == optics::MeasuredKind::merl;
  Notes notes;
  const auto say = [&](Note::Severity severity, std::string text) { notes.push_back({severity, "", std::move(text)}); };
  const auto cells = [&](size_t count, const char* what) {
    return std::to_string(count) + " of " + std::to_string(brdf.values.size()) + " cells hold " + what +
           " and count as missing";
  };
  if (merl && brdf.phiSteps != optics::merlPhiSteps)
    say(info, "360 steps of phi_d in the place of MERL's 180: looked up without assuming reciprocity");
  if (brdf.counts.notANumber > 0) say(warning, cells(brdf.counts.notANumber, "NaN"));
  if (brdf.counts.infinite > 0) say(warning, cells(brdf.counts.infinite, "infinite values"));
  if (brdf.counts.tooLarge > 0) say(warning, cells(brdf.counts.tooLarge, "values above 2.1e9 per steradian"));
  if (brdf.counts.negative > 0) say(merl ? info : warning, cells(brdf.counts.negative, "negative values"));
  const optics::MeasuredGuess& guess = brdf.guess;
  if (guess.holes() == 0) return notes;
  std::string filled;
  const auto part = [&](size_t count, const char* how) {
    if (count > 0) filled += (filled.empty() ? "" : ", ") + std::to_string(count) + how;
  };
  part(guess.reciprocal, " with V and L exchanged");
  part(guess.between, " between their neighbours");
  part(guess.continued, " like the nearest ones");
  say(guess.energy >= toldEnergy ? warning : info,
      std::to_string(guess.holes()) + " cells above the horizon hold no value and are filled (" + filled +
          "): " + percent(guess.energy) + " of the light that it reflects is guessed");
  return notes;
}

}  // namespace facet::io
