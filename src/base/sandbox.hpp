#pragma once

// A process that gives up what it will not need before it reads what a stranger wrote: should a decoder be made to do
// what that stranger wants, there is little that it can do. Linux alone.

#include <filesystem>
#include <string>
#include <vector>

namespace facet {

// Files and folders, with all that is below them; what does not exist is left out. Links count as what they name.
struct Needed {
  std::vector<std::filesystem::path> read;
  std::vector<std::filesystem::path> written;  // read, too; folders: files are made, replaced and removed there
  // A program with a window: people choose in it what is read, so that every file is; sockets of this machine are open
  // to it, through which it talks to the display; and it may start processes, which are confined as it is.
  bool window = false;
};

// What holds from now on, for people: "landlock 7", "no: the kernel has no landlock".
struct Confined {
  std::string files, calls;
};

// For the rest of the process:
//  - files (landlock): this thread, and those that it starts from now on, open only what is needed, what the system has
//    below /usr, /lib, /sys and of the process in /proc, devices, and what is open already. Names, sizes and times of
//    other files can still be asked for. Threads that a driver has started before keep their rights. With a window all
//    is read, and only what is needed and devices are written to.
//  - calls (seccomp), all threads: no network; without a window no other sockets, no other programs or processes, none
//    of others to signal; none to look into, no change of owners or rights of files by name, nothing that only system
//    tools need.
// What the kernel does not offer is left out, and the answer says so.
Confined confineProcess(const Needed& needed);

}  // namespace facet
