#include "render/render_options.h"

#include <CLI/CLI.hpp>

#include <stdexcept>

#include "error_output.h"
#include "number_range.h"

namespace render {

std::optional<RenderOptions> readRenderOptions(int argc, const char *const *argv, int &exitCode) {
    RenderOptions options;
    View &view = options.view;
    CLI::App app("Draws a frame of a recording of odemt_record as SVG, coloured by cluster.", "odemt_render");
    app.add_option("recording", options.recording, "file of odemt_record")
        ->required()
        ->check(CLI::ExistingFile);
    app.add_option("--frame", options.frame, "number of the frame, or 'last'")->capture_default_str();
    app.add_option("--output", options.file, "file; standard output if it is not given");
    app.add_option("--width", view.width, "pixels")->capture_default_str()->check(bench::wholeNumberIn(10, 10'000));
    app.add_option("--azimuth", view.azimuth, "degrees: where the viewer stands; 0: along +x, 90: along +y")
        ->capture_default_str()
        ->check(bench::numberIn(-360, 360));
    app.add_option("--elevation", view.elevation, "degrees above the horizon")
        ->capture_default_str()
        ->check(bench::numberIn(1, 90));
    app.add_option("--radius", view.radius, "metres around what moves that are shown; 0: everything")
        ->capture_default_str()
        ->check(bench::numberIn(0, 1e6));
    try {
        app.parse(argc, argv);
        if (app.count("--output") != 0 && options.file.empty())
            throw CLI::ValidationError("--output", "a file of results has no name");
        return options;
    } catch (const CLI::ParseError &error) {
        exitCode = bench::exitCodeOf(app, error);
    }
    return std::nullopt;
}

const record::Frame &chooseFrame(const record::Recording &recording, const std::string &frame) {
    if (recording.frames.empty()) throw std::invalid_argument("the recording has no frames");
    std::string known;
    for (const record::Frame &candidate : recording.frames) {
        if (std::to_string(candidate.number) == frame) return candidate;
        known += std::to_string(candidate.number) + ", ";
    }
    if (frame == "last") return recording.frames.back();
    throw std::invalid_argument("--frame: no frame '" + frame + "' in the recording; there are: " + known +
                                "last");
}

}  // namespace render
