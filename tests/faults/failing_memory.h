// Memory that is refused on purpose: this program's operator new and malloc, and so those of the libraries
// that it uses, count what they are asked for while they are armed, and fail once, or from then on.
//
// Three sources, since they mean different things: what ODE_MT keeps beside upstream's objects, and containers
// of upstream's, come from operator new, which throws; upstream's objects and libccd's come from malloc
// (dAlloc), which returns NULL; and where the program has set an allocator (dSetAllocHandler), upstream's come from that.
// Any thread may ask.
#pragma once

namespace faults {

enum class Source { operatorNew, malloc, allocator };

// How long memory is refused: for one request, or until disarm().
enum class Shortage { once, lasting };

// From now on requests from `source` are counted, and the one with number `first` (from 0) is the first that
// fails.
void arm(Source source, long first, Shortage shortage);
// Returns how many requests were counted.
long disarm();
// From now on the stack of the first request that fails goes to standard error.
void showFirstRefusal();

}  // namespace faults
