// odemt_render: a frame of a recording (record/recording.h) as a picture.
#include "render/render_options.h"

#include <fstream>
#include <iostream>

namespace {

record::Recording read(const std::string &file) {
    std::ifstream stream(file);
    try {
        return record::readRecording(stream);
    } catch (const std::runtime_error &error) {
        throw std::runtime_error("'" + file + "' is no recording: " + error.what());
    }
}

void write(const std::string &text, const std::string &file) {
    std::ofstream stream(file);
    stream << text;
    stream.close();
    if (!stream) throw std::runtime_error("cannot write '" + file + "'");
}

}  // namespace

int main(int argc, char **argv) {
    int exitCode = 0;
    const auto options = render::readRenderOptions(argc, argv, exitCode);
    if (!options) return exitCode;
    try {
        const record::Recording recording = read(options->recording);
        const std::string picture = render::drawFrame(
            recording.header, render::chooseFrame(recording, options->frame), options->view);
        if (options->file.empty())
            std::cout << picture;
        else
            write(picture, options->file);
        return 0;
    } catch (const std::invalid_argument &error) {
        std::cerr << error.what() << "\n";
        return 2;
    } catch (const std::exception &error) {
        std::cerr << error.what() << "\n";
        return 1;
    }
}
