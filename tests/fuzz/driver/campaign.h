// Draws from one seed after another for some time, and reports the results.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace fuzz_driver {

struct CampaignOptions {
    std::uint64_t seed = 1;
    std::uint64_t cases = 0;  // 0: as many as there is time for
    double seconds = 60;
    std::string keep;    // folder for what was found; empty: nothing is kept
    bool shows = false;  // every case, as it is drawn
};

// What is common to the fuzzers' command lines. Returns false, and sets `exitCode`, when the program is to
// end.
bool readCampaignOptions(int argc, char **argv, const std::string &description, CampaignOptions &options,
                         std::vector<std::string> *replay, int &exitCode);

// What came of one seed.
struct Verdict {
    std::string kind;     // counted: "loaded", "refused: Value" ...
    std::string finding;  // empty: as it should be
};

// Calls `play` for one seed after the other and prints how many verdicts of each kind there were. Returns the
// exit code of the program: 1 when something was found, or when nothing was played.
int runCampaign(const CampaignOptions &options, const std::string &nameOfCases,
                const std::function<Verdict(std::uint64_t seed)> &play);

}  // namespace fuzz_driver
