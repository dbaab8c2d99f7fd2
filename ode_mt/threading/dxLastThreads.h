// Whether a process lives on for the sake of its workers alone.
//
// A process whose first thread has ended by pthread_exit ends with its last thread. Workers that sleep are threads,
// too, and nobody tells them that the others have gone: one of them has to look.
#pragma once

// True once the first thread has ended and only so many others are left; nothing but these can then start another.
// False where the system does not tell (no /proc).
bool dxAreLastThreads(unsigned threads);
