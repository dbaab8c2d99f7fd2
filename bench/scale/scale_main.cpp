// odemt_scale: how far islands on other machines go (docs/remote.md).
#include "platform.h"
#include "tool_output.h"
#include "result_file.h"
#include "scale/measured_world.h"
#include "scale/scale_options.h"
#include "scale/scale_table.h"
#include "scale/world_measure.h"
#include "support/text_file.h"

#include <algorithm>

namespace {

using namespace scale;

std::string fileName(const std::string &world) {
    std::string name = world;
    std::replace_if(name.begin(), name.end(), [](char c) { return c == ':' || c == ',' || c == '/'; }, '_');
    return name + ".json";
}

std::string savedFile(const ScaleOptions &options, const std::string &world) { return options.saveFolder + "/" + fileName(world); }

// Before anything is measured.
void checkFiles(const ScaleOptions &options) {
    if (!options.csvFile.empty()) bench::checkWritable(options.csvFile);
    if (options.saveFolder.empty()) return;
    for (const std::string &world : options.worlds) bench::checkWritable(savedFile(options, world));
}

std::vector<MeasuredWorld> measureAll(const ScaleOptions &options) {
    std::vector<MeasuredWorld> all;
    for (const std::string &file : options.measuredFiles) all.push_back(readMeasuredWorld(support::readTextFile(file)));
    for (const std::string &world : options.worlds) {
        all.push_back(measureWorld(world, options.measure));
        if (!options.saveFolder.empty()) bench::writeResultFile(savedFile(options, world), writeMeasuredWorld(all.back()));
    }
    return all;
}

void predict(const ScaleOptions &options) {
    std::string csv = scalingHeader();
    for (const MeasuredWorld &measured : measureAll(options)) {
        std::vector<NetworkScaling> scalings;
        for (const Network &network : options.networks) scalings.push_back(predictScaling(measured, network, options.workers));
        bench::print(describe(measured) + scalingTable(scalings, options.workers) + "\n");
        csv += scalingLines(measured, scalings, options.workers);
    }
    if (!options.csvFile.empty()) bench::writeResultFile(options.csvFile, csv);
}

// Predictions are for the speed that the machine has at that moment, by the frames at home that take turns with those of the cluster. Returns whether
// all of them hold.
bool validate(const ScaleOptions &options) {
    bool areAllGood = true;
    std::string csv = validationHeader();
    for (const MeasuredWorld &measured : measureAll(options)) {
        bench::print(describe(measured) + validationTitles());
        for (const Network &network : options.networks) {
            for (const unsigned workers : options.workers) {
                const Cluster cluster{workers, network, !options.asTheyPay, false, bench::thisMachine().cores};
                const MeasuredFrames frames = measureFrames(measured, cluster, options.measure);
                const Validation row{cluster, predictFrame(slowedDown(measured, frames.homeNs / measured.homeFrameNs), cluster), frames};
                areAllGood &= row.isGood();
                bench::print(validationRow(row));
                csv += validationLine(measured, row);
            }
        }
    }
    if (!options.csvFile.empty()) bench::writeResultFile(options.csvFile, csv);
    return areAllGood;
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    try {
        const auto options = readScaleOptions(argc, argv, exitCode);
        if (!options) return bench::exitCodeAfterOutput(exitCode);
        checkFiles(*options);
        if (options->validates) return validate(*options) ? 0 : 1;
        predict(*options);
        return 0;
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return 1;
    }
}
