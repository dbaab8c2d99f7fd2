/* Linker names of upstream's initialisation functions; the public ones are in ode_mt/api/lifecycle.cpp. */
#pragma once

extern "C" {
void dInitODE() __asm__("dxUpstreamInitODE");
int dInitODE2(unsigned int) __asm__("dxUpstreamInitODE2");
int dAllocateODEDataForThread(unsigned int) __asm__("dxUpstreamAllocateODEDataForThread");
void dCleanupODEAllDataForThread() __asm__("dxUpstreamCleanupODEAllDataForThread");
void dCloseODE() __asm__("dxUpstreamCloseODE");
}
