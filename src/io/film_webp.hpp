#pragma once

// Pictures one after the other in one WebP file, without end.

#include <memory>
#include <vector>

#include "base/error.hpp"
#include "io/image.hpp"

namespace facet::io {

class WebpFilm {
 public:
  // quality: io/picture_file.hpp. Errors: larger than the format holds; no memory.
  static Result<WebpFilm> begin(int width, int height, int quality);
  // 8-bit RGB or RGBA of that size, from that time on, which grows. Errors: no memory.
  Result<void> add(const Pixels& pixels, int milliseconds);
  // The file; milliseconds: when the last one ends.
  Result<std::vector<uint8_t>> end(int milliseconds);

  struct Encoder;

 private:
  explicit WebpFilm(std::shared_ptr<Encoder> encoder) : encoder_(std::move(encoder)) {}
  std::shared_ptr<Encoder> encoder_;
};

}  // namespace facet::io
