// odemt_record: a world and its clusters, frame by frame, as JSON lines (recording.h).
#include "tool_output.h"
#include "platform.h"
#include "library_folders.h"
#include "record/record_options.h"
#include "record/recorder.h"
#include "result_file.h"
#include "world_source.h"

#include <ode/ode.h>

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace {

// Read by the library at its first use. What else the user has set must not change the recording.
void chooseAlgorithm(const record::RecordOptions &options) {
    for (const std::string &name : bench::libraryVariables()) unsetenv(name.c_str());
    setenv("ODE_MT_ALGORITHM", options.algorithm.c_str(), 1);
    setenv("ODE_MT_THREADS", std::to_string(options.threads).c_str(), 1);
    setenv("ODE_MT_GRID_CELLS", options.gridCells ? std::to_string(options.gridCells).c_str() : "auto", 1);
}

record::Header describe(const record::RecordOptions &options, const scenes::Scene &scene,
                        const record::Recorder &recorder) {
    const bench::LibraryProbe library = bench::probeLibrary();
    return {options.world, library.algorithm(), library.file, static_cast<double>(scene.stepSize()),
            recorder.geoms(), recorder.bodyNames()};
}

// Debian's library takes part in this process from its start only: the program is started again, with that library first.
void startOnStock(char **argv) {
    if (!bench::probeLibrary().isOurs) return;
    const char *const kStarted = "ODEMT_RECORD_STOCK";
    if (getenv(kStarted)) throw std::runtime_error(std::string("no libode.so.8 of Debian's in ") + ODEMT_STOCK_FOLDER);
    setenv(kStarted, "1", 1);
    setenv("LD_LIBRARY_PATH", ODEMT_STOCK_FOLDER, 1);
    execv("/proc/self/exe", argv);
    throw std::runtime_error(std::string("cannot start again: ") + std::strerror(errno));
}

using Line = std::function<void(const std::string &)>;

void recordScene(const record::RecordOptions &options, const Line &write) {
    std::vector<std::string> warnings;
    const auto scene = bench::openWorld(options.world, {options.ignoreUnsupported}, warnings);
    for (const std::string &warning : warnings) bench::printError(warning);
    record::Recorder recorder(*scene, {!options.onStock, options.contacts, options.threads > 0});
    write(writeHeader(describe(options, *scene, recorder)) + "\n");
    for (long frame = 1; frame <= options.frames; ++frame) {
        recorder.runFrame();
        if (frame % options.every == 0 || frame == options.frames)
            write(writeFrame(recorder.frame()) + "\n");
    }
}

void recordToFile(const record::RecordOptions &options) {
    if (std::filesystem::is_regular_file(options.world)) bench::checkDistinct({options.world, options.file});
    bench::checkWritable(options.file);
    bench::ResultStream stream(options.file);
    recordScene(options, [&](const std::string &line) { stream.append(line); });
    stream.finish();
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const auto options = record::readRecordOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    chooseAlgorithm(*options);
    dInitODE2(0);
    try {
        if (options->onStock) startOnStock(argv);
        if (options->file.empty())
            recordScene(*options, bench::print);
        else
            recordToFile(*options);
    } catch (const std::exception &error) {
        bench::printError(error.what());
        exitCode = 1;
    }
    dCloseODE();
    return exitCode;
}
