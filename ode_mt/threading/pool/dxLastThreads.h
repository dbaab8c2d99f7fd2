// Whether a process lives on for the sake of its workers alone.
//
// A process whose first thread has ended by pthread_exit ends with its last thread. Workers that sleep are threads,
// too, and nobody tells them that the others have gone: one of them has to look.
#pragma once

// True once the first thread has ended and only so many others are left. Where the system does not tell how many there are (no
// /proc, no descriptor free), true once the first thread has ended: threads that go on then do their steps alone, which is better
// than a process that nothing but SIGKILL ends.
bool dxMayBeLastThreads(unsigned threads);
