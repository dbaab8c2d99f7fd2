// libFuzzer makes inputs (input.h) and keeps those that reach new code of ode_mt/. Each is played on the library that is linked
// to this program, in a fork of it, and on Debian's, by odemt_fuzz_player. A script that differs is minimised and reported; then the
// program ends by an abort, so that libFuzzer keeps the input, too.
//
//   odemt_fuzz_coverage -max_total_time=600 --keep=found corpus
//
// Options with one dash are libFuzzer's.
#include "forked_play.h"
#include "input.h"
#include "kept_difference.h"
#include "script_comparison.h"
#include "shared_counters.h"

#include "threading/dxSchedulePoints.h"

#include <dlfcn.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace fuzz;

// libFuzzer's threads, which watch memory and time, would be missing in forks; a script that does not end is ended by its own
// alarm. Inputs are long from the beginning: short scripts end before they have made anything.
const char *const kOptions[] = {"-rss_limit_mb=0", "-timeout=0", "-len_control=0", "-max_len=8192"};

// libFuzzer handles signals to keep the input; the child's are an ending like others.
void restoreSignals() {
    for (const int number : {SIGSEGV, SIGBUS, SIGABRT, SIGILL, SIGFPE, SIGALRM, SIGINT, SIGTERM, SIGXFSZ, SIGUSR1, SIGUSR2})
        std::signal(number, SIG_DFL);
}

class Fuzzing {
public:
    explicit Fuzzing(std::string folder)
        : m_folder(std::move(folder)), m_comparison({ODE_MT_FUZZ_PLAYER, ODE_MT_STOCK_LIBRARY_DIR, ""}, playingHere()) {
        if (dlopen("libode.so.8", RTLD_NOLOAD | RTLD_LAZY) != nullptr)
            throw std::runtime_error("libode.so.8 is loaded beside the library under test");
    }

    // Returns whether the libraries agree; if not, prints the difference to standard error.
    bool agree(const std::uint8_t *bytes, std::size_t count) {
        const Input input = inputOf(bytes, count);
        if (m_comparison.compare(input.request, input.script) != Verdict::different) return true;
        const std::size_t hash = std::hash<std::string>()(std::string(reinterpret_cast<const char *>(bytes), count));
        std::cerr << keepDifference(m_comparison, input, "input-" + std::to_string(hash), m_folder);
        return false;
    }

private:
    std::shared_ptr<Playing> playingHere() {
        const auto atBirth = [this](const RequestHeader &request) {
            restoreSignals();
            m_counters.share();
            if (request.disturbs != 0) dxSetRandomPerturbation(1);
        };
        return std::make_shared<ForkedPlay>(atBirth, [this] { m_counters.collect(); });
    }

    const std::string m_folder;
    SharedCounters m_counters;
    Comparison m_comparison;
};

std::unique_ptr<Fuzzing> fuzzing;

std::string folderOf(int count, char **arguments) {
    const std::string option = "--keep=";
    for (int i = 1; i < count; ++i)
        if (std::string(arguments[i]).compare(0, option.size(), option) == 0) return arguments[i] + option.size();
    return "";
}

}  // namespace

// The program's own options come last, and so prevail.
extern "C" int LLVMFuzzerInitialize(int *count, char ***arguments) {
    static std::vector<char *> all;
    all.assign(*arguments, *arguments + *count);
    for (const char *option : kOptions) all.insert(all.begin() + 1, const_cast<char *>(option));
    const std::string folder = folderOf(*count, *arguments);
    *count = static_cast<int>(all.size());
    all.push_back(nullptr);
    *arguments = all.data();
    try {
        fuzzing = std::make_unique<Fuzzing>(folder);
    } catch (const std::exception &error) {
        std::cerr << "odemt_fuzz_coverage: " << error.what() << '\n';
        std::exit(2);
    }
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *bytes, std::size_t count) {
    if (!fuzzing->agree(bytes, count)) std::abort();
    return 0;
}
