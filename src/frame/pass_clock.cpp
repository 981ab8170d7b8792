#include "frame/pass_clock.hpp"

#include <algorithm>

namespace facet::frame {

namespace {

// A picture of many samples has many passes: what is beyond is not measured.
constexpr size_t mostMarks = 20'000;

}  // namespace

void PassClock::begin(const std::string& pass) {
  if (marks_.size() < mostMarks) marks_.push_back({pass, gl::TimeStamp::now()});
}

void PassClock::end() {
  if (!marks_.empty() && !marks_.back().pass.empty()) marks_.push_back({"", gl::TimeStamp::now()});
}

bool PassClock::ready() const { return marks_.empty() || marks_.back().at.ready(); }

std::vector<PassTime> PassClock::take() {
  end();
  std::vector<PassTime> times;
  for (size_t i = 0; i + 1 < marks_.size(); ++i) {
    if (marks_[i].pass.empty()) continue;
    auto known = std::ranges::find(times, marks_[i].pass, &PassTime::name);
    if (known == times.end())
      known = times.insert(known, {marks_[i].pass, marks_[i].at.millisecondsSince(marks_.front().at)});
    known->gpuMs += marks_[i + 1].at.millisecondsSince(marks_[i].at);
    ++known->runs;
  }
  marks_.clear();
  return times;
}

}  // namespace facet::frame
