#include "serial_share.h"

#include <cstdio>

namespace bench {

double mostGain(double serialShare, unsigned threads) { return 1 / (serialShare + (1 - serialShare) / threads); }

std::string gainText(double serialShare) {
    char text[160];
    std::snprintf(text, sizeof text, "%.0f %% of the work is one thread's: with 4, 8, 16 cores at most %.1f, %.1f, %.1f times as fast as with one",
                  100 * serialShare, mostGain(serialShare, 4), mostGain(serialShare, 8), mostGain(serialShare, 16));
    return text;
}

}  // namespace bench
