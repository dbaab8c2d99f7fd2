// The instruction sets that vector code is compiled for. Include before any header of Highway.
//
// Left out: AVX3_DL, which adds nothing that is used here to AVX3, and vectors whose length is not known
// when compiling, which tiles with a fixed number of rows cannot use.
#pragma once

#define HWY_DISABLED_TARGETS (HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
