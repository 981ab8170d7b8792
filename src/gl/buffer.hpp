#pragma once

#include <cassert>
#include <cstddef>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include "gl/handle.hpp"

namespace facet::gl {

inline void destroyBuffer(GLuint id) { glDeleteBuffers(1, &id); }

// Immutable-size storage (glNamedBufferStorage). An empty description makes a buffer of 16 bytes, so that it can be
// bound.
class Buffer : public Handle<destroyBuffer> {
 public:
  Buffer() = default;
  // dynamic: contents may be replaced with update().
  Buffer(size_t bytes, std::string_view label, bool dynamic = false);
  Buffer(std::span<const std::byte> data, std::string_view label, bool dynamic = false);

  template <class T>
  requires std::is_trivially_copyable_v<T>
  static Buffer of(const std::vector<T>& data, std::string_view label, bool dynamic = false) {
    return Buffer(std::as_bytes(std::span(data)), label, dynamic);
  }

  size_t bytes() const { return bytes_; }
  void update(std::span<const std::byte> data, size_t offset = 0) const;  // dynamic only; must fit
  template <class T>
  requires std::is_trivially_copyable_v<T> std::vector<T> read(size_t count)
  const {
    std::vector<T> out(count);
    assert(count * sizeof(T) <= bytes_);
    glGetNamedBufferSubData(id(), 0, static_cast<GLsizeiptr>(count * sizeof(T)), out.data());
    return out;
  }

 private:
  size_t bytes_ = 0;
};

}  // namespace facet::gl
