#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace facet::gl {

// Owns one OpenGL name; move-only. Destroy gets the name when it is not 0.
template <void (*Destroy)(GLuint)>
class Handle {
 public:
  Handle() = default;
  explicit Handle(GLuint id) : id_(id) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Handle() {
    if (id_ != 0) Destroy(id_);
  }
  GLuint id() const { return id_; }
  explicit operator bool() const { return id_ != 0; }

 private:
  GLuint id_ = 0;
};

}  // namespace facet::gl
