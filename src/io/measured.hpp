#pragma once

// Measured BRDFs by path or built-in name, whatever their kind; and where a user's databases are found.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "io/utia.hpp"
#include "optics/measured.hpp"

namespace facet::io {

struct MeasuredOptions {
  UtiaDecode utiaDecode = UtiaDecode::raw;
};

// raw, srgb, srgb140. Errors hold problem and remedy.
Result<UtiaDecode> parseUtiaDecode(std::string_view name);
std::span<const std::string_view> utiaDecodeNames();  // in the enumeration's order

// A file, told by its content and size (MERL's dimensions, or UTIA's exact size), or "builtin:NAME"
// (optics/synthetic_brdf.hpp), made on the spot. name becomes the file's stem. Read in one piece; nothing is
// allocated before kind and size are known to fit. Holes are filled (optics/measured_holes.hpp). Errors: as
// readRegularFile and the decoders have them; a file of neither kind; holes that nothing reaches; no such built-in one.
Result<optics::MeasuredBrdf> readMeasured(const std::string& pathOrName, const MeasuredOptions& options = {});

// Info: PQBA's dimensions. Warnings: cells that are missing because of NaN, infinite or too large values; negative ones
// of UTIA (MERL's are that database's own mark and only info); how holes were filled and what share of the light is
// guessed (info where that is less than a thousandth).
Notes measuredNotes(const optics::MeasuredBrdf& brdf);

// A file that looks like a measured BRDF: its kind by size and, for MERL, by its first twelve bytes.
struct MeasuredFile {
  std::filesystem::path path;
  std::string name;  // of the file without its ending
  optics::MeasuredKind kind = optics::MeasuredKind::merl;
};
// Those in a folder and the folders below it, by name; links to folders are not followed. A folder that does not exist
// holds none.
std::vector<MeasuredFile> findMeasured(const std::filesystem::path& folder);

// Where databases are looked for, in this order, as far as the folders exist: `given` (--brdf-dir; may be empty),
// resources/brdf/merl and resources/brdf/utia below the working directory and beside the executable,
// $XDG_DATA_HOME/facet/brdf (~/.local/share/facet/brdf).
std::vector<std::filesystem::path> brdfFolders(const std::filesystem::path& given);
// findMeasured over all of them; of equal paths the first.
std::vector<MeasuredFile> findDatabases(const std::filesystem::path& given);
// What --brdf takes: an existing path or "builtin:NAME" as it is, else the database of that name (without ending) in
// those folders. Errors: neither, with the nearest name.
Result<std::string> resolveMeasured(const std::string& pathOrName, const std::filesystem::path& brdfDir);

}  // namespace facet::io
