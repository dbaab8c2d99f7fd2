// Which libode.so.8 this process runs on, that library's statistics of threads, and its instruction set.
#pragma once

#include "record.h"

namespace exactness {

// Statistics are 0 on a library that has none: the functions are looked up by name, so that the program
// also runs on Debian's.
Engine runningEngine();

}  // namespace exactness
