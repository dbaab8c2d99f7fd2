// Runs a program on Debian's libode8 and on ODE_MT, for tests that compare what it prints, line by line.
#pragma once

#include <string>
#include <vector>

namespace exactness {

using Lines = std::vector<std::string>;

enum class Library { Debian, Ours };

// What the program prints; its first line names the library that it runs on. `memoryPattern` is for
// MALLOC_PERTURB_, which fills fresh memory. Throws std::runtime_error if the program fails.
Lines linesOn(Library library, const Lines &command, const char *memoryPattern = "165");

// The first lines that differ, behind those with the names; empty: none.
std::string firstDifference(const Lines &onDebian, const Lines &onOurs);

}  // namespace exactness
