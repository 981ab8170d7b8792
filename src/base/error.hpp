#pragma once

#include <cstdint>
#include <string>
#include <tl/expected.hpp>
#include <vector>

namespace facet {

// What of the picture's settings a message is about. Whoever tells it to somebody who types options adds their names
// (options::describe).
enum class Setting : uint8_t {
  none,
  scene,
  variant,
  animation,
  camera,
  bump,
  environment,
  environmentLayer,
  models,  // for lights: distribution of normals, masking
  fresnel,
  samples,
  brdf,
  brdfFolder,
  allowOutside,
  edits,
  only,
};

// What is wrong with something that came from outside. Programming errors assert instead.
struct Error {
  std::string file;     // path or name of the input
  std::string place;    // where in it: JSON pointer, "byte 120", "line 3"; may be empty
  std::string problem;  // what is wrong, no full stop
  std::string remedy;   // what to do, no full stop; may be empty
  Setting about = Setting::none;
};

template <class T>
using Result = tl::expected<T, Error>;

// One sentence: "FILE: PLACE: PROBLEM; REMEDY." The only place where errors become text.
std::string describe(const Error& error);

inline tl::unexpected<Error> fail(std::string file, std::string place, std::string problem, std::string remedy = {},
                                  Setting about = Setting::none) {
  return tl::unexpected<Error>({std::move(file), std::move(place), std::move(problem), std::move(remedy), about});
}

// Something that was repaired, replaced or ignored while reading; the caller decides what to say.
struct Note {
  enum class Severity { info, warning };  // warning: what the user sees differs from what the file asks for
  Severity severity = Severity::info;
  std::string place;
  std::string text;
  Setting about = Setting::none;
};
using Notes = std::vector<Note>;

}  // namespace facet
