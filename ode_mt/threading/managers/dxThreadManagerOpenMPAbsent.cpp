// Compiled instead of dxThreadManagerOpenMP.cpp where CMake finds no OpenMP.
#include "threading/managers/dxThreadManagerOpenMP.h"

bool dxThreadManagerOpenMP::present() { return false; }

std::unique_ptr<dxThreadManager> dxThreadManagerOpenMP::make(dxCreateThread) { return nullptr; }
