// A frame of a recording as an SVG picture.
#pragma once

#include "record/recording.h"

#include <string>

namespace render {

struct View {
    double azimuth = -62, elevation = 42;  // degrees, of the viewer
    double radius = 0;                     // m around what moves that are shown; 0: everything
    int width = 480;                       // px
};

std::string drawFrame(const record::Header &header, const record::Frame &frame, const View &view);

}  // namespace render
