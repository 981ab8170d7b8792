#ifndef FACET_HPP
#define FACET_HPP

// facet.h for C++17 and later: a renderer that closes itself, errors as values. Nothing throws but for lack of memory.

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "facet.h"

namespace facet {

template <class Sample>
struct Image {
  int width = 0, height = 0;    // 0: there is none, and the renderer's message says why
  std::vector<Sample> samples;  // red, green, blue, alpha of each pixel, the top row first
  explicit operator bool() const { return width > 0; }
};

class Renderer {
 public:
  explicit Renderer(unsigned flags = 0) : status_(facet_open(flags, &renderer_)) {}
  ~Renderer() { facet_close(renderer_); }
  Renderer(Renderer&& other) noexcept
      : renderer_(std::exchange(other.renderer_, nullptr)), status_(std::exchange(other.status_, FACET_BAD_INPUT)) {}
  Renderer& operator=(Renderer&& other) noexcept {
    std::swap(renderer_, other.renderer_), std::swap(status_, other.status_);
    return *this;
  }

  // Of the last call.
  explicit operator bool() const { return status_ == FACET_GOOD; }
  int status() const { return status_; }
  std::string message() const { return facet_message(renderer_); }
  std::vector<std::string> warnings() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; const char* const text = facet_warning(renderer_, i); ++i) all.emplace_back(text);
    return all;
  }
  std::string command() const { return facet_command(renderer_); }  // of the last picture

  bool load(const std::string& model) { return good(facet_load(renderer_, model.c_str())); }
  bool set(const std::string& option, const std::string& value) {
    return good(facet_set(renderer_, option.c_str(), value.c_str()));
  }
  bool unset(const std::string& option) { return good(facet_set(renderer_, option.c_str(), nullptr)); }

  Image<std::uint8_t> render() { return draw<std::uint8_t>(FACET_RGBA8); }
  Image<float> radiance() { return draw<float>(FACET_RGBA_FLOAT); }

 private:
  bool good(int status) { return (status_ = status) == FACET_GOOD; }
  template <class Sample>
  Image<Sample> draw(int format) {
    facet_picture picture{};
    if (!good(facet_render(renderer_, format, &picture))) return {};
    const Sample* const first = static_cast<const Sample*>(picture.pixels);
    return {picture.width, picture.height, std::vector<Sample>(first, first + picture.bytes / sizeof(Sample))};
  }

  facet_renderer* renderer_ = nullptr;
  int status_;
};

}  // namespace facet

#endif
