// Figures as text for people.
#pragma once

#include <string>

namespace bench {

// Three significant digits, but never more than four behind the point; "-" if it is not finite.
std::string numberText(double value);

std::string millisecondsText(double seconds);

}  // namespace bench
