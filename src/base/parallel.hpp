#pragma once

#include <cstddef>
#include <functional>

namespace facet {

// Calls work(i) for every i in [0, count), spread over the machine's cores; returns when all are done.
// The order is unspecified, so results must not depend on it. What work throws ends the rest early and is thrown from
// here. Where the system gives no threads, this one does it all.
void parallelFor(size_t count, const std::function<void(size_t)>& work);

// Of this thread and of those that it will start: others that want a core get it first.
void lowerThreadPriority();

}  // namespace facet
