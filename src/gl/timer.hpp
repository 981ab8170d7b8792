#pragma once

#include "gl/handle.hpp"

namespace facet::gl {

inline void destroyQuery(GLuint id) { glDeleteQueries(1, &id); }

// GPU time between begin() and end(); the result is fetched later so that nothing waits.
class Timer : public Handle<destroyQuery> {
 public:
  Timer() = default;
  static Timer create() {
    Timer timer;
    GLuint id = 0;
    glCreateQueries(GL_TIME_ELAPSED, 1, &id);
    static_cast<Handle&>(timer) = Handle(id);
    return timer;
  }
  void begin() const { glBeginQuery(GL_TIME_ELAPSED, id()); }
  void end() const { glEndQuery(GL_TIME_ELAPSED); }
  bool ready() const {
    GLint available = 0;
    glGetQueryObjectiv(id(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available != 0;
  }
  double milliseconds() const {  // waits where not ready
    GLuint64 ns = 0;
    glGetQueryObjectui64v(id(), GL_QUERY_RESULT, &ns);
    return static_cast<double>(ns) * 1e-6;
  }
};

}  // namespace facet::gl
