// The command line of odemt_report.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace report {

struct ReportOptions {
    std::string results;                  // the bench's JSON file; empty: none
    std::vector<std::string> recordings;  // at most two
    std::string file;
};

// Empty: the program ends with `exitCode`, as readOptions of odemt_bench.
std::optional<ReportOptions> readReportOptions(int argc, const char *const *argv, int &exitCode);

}  // namespace report
