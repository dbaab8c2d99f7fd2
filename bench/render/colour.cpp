#include "render/colour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace render {

namespace {

// Okabe and Ito's palette, which most colour-blind people tell apart, and four more.
constexpr std::array<Colour, 11> kStrong = {{{0.84, 0.37, 0.00},
                                             {0.00, 0.45, 0.70},
                                             {0.00, 0.62, 0.45},
                                             {0.80, 0.30, 0.60},
                                             {0.94, 0.78, 0.10},
                                             {0.34, 0.71, 0.91},
                                             {0.45, 0.25, 0.65},
                                             {0.60, 0.35, 0.15},
                                             {0.55, 0.75, 0.20},
                                             {0.85, 0.10, 0.20},
                                             {0.10, 0.25, 0.40}}};

// One channel of a colour given by hue (turns), saturation and lightness.
double channel(double hue, double saturation, double lightness, double offset) {
    const double k = std::fmod(offset + 12 * hue, 12.0);
    const double a = saturation * std::min(lightness, 1 - lightness);
    return lightness - a * std::max(-1.0, std::min({k - 3, 9 - k, 1.0}));
}

Colour fromHue(double hue, double saturation, double lightness) {
    return {channel(hue, saturation, lightness, 0), channel(hue, saturation, lightness, 8),
            channel(hue, saturation, lightness, 4)};
}

constexpr double kGoldenSection =
    0.618033988749895;  // turns, so that neighbours in number are far apart in hue

}  // namespace

std::string Colour::text() const {
    const auto byte = [](double value) {
        return static_cast<int>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
    };
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(red), byte(green), byte(blue));
    return text;
}

Colour mixed(const Colour &a, const Colour &b, double share) {
    const auto mix = [share](double x, double y) { return x + share * (y - x); };
    return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

Colour shaded(const Colour &colour, double light) { return mixed({0, 0, 0}, colour, light); }

Colour clusterColour(int number) { return kStrong[static_cast<std::size_t>(number) % kStrong.size()]; }

Colour staticClusterColour(int number) {
    return fromHue(std::fmod(0.55 + kGoldenSection * number, 1.0), 0.6, number % 2 ? 0.66 : 0.78);
}

}  // namespace render
