// odemt_render: a frame of a recording (record/recording.h) as a picture.
#include "error_output.h"
#include "render/render_options.h"
#include "result_file.h"
#include "standard_output.h"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace {

record::Recording read(const std::string &file) {
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("cannot read '" + file + "': " + std::strerror(errno));
    try {
        record::Recording recording = record::readRecording(stream);
        if (recording.frames.empty()) throw std::runtime_error("it has no frames");
        return recording;
    } catch (const std::runtime_error &error) {
        throw std::runtime_error("'" + file + "' is no recording: " + error.what());
    }
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const auto options = render::readRenderOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    try {
        if (!options->file.empty()) {
            bench::checkDistinct({options->recording, options->file});
            bench::checkWritable(options->file);
        }
        const record::Recording recording = read(options->recording);
        const std::string picture = render::drawFrame(
            recording.header, render::chooseFrame(recording, options->frame), options->view);
        if (options->file.empty())
            bench::print(picture);
        else
            bench::writeResultFile(options->file, picture);
        return 0;
    } catch (const std::invalid_argument &error) {
        bench::printError(error.what());
        return bench::kWrongOption;
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return 1;
    }
}
