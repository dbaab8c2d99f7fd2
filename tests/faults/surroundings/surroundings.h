// What may be wrong around a program that steps a world. Each function plays the same frames in such
// surroundings, and returns what playFrames() returns in good ones, or 0 where something else than the frames
// has gone wrong.
#pragma once

#include <cstdint>

namespace faults {

// Builds a world, plays some frames and returns the hash of its end. Takes no random numbers, so that several
// worlds may be played at once.
std::uint64_t playFrames();

std::uint64_t
underSignals();  // a timer's signal every fraction of a millisecond, and calls of the system fail with EINTR
std::uint64_t onSmallStack();              // of 256 kB
std::uint64_t withSmallStackLimit();       // 256 kB, from which threads without a size of their own take theirs
std::uint64_t withLittleAddressSpace();    // too little for the stacks of all workers
std::uint64_t withoutThreads();            // the system refuses all of them, or all but the first
std::uint64_t withDecimalComma();          // the program has set a locale in which numbers have one
std::uint64_t besideBusyProcess();         // on one core, which another process computes on, too
std::uint64_t inManyThreads();             // 64 of the program's, each with a world
std::uint64_t withWorldsComingAndGoing();  // thousands, and memory stays as it is
std::uint64_t whileOthersInitialise();     // another thread initialises and closes the library all the time

}  // namespace faults
