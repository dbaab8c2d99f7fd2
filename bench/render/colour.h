// Colours and the palettes that clusters have.
#pragma once

#include <string>

namespace render {

struct Colour {
    double red = 0, green = 0, blue = 0;  // 0 to 1

    std::string text() const;  // "#rrggbb"
};

Colour mixed(const Colour &a, const Colour &b, double share);  // share 1: b
Colour shaded(const Colour &colour, double light);             // light 0: black

Colour clusterColour(int number);        // strong; number from 0 on
Colour staticClusterColour(int number);  // pale

}  // namespace render
