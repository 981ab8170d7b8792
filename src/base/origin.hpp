#pragma once

// Where figures come from: what made them, on what, by which command, when.

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace facet {

struct Origin {
  std::string version, commit;   // of facet; commit: "unknown" where it was not built from a checkout
  std::string renderer, driver;  // OpenGL's; empty: it took none
  std::string date = {};  // when it was made, UTC, ISO 8601; empty in pictures: the same wish gives the same bytes
  std::string command;    // for a POSIX shell
  std::string environment = {}, model = {};  // empty: it shows none
  std::optional<int> seed = {};              // of random numbers; none: it draws none
};

// Of what is made now by this process: version, commit, date, command.
Origin originOfProcess();

// "commit" and the like with their values, always the same ones in the same order; empty where there is nothing to say.
std::vector<std::pair<std::string, std::string>> originFields(const Origin& origin);

std::string programVersion();  // "0.1.0"
std::string programCommit();   // "1acacf1b2c3d", "-dirty" behind it where files were changed, or "unknown"

}  // namespace facet
