// The machine that the bench runs on, for readers of its figures.
#pragma once

#include <iosfwd>
#include <string>

namespace bench {

struct Machine {
    std::string processor;  // as /proc/cpuinfo names it; empty: it does not
    unsigned cores;         // that this process may use
};

Machine thisMachine();

// The first "model name" in what /proc/cpuinfo holds; empty if there is none.
std::string readProcessor(std::istream &cpuinfo);

}  // namespace bench
