// Number of frames that an engine runs before the next engine.
#pragma once

namespace bench {

// Long enough that the clock and the change of process do not count, short enough that a change of
// the machine's mood falls on all engines alike: about 50 ms. The first frames of a batch find cold caches
// and sleeping workers, which those of a program that simulates without pause do not. Worlds of more than
// 10 ms a frame get five frames. No engine runs for more than two seconds, unless it takes longer for one
// frame.
//
// The result is 1, 2 or 5 times a power of ten, so that batches end at multiples of 100 frames,
// where the running averages are kept.
//
// `fastest`, `slowest`: seconds for a frame of the fastest and of the slowest engine.
int batchSize(double fastest, double slowest);

}  // namespace bench
