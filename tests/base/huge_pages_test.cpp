#include "base/huge_pages.hpp"

#include <catch2/catch.hpp>

using namespace facet;

TEST_CASE("large pages: the system's mode, and what the C library is told") {
  CHECK(hugePageMode("always [madvise] never\n") == "madvise");
  CHECK(hugePageMode("[always] madvise never") == "always");
  CHECK(hugePageMode("").empty());
  CHECK(hugePageMode("]always[").empty());
  CHECK(tunablesWithHugePages("") == "glibc.malloc.hugetlb=1");
  CHECK(tunablesWithHugePages("glibc.malloc.check=1") == "glibc.malloc.check=1:glibc.malloc.hugetlb=1");
  CHECK(tunablesWithHugePages("glibc.malloc.hugetlb=0").empty());
  CHECK(tunablesWithHugePages("a=1:glibc.malloc.hugetlb=1").empty());
}
