#include "support/run_catch.hpp"

int main(int argc, char** argv) { return facet::test::runCatch(argc, argv); }
