// The command line of odemt_render.
#pragma once

#include "render/picture.h"

#include <optional>
#include <string>

namespace render {

struct RenderOptions {
    std::string recording;
    std::string frame = "last";  // number, or "last"
    std::string file;            // empty: standard output
    View view;
};

// Empty: the program ends with `exitCode`, as readOptions of odemt_bench.
std::optional<RenderOptions> readRenderOptions(int argc, const char *const *argv, int &exitCode);

// Throws std::invalid_argument, naming the frames that there are.
const record::Frame &chooseFrame(const record::Recording &recording, const std::string &frame);

}  // namespace render
