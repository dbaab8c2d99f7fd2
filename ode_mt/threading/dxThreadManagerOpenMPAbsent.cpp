// Compiled instead of dxThreadManagerOpenMP.cpp where CMake finds no OpenMP.
#include "dxThreadManagerOpenMP.h"

const bool dxThreadManagerOpenMP::present = false;

std::unique_ptr<dxThreadManager> dxThreadManagerOpenMP::make(dxCreateThread) { return nullptr; }
