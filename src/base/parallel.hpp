#pragma once

#include <cstddef>
#include <functional>

namespace facet {

// Calls work(i) for every i in [0, count), spread over the machine's cores; returns when all are done.
// work must not throw. The order is unspecified, so results must not depend on it.
void parallelFor(size_t count, const std::function<void(size_t)>& work);

// Of this thread and of those that it will start: others that want a core get it first.
void lowerThreadPriority();

}  // namespace facet
