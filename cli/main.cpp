#include "cli/run.h"

int main(int argc, char** argv) { return terrview::run({argv + 1, argv + argc}); }
