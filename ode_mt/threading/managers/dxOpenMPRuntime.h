// What the OpenMP runtimes do differently. CMake compiles the file for the runtime in use.
#pragma once

// Called by the thread that is about to open a parallel region.
void dxOpenMPPrepareRegions();

// Ends the idle threads of the calling thread's pool; false if the runtime cannot, as inside a region.
bool dxOpenMPEndThreads();

// Called in the parent before fork; false if a parallel region in the child could hang.
bool dxOpenMPPrepareFork();
