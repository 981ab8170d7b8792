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

// GPU time from start to stop() by two time stamps, so that intervals may lie within each other and within a Timer's.
// What the GPU waits for in between counts. Both ends are flushed: Mesa's software rasterizer writes a stamp with the
// drawing that it belongs to, and compute shaders would not lie between.
class Interval {
 public:
  Interval() {
    glCreateQueries(GL_TIMESTAMP, 2, ids_);
    mark(0);
  }
  ~Interval() { glDeleteQueries(2, ids_); }
  Interval(const Interval&) = delete;
  Interval& operator=(const Interval&) = delete;
  double stop() {  // waits; milliseconds
    mark(1);
    GLuint64 ns[2] = {};
    for (int i = 0; i < 2; ++i) glGetQueryObjectui64v(ids_[i], GL_QUERY_RESULT, &ns[i]);
    return static_cast<double>(ns[1] - ns[0]) * 1e-6;
  }

 private:
  void mark(int which) {
    glQueryCounter(ids_[which], GL_TIMESTAMP);
    glFlush();
  }
  GLuint ids_[2] = {};
};

}  // namespace facet::gl
