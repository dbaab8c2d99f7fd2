// Makes ODE_MT's vector code run with one instruction set of those that it is compiled for.
//
// ODE_MT and this program share one libhwy, which chooses the set for the process at the first call of vector
// code. So this needs no help from the library, and shows which set it took. Were Highway linked into the
// library, no choice would show here, and the suite would fail.
#pragma once

#include <string>
#include <vector>

namespace exactness {

// What this machine has, widest vectors first: "AVX3", "AVX2".
std::vector<std::string> instructionSets();

// To be called before ODE is. Throws std::invalid_argument that lists what there is.
void forceInstructionSet(const std::string &name);

// That vector code has run with; empty: none has run.
std::string instructionSetInUse();

}  // namespace exactness
