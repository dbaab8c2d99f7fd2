// The instruction sets that vector code is compiled for. Include before any header of Highway.
//
// Left out: AVX3_DL, AVX3_ZEN4 and AVX3_SPR, which add nothing to AVX3 that is used here, and vectors whose length is not known
// at compile time, which tiles with a fixed number of rows cannot use.
#pragma once

// The last two are given by their bits: Highway before 1.1 has neither the names nor other sets with these bits.
#define DX_AVX3_ZEN4_AND_SPR (1LL << 6 | 1LL << 4)

#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | DX_AVX3_ZEN4_AND_SPR | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
