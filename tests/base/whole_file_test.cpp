#include "base/whole_file.hpp"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <iterator>

#include "support/temporary_folder.hpp"

namespace {

using namespace facet;
namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

size_t entries(const fs::path& folder) {
  return static_cast<size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

std::string outcome(const Result<void>& result) { return result ? "written" : describe(result.error()); }

}  // namespace

TEST_CASE("A file is written and replaced, nothing stays beside it", "[base]") {
  const test::TemporaryFolder folder;
  const fs::path path = folder.path() / "a";
  CHECK(outcome(writeWholeFile(path, std::string_view("one"))) == "written");
  CHECK(read(path) == "one");
  REQUIRE(::chmod(path.c_str(), 0640) == 0);
  CHECK(outcome(writeWholeFile(path, std::string_view(""))) == "written");
  CHECK(read(path).empty());
  CHECK(fs::status(path).permissions() == fs::perms(0640));
  CHECK(entries(folder.path()) == 1);
}

TEST_CASE("A link stays and leads to the new file", "[base]") {
  const test::TemporaryFolder folder;
  folder.write("real/a", std::string("old"));
  fs::create_symlink("real/a", folder.path() / "link");
  CHECK(outcome(writeWholeFile(folder.path() / "link", std::string_view("new"))) == "written");
  CHECK(fs::is_symlink(folder.path() / "link"));
  CHECK(read(folder.path() / "real/a") == "new");
}

TEST_CASE("What cannot be written leaves what was there, and says why", "[base]") {
  const test::TemporaryFolder folder;
  const std::string remedy = "; check the folder, its permissions and the space left.";
  const fs::path none = folder.path() / "none/a";
  CHECK(outcome(writeWholeFile(none, std::string_view("x"))) ==
        none.string() + ": cannot be written: No such file or directory" + remedy);
  CHECK(outcome(writeWholeFile(folder.path(), std::string_view("x"))) ==
        folder.path().string() + ": cannot be written: Is a directory" + remedy);
  CHECK(outcome(writeWholeFile("/dev/full", std::string_view("x"))) ==
        "/dev/full: cannot be written: No space left on device" + remedy);
  CHECK(outcome(writeWholeFile("/dev/null", std::string_view("x"))) == "written");
}

TEST_CASE("Past a limit of file sizes the former file stays whole", "[base]") {
  // In a process of its own: the limit is for good. The signal that comes with it is ignored, as a disk sends none.
  const test::TemporaryFolder folder;
  folder.write("a.png", std::string("former"));
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = writeWholeFile(folder.path() / "a.png", std::string(100000, 'x'));
    ::_exit(written ? 1 : 0);
  }
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(read(folder.path() / "a.png") == "former");
  CHECK(entries(folder.path()) == 1);
}
