// Draws worlds from seeds, loads each in a process of its own, and keeps those of which the loader makes
// something else than a scene or an error that helps.
//
//   odemt_fuzz_worlds --seconds 300 --seed 1 --keep found
//   odemt_fuzz_worlds --replay found/17
#include "driver/campaign.h"
#include "support/child_run.h"
#include "driver/message_text.h"
#include "support/temporary_folder.h"
#include "worlds/bases.h"
#include "worlds/case_mutation.h"
#include "worlds/case_shrinking.h"
#include "worlds/judge.h"

#include "loader/load_world.h"

#include <ode/ode.h>

#include <iostream>
#include <set>

// Read by the sanitizers, where there are any: exit codes of their own, and what Assimp does not free of
// damaged files.
extern "C" const char *__asan_default_options() { return "exitcode=99"; }
extern "C" const char *__ubsan_default_options() { return "exitcode=99:print_stacktrace=1"; }
extern "C" const char *__lsan_default_suppressions() { return "leak:libassimp.so\n"; }

namespace {

using namespace fuzz_worlds;
using fuzz_driver::Random;
using fuzz_driver::Verdict;

constexpr double kSecondsToShrink = 120;

class Fuzzer {
public:
    explicit Fuzzer(const fuzz_driver::CampaignOptions &options)
        : m_options(options), m_bases(readBases(ODE_MT_FUZZ_WORLDS)), m_judge(m_folder.path() / "case") {}

    Verdict play(std::uint64_t seed) {
        Random random(seed);
        // Benchmark worlds take a hundred times as long as the others.
        WorldCase world = random.oneIn(40)  ? random.of(m_bases.large)
                          : random.oneIn(3) ? m_bases.small.front()
                                            : random.of(m_bases.small);
        switch (random.below(8)) {
            case 0:
                return playForbidden(seed, world, random);
            case 1:
            case 2:
                return playSpelling(seed, world, random);
            default:
                mutateCase(world, random);
                show(seed, world);
                return verdict(seed, world, [this](const WorldCase &tried) { return m_judge.loads(tried); });
        }
    }

    void replay(const std::string &folder) {
        const Judgement judgement = m_judge.loads(readCase(folder));
        std::cout << folder << ": " << judgement.kind
                  << (judgement.complaint.empty() ? "" : ", " + judgement.complaint) << '\n';
        m_found = m_found || !judgement.complaint.empty();
    }
    bool hasFound() const { return m_found; }

private:
    using Trial = std::function<Judgement(const WorldCase &)>;

    Verdict playForbidden(std::uint64_t seed, const WorldCase &world, Random &random) {
        const auto change = drawForbidden(world, random);
        if (!change) return {"nothing to change", ""};
        if (m_options.shows) std::cout << seed << ": " << world.name << ": " << change->text() << '\n';
        return verdict(seed, world,
                       [this, change](const WorldCase &tried) { return m_judge.refuses(tried, *change); });
    }

    Verdict playSpelling(std::uint64_t seed, const WorldCase &world, Random &random) {
        std::vector<Spelling> ways;
        for (int way = 0; way < kSpellings; ++way)
            if (random.oneIn(4)) ways.push_back(static_cast<Spelling>(way));
        if (ways.empty()) ways.push_back(static_cast<Spelling>(random.below(kSpellings)));
        const std::uint64_t spelling = random.next();
        const auto understands = [&](const std::vector<Spelling> &some) {
            return m_judge.understands(world, some, spelling);
        };
        if (m_options.shows) std::cout << seed << ": " << world.name << ": spelling\n";
        const Judgement judgement = understands(ways);
        if (judgement.complaint.empty()) return {judgement.kind, ""};
        for (std::size_t i = ways.size(); i-- > 0;) {  // those that it takes
            std::vector<Spelling> fewer = ways;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
            if (!fewer.empty() && !understands(fewer).complaint.empty()) ways = fewer;
        }
        return verdict(seed, world, [this, ways, spelling](const WorldCase &tried) {
            return m_judge.understands(tried, ways, spelling);
        });
    }

    // Returns the verdict; for a finding with the minimised world, and where it is saved.
    Verdict verdict(std::uint64_t seed, const WorldCase &world, const Trial &trial) {
        const Judgement judgement = trial(world);
        if (judgement.complaint.empty()) return {judgement.kind, ""};
        std::string told = world.name + ": " + judgement.complaint;
        if (!m_classes.insert(classOf(judgement.complaint)).second) return {judgement.kind, told};
        const WorldCase small = shrunk(
            world,
            [&](const WorldCase &tried) {
                return classOf(trial(tried).complaint) == classOf(judgement.complaint);
            },
            kSecondsToShrink);
        told += "\nmade small: " + trial(small).complaint;
        for (const auto &[file, text] : small.files)
            told += "\n" + file + ":\n" + fuzz_driver::shown(text, 1500);
        if (!m_options.keep.empty())
            writeCase(small, std::filesystem::path(m_options.keep) / std::to_string(seed));
        return {judgement.kind, told};
    }

    void show(std::uint64_t seed, const WorldCase &world) const {
        if (m_options.shows) std::cout << seed << ": " << world.name << '\n' << world.world() << '\n';
    }

    const fuzz_driver::CampaignOptions &m_options;
    const support::TemporaryFolder m_folder;
    const Bases m_bases;
    Judge m_judge;
    std::set<std::string> m_classes;  // of complaints; the first of each is made small
    bool m_found = false;
};

}  // namespace

int main(int argc, char **argv) {
    fuzz_driver::CampaignOptions options;
    std::vector<std::string> replay;
    int exitCode = 0;
    if (!fuzz_driver::readCampaignOptions(argc, argv, "Loads drawn worlds.", options, &replay, exitCode))
        return exitCode;
    try {
        dInitODE2(0);
        Fuzzer fuzzer(options);
        if (replay.empty())
            return fuzz_driver::runCampaign(options, "worlds",
                                            [&](std::uint64_t seed) { return fuzzer.play(seed); });
        for (const std::string &folder : replay) fuzzer.replay(folder);
        return fuzzer.hasFound() ? 1 : 0;
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz_worlds: " << error.what() << '\n';
        return 2;
    }
}
