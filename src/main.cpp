#include "commands/commands.hpp"

int main(int argc, char** argv) { return facet::commands::run(argc, argv); }
