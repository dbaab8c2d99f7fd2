// As what a player plays on the library that it finds.
#pragma once

namespace fuzz {

struct PlayedAs {
    bool isFast = false;    // all worlds begin with the solver fast, by the environment; more scenes have large islands
    bool isSerial = false;  // as on Debian's library: ODE_MT's own functions are hidden, and vectors are the narrowest
};

// Chosen once, by the command line.
inline PlayedAs playedAs;

}  // namespace fuzz
