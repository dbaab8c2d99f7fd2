#include "number_text.h"

#include <cmath>
#include <cstdio>

namespace bench {

std::string numberText(double value) {
    if (!std::isfinite(value)) return "-";
    const int digits = value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : value >= 0.1 ? 3 : 4;
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", digits, value);
    return text;
}

std::string millisecondsText(double seconds) { return numberText(1e3 * seconds); }

}  // namespace bench
