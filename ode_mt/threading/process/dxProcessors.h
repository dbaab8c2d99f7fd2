// The processors that this process may use: not those of one thread, which may have bound itself to a few.
//
// They are the ones that the process had when the library was loaded (as taskset or a container gave them), and those
// that its first thread or the calling one may use now. Whoever has to know asks anew: the answer may change.
#pragma once

#include <sched.h>

// False if the system does not tell.
bool dxProcessorsOfProcess(cpu_set_t &processors);

// Asks how many there are; at least 1.
unsigned dxCountProcessors();

// How many there were when somebody asked last.
unsigned dxProcessorCount();
