// odemt_record: a world and its clusters, frame by frame, as JSON lines (recording.h).
#include "library_probe.h"
#include "library_variables.h"
#include "record/record_options.h"
#include "record/recorder.h"
#include "world_source.h"

#include <ode/ode.h>

#include <cstdlib>
#include <fstream>
#include <iostream>

namespace {

// Read by the library at its first use. What else the user has set must not change the recording.
void chooseAlgorithm(const record::RecordOptions &options) {
    for (const std::string &name : bench::libraryVariables()) unsetenv(name.c_str());
    setenv("ODE_MT_ALGORITHM", options.algorithm.c_str(), 1);
    setenv("ODE_MT_GRID_CELLS", options.gridCells ? std::to_string(options.gridCells).c_str() : "auto", 1);
}

record::Header describe(const record::RecordOptions &options, const scenes::Scene &scene,
                        const record::Recorder &recorder) {
    const bench::LibraryProbe library = bench::probeLibrary();
    return {options.world, library.algorithm(), library.file, static_cast<double>(scene.stepSize()),
            recorder.geoms()};
}

void recordScene(const record::RecordOptions &options, std::ostream &out) {
    std::vector<std::string> warnings;
    const auto scene = bench::openWorld(options.world, options.ignoreUnsupported, warnings);
    for (const std::string &warning : warnings) std::cerr << warning << "\n";
    record::Recorder recorder(*scene);
    out << writeHeader(describe(options, *scene, recorder)) << "\n";
    for (long frame = 1; frame <= options.frames; ++frame) {
        recorder.runFrame();
        if (frame % options.every == 0 || frame == options.frames)
            out << writeFrame(recorder.frame()) << "\n";
    }
    if (!out.flush()) throw std::runtime_error("cannot write '" + options.file + "'");
}

}  // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const auto options = record::readRecordOptions(argc, argv, exitCode);
    if (!options) return exitCode;
    chooseAlgorithm(*options);
    dInitODE2(0);
    try {
        std::ofstream file;
        if (!options->file.empty()) {
            file.open(options->file);
            if (!file) throw std::runtime_error("cannot write '" + options->file + "'");
        }
        recordScene(*options, options->file.empty() ? std::cout : file);
    } catch (const std::exception &error) {
        std::cerr << error.what() << "\n";
        exitCode = 1;
    }
    dCloseODE();
    return exitCode;
}
