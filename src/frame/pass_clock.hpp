#pragma once

// GPU time of a frame's passes, by time stamps between them that are read when they have come.

#include <string>
#include <vector>

#include "frame/statistics.hpp"
#include "gl/timer.hpp"

namespace facet::frame {

// Each stamp is flushed: software OpenGL then ends a pass before it begins the next one, which costs a little.
class PassClock {
 public:
  void begin(const std::string& pass);  // ends the one before
  void end();
  bool empty() const { return marks_.empty(); }
  bool ready() const;  // all stamps have come
  // By name, in their order; waits where they have not come. From here on it measures anew.
  std::vector<PassTime> take();

 private:
  struct Mark {
    std::string pass;  // empty: none begins
    gl::TimeStamp at;
  };
  std::vector<Mark> marks_;
};

}  // namespace facet::frame
