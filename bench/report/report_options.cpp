#include "report/report_options.h"

#include <stdexcept>

#include "tool_output.h"
#include "result_file.h"

#include <CLI/CLI.hpp>

namespace report {

namespace {

constexpr std::size_t kMaxRecordings = 2;

void addOptions(CLI::App &app, ReportOptions &options) {
    app.add_option("results", options.results, "JSON file of odemt_bench")->check(CLI::ExistingFile);
    app.add_option("--recording", options.recordings, "file of odemt_record; given twice, both are shown side by side")
        ->check(CLI::ExistingFile)
        ->allow_extra_args(false);
    app.add_option("--output", options.file, "the page")->required();
}

void check(const ReportOptions &options) {
    if (options.results.empty() && options.recordings.empty())
        throw std::invalid_argument("results: neither a file of results nor a --recording is given");
    if (options.recordings.size() > kMaxRecordings)
        throw std::invalid_argument("--recording: " + std::to_string(options.recordings.size()) + " are given; at most two are shown");
    std::vector<std::string> files = {options.file};
    if (!options.results.empty()) files.push_back(options.results);
    bench::checkDistinct(files);
    for (const std::string &recording : options.recordings) bench::checkDistinct({options.file, recording});
}

}  // namespace

std::optional<ReportOptions> readReportOptions(int argc, const char *const *argv, int &exitCode) {
    ReportOptions options;
    CLI::App app("Writes what odemt_bench has measured and odemt_record recorded as one HTML page, which needs no network.",
                 "odemt_report");
    addOptions(app, options);
    const auto read = [&] {
        app.parse(argc, argv);
        check(options);
    };
    if (!bench::readCommandLine(app, read, exitCode)) return std::nullopt;
    return options;
}

}  // namespace report
