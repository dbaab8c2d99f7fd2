#include "dxSpin.h"

#include <thread>

unsigned dxProcessorCount() {
    static const unsigned count = std::thread::hardware_concurrency();
    return count;
}
