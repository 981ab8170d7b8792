#pragma once

// Memory in pages of 2 MB: what is touched once, as decoded images and textures of a driver that draws on the CPU are,
// costs the system most of its time in pages of 4 KB. Where the system gives large pages only to who asks for them
// (transparent_hugepage: madvise), the C library can do so for all that is allocated, the driver's, too (glibc 2.35,
// glibc.malloc.hugetlb), if it is told before the program starts.

#include <string>
#include <string_view>

namespace facet {

// The word in brackets of /sys/kernel/mm/transparent_hugepage/enabled: "always", "madvise" or "never"; empty: none.
std::string hugePageMode(std::string_view text);

// The value of GLIBC_TUNABLES that asks for them, beside what is in it; empty: it says something of them already.
std::string tunablesWithHugePages(std::string_view tunables);

// Starts this program anew, as this process, if that makes the C library ask for large pages; else, and the second
// time, does nothing. Before anything else. arguments: main's.
void askForHugePages(char** arguments);

// "always", "asked for" or "no", of this process.
std::string hugePagesHere();

}  // namespace facet
