#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace CLI {
class App;
}

namespace facet::commands {

enum ExitStatus {
  exitGood = 0,
  exitFailed = 1,    // a check failed or pictures differ
  exitBadInput = 2,  // bad arguments or input
  exitNoOpenGL = 3   // no usable OpenGL
};

struct Command {
  const char* name;      // empty: what `facet` without a command does
  const char* summary;   // one line, for `facet --help`
  const char* examples;  // lines "  facet ..." below `facet NAME --help`
  // Adds the options to app. What it returns runs the command once they are parsed and gives the exit status.
  std::function<int()> (*add)(CLI::App& app);
};

// argv -> command -> exit status. A first argument that is no command's name belongs to the nameless command (a model
// for the window); a model that is called like a command can be given as ./render.
int run(int argc, char** argv);
int run(std::span<const Command> table, int argc, char** argv);

// All of the program.
std::span<const Command> allCommands();

// "log|cuberoot": what a value is called that is one of these words. Help, manual and completion read it from there.
std::string alternatives(std::span<const std::string_view> words);

// Says what is wrong and returns exitBadInput.
int badInput(const Error& error);

// One per command, each in the file of its name.
std::function<int()> addBrdf(CLI::App& app);
std::function<int()> addCompare(CLI::App& app);
std::function<int()> addComplete(CLI::App& app);
std::function<int()> addExport(CLI::App& app);
std::function<int()> addInspect(CLI::App& app);
std::function<int()> addManual(CLI::App& app);
std::function<int()> addMaterials(CLI::App& app);
std::function<int()> addNormalMap(CLI::App& app);
std::function<int()> addRegress(CLI::App& app);
std::function<int()> addRender(CLI::App& app);
std::function<int()> addReport(CLI::App& app);
std::function<int()> addSelftest(CLI::App& app);
std::function<int()> addSheet(CLI::App& app);
std::function<int()> addSweep(CLI::App& app);
std::function<int()> addTables(CLI::App& app);
std::function<int()> addThumbnail(CLI::App& app);
std::function<int()> addWindow(CLI::App& app);

}  // namespace facet::commands
