// The processors that this process may use, as opposed to those of one thread, which may have bound itself to a few.
//
// They are the ones that the process had when the library was loaded (as taskset or a container gave them), and those
// that its first thread or the calling one may use now. The answer may change.
//
// Threading: any thread.
#pragma once

#include <sched.h>

// Returns false if the system does not tell.
bool dxProcessorsOfProcess(cpu_set_t &processors);

// Asks the system how many there are; at least 1.
unsigned dxCountProcessors();

// Returns how many there were when the system was asked last.
unsigned dxProcessorCount();
