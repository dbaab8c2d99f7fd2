#include "campaign.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>

namespace fuzz_driver {

bool readCampaignOptions(int argc, char **argv, const std::string &description, CampaignOptions &options,
                         std::vector<std::string> *replay, int &exitCode) {
    CLI::App app(description);
    app.add_option("--seed", options.seed, "first seed");
    app.add_option("--cases", options.cases, "how many, 0: as many as there is time for");
    app.add_option("--seconds", options.seconds, "time")->check(CLI::PositiveNumber);
    app.add_option("--keep", options.keep, "folder for what was found");
    app.add_flag("--show", options.shows, "print every case");
    if (replay)
        app.add_option("--replay", *replay, "what was kept, to play instead")->check(CLI::ExistingPath);
    try {
        app.parse(argc, argv);
        return true;
    } catch (const CLI::ParseError &error) {
        exitCode = app.exit(error) == 0 ? 0 : 2;
        return false;
    }
}

int runCampaign(const CampaignOptions &options, const std::string &nameOfCases,
                const std::function<Verdict(std::uint64_t seed)> &play) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point begin = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    std::map<std::string, std::uint64_t> verdicts;
    std::uint64_t played = 0, found = 0;
    for (std::uint64_t seed = options.seed;
         seconds() < options.seconds && (options.cases == 0 || played < options.cases); ++seed) {
        const Verdict verdict = play(seed);
        ++played;
        ++verdicts[verdict.kind];
        if (verdict.finding.empty()) continue;
        ++found;
        std::cout << "seed " << seed << ": " << verdict.finding << std::endl;
    }
    std::cout << played << ' ' << nameOfCases << " in " << seconds() << " s, "
              << static_cast<double>(played) / seconds() << " a second; " << found << " findings\n";
    for (const auto &[kind, count] : verdicts) std::cout << "  " << kind << ": " << count << '\n';
    return found == 0 && played > 0 ? 0 : 1;
}

}  // namespace fuzz_driver
