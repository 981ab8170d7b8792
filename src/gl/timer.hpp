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

// When the GPU had done what was asked of it so far. Flushed: Mesa's software rasterizer writes a stamp with the
// drawing that it belongs to.
class TimeStamp : public Handle<destroyQuery> {
 public:
  static TimeStamp now() {
    TimeStamp stamp;
    GLuint id = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &id);
    static_cast<Handle&>(stamp) = Handle(id);
    glQueryCounter(id, GL_TIMESTAMP);
    glFlush();
    return stamp;
  }
  bool ready() const {
    GLint available = 0;
    glGetQueryObjectiv(id(), GL_QUERY_RESULT_AVAILABLE, &available);
    return available != 0;
  }
  double millisecondsSince(const TimeStamp& before) const {  // waits where not ready
    return static_cast<double>(nanoseconds() - before.nanoseconds()) * 1e-6;
  }

 private:
  GLint64 nanoseconds() const {
    GLint64 ns = 0;
    glGetQueryObjecti64v(id(), GL_QUERY_RESULT, &ns);
    return ns;
  }
};

// GPU time from start to stop() by two time stamps, so that intervals may lie within each other and within a Timer's.
// What the GPU waits for in between counts.
class Interval {
 public:
  double stop() { return TimeStamp::now().millisecondsSince(start_); }  // waits

 private:
  TimeStamp start_ = TimeStamp::now();
};

}  // namespace facet::gl
