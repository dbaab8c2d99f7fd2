// The command line of odemt_scale.
#pragma once

#include "scale/measured_world.h"
#include "scale/world_measure.h"

#include <optional>
#include <string>
#include <vector>

namespace scale {

struct ScaleOptions {
    std::vector<std::string> worlds;
    std::vector<std::string> measuredFiles;  // instead of worlds
    std::vector<Network> networks;
    std::vector<unsigned> workers;
    bool validates = false, asTheyPay = false;
    std::string saveFolder, csvFile;
    MeasureSettings measure;
};

// Empty: the program ends with `exitCode`.
std::optional<ScaleOptions> readScaleOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace scale
