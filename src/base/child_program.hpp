#pragma once

// Another program, beside this one.

#include <optional>
#include <string>
#include <vector>

namespace facet {

// -1 and empty: nothing is read from there, or what is written is lost.
struct ChildStreams {
  int input = -1, output = -1;  // descriptors
  std::string errors = {};      // a file
};

// Looked for as a shell does, words[0] first. Its process, or -errno.
int startProgram(const std::vector<std::string>& words, const ChildStreams& streams);

// Until it ends; its status as waitpid has it.
int waitForProgram(int process);

// Asks it to end, and waits for that.
void endProgram(int process);

// The status of one that has ended; nothing while it runs.
std::optional<int> endedProgram(int process);

}  // namespace facet
