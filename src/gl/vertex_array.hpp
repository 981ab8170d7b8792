#pragma once

#include "gl/handle.hpp"

namespace facet::gl {

inline void destroyVertexArray(GLuint id) { glDeleteVertexArrays(1, &id); }

class VertexArray : public Handle<destroyVertexArray> {
 public:
  VertexArray()
      : Handle([] {
          GLuint id = 0;
          glCreateVertexArrays(1, &id);
          return id;
        }()) {}
};

inline void destroySampler(GLuint id) { glDeleteSamplers(1, &id); }

class Sampler : public Handle<destroySampler> {
 public:
  Sampler() = default;
  static Sampler create() {
    Sampler sampler;
    GLuint id = 0;
    glCreateSamplers(1, &id);
    static_cast<Handle&>(sampler) = Handle(id);
    return sampler;
  }
};

}  // namespace facet::gl
