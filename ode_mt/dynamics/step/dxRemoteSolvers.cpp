#include "dynamics/step/dxRemoteSolvers.h"

std::atomic<dxRemoteSolvers *> dxRemoteSolvers::s_installed{nullptr};

void dxRemoteSolvers::install(dxRemoteSolvers &solvers) { s_installed.store(&solvers, std::memory_order_release); }
