// Which part of the work of frames one thread had to do, and how much more threads can gain at most (Amdahl's law).
#pragma once

#include <string>

namespace bench {

// Of any number of frames: seconds that the calling thread works alone, and what all threads work in stages that several may share, added up.
struct SerialWork {
    double alone = 0, shared = 0;

    bool isKnown() const { return alone + shared > 0; }
    double share() const { return isKnown() ? alone / (alone + shared) : 1; }

    SerialWork &operator+=(const SerialWork &other) {
        alone += other.alone;
        shared += other.shared;
        return *this;
    }
};

// Returns how many times as fast as on one thread frames can become.
double mostGain(double serialShare, unsigned threads);

// Returns half a sentence: the share, and the gain on 4, 8 and 16 cores.
std::string gainText(double serialShare);

}  // namespace bench
