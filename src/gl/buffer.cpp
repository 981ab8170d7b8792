#include "gl/buffer.hpp"

#include <algorithm>

namespace facet::gl {

namespace {
GLuint createBuffer() {
  GLuint id = 0;
  glCreateBuffers(1, &id);
  return id;
}
}  // namespace

Buffer::Buffer(size_t bytes, std::string_view label, bool dynamic)
    : Handle(createBuffer()), bytes_(std::max<size_t>(bytes, 16)) {
  glNamedBufferStorage(id(), static_cast<GLsizeiptr>(bytes_), nullptr, dynamic ? GL_DYNAMIC_STORAGE_BIT : 0);
  glObjectLabel(GL_BUFFER, id(), static_cast<GLsizei>(label.size()), label.data());
}

Buffer::Buffer(std::span<const std::byte> data, std::string_view label, bool dynamic)
    : Handle(createBuffer()), bytes_(std::max<size_t>(data.size(), 16)) {
  const bool padded = data.size() < bytes_;  // the driver would read past the caller's data
  glNamedBufferStorage(id(), static_cast<GLsizeiptr>(bytes_), padded ? nullptr : data.data(),
                       dynamic || padded ? GL_DYNAMIC_STORAGE_BIT : 0);
  if (padded && !data.empty()) update(data);
  glObjectLabel(GL_BUFFER, id(), static_cast<GLsizei>(label.size()), label.data());
}

void Buffer::update(std::span<const std::byte> data, size_t offset) const {
  assert(offset + data.size() <= bytes_);
  glNamedBufferSubData(id(), static_cast<GLintptr>(offset), static_cast<GLsizeiptr>(data.size()), data.data());
}

}  // namespace facet::gl
