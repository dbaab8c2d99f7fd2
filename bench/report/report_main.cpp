// odemt_report: results and recordings as one HTML page (page.h).
#include "tool_output.h"
#include "support/text.h"
#include "record/recording_check.h"
#include "report/page.h"
#include "report/report_options.h"
#include "result_file.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

std::string contentOf(const std::string &file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream content;
    content << stream.rdbuf();
    if (!stream) throw std::runtime_error("cannot read " + support::quote(file));
    return content.str();
}

// Checked here, so that the page need not.
report::NamedRecording recordingOf(const std::string &file, record::Header &header) {
    std::string content = contentOf(file);
    try {
        std::istringstream lines(content);
        record::Recording recording = record::readRecording(lines);
        if (recording.frames.empty()) throw std::runtime_error("no frames");
        header = std::move(recording.header);
    } catch (const std::runtime_error &error) {
        throw std::runtime_error(support::quote(file) + ": " + error.what());
    }
    return {file, std::move(content)};
}

std::vector<report::NamedRecording> recordingsOf(const std::vector<std::string> &files) {
    std::vector<report::NamedRecording> recordings;
    std::vector<record::Header> headers(files.size());
    for (std::size_t i = 0; i < files.size(); ++i) {
        recordings.push_back(recordingOf(files[i], headers[i]));
        recordings[i].otherWorld = record::whyOtherWorld(headers[0], headers[i]);
        if (!recordings[i].otherWorld.empty()) bench::printError(recordings[i].otherWorld);
    }
    return recordings;
}

void writePage(const report::ReportOptions &options) {
    bench::checkWritable(options.file);
    const std::vector<report::NamedRecording> recordings = recordingsOf(options.recordings);
    const std::string results = options.results.empty() ? "" : contentOf(options.results);
    if (!options.results.empty() && results.empty()) throw std::runtime_error(support::quote(options.results) + ": empty");
    std::string page;
    try {
        page = report::page(results, recordings);
    } catch (const std::runtime_error &error) {
        throw std::runtime_error(support::quote(options.results) + ": " + error.what());
    }
    bench::writeResultFile(options.file, page);
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const auto options = report::readReportOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    try {
        writePage(*options);
        return 0;
    } catch (const std::exception &error) {
        bench::printError(error.what());
        return 1;
    }
}
