#include "worlds/loading.h"

#include "support/child_run.h"
#include "driver/message_text.h"
#include "fields.h"
#include "loader/load_world.h"

#include <sys/stat.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <chrono>
#include <iostream>
#include <sstream>

// If LeakSanitizer is linked, it checks for leaks now.
extern "C" __attribute__((weak)) int __lsan_do_recoverable_leak_check();

namespace fuzz_worlds {

namespace {

using support::Ending;
using nlohmann::json;

constexpr int kFrames = 5;

#ifdef __SANITIZE_ADDRESS__
constexpr bool kIsSlowed = true;  // and takes more memory
#else
constexpr bool kIsSlowed = false;
#endif

class Digest {
public:
    void add(std::uint64_t word) {
        for (int byte = 0; byte < 64; byte += 8) m_hash = (m_hash ^ (word >> byte & 0xff)) * 0x100000001b3u;
    }
    void add(const std::string &text) {
        for (const char c : text) add(static_cast<std::uint64_t>(static_cast<unsigned char>(c)));
        add(std::uint64_t{text.size()});
    }
    std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325u;  // FNV-1a
};

// Returns the state of the scene from ODE, and the names of its parts.
std::uint64_t digestOf(const worlds::SdfScene &scene) {
    Digest digest;
    for (const auto *names : {&scene.bodyNames(), &scene.jointNames(), &scene.geomNames()})
        for (const std::string &name : *names) digest.add(name);
    const exactness::Names names(scene.inventory());
    exactness::readState(
        scene.inventory(), names,
        [&](exactness::Kind kind, std::size_t index, const char *field, const exactness::Reading &reading) {
            digest.add(static_cast<std::uint64_t>(kind));
            digest.add(std::uint64_t{index});
            digest.add(std::string(field));
            for (const exactness::Word &word : reading.words()) digest.add(word.bits);
            digest.add(reading.text());
        });
    return digest.value();
}

const char *nameOf(worlds::LoadError::Kind kind) {
    constexpr const char *names[] = {"File", "Syntax", "Value", "Unsupported", "Memory", "Resource"};
    return names[static_cast<int>(kind)];
}

void tell(const json &what) {
    std::cout << what.dump(-1, ' ', false, json::error_handler_t::ignore) << std::endl;
}

// In bytes; standard error is a file.
std::size_t lengthOfErrors() {
    struct stat file {};
    fstat(STDERR_FILENO, &file);
    return static_cast<std::size_t>(file.st_size);
}

int loadAndStep(const WorldCase &world, const std::string &file) {
    std::vector<std::string> warnings;
    worlds::LoadOptions options;
    options.ignoreUnsupported = world.ignoreUnsupported;
    options.staticMeetsStatic = world.staticMeetsStatic;
    options.staticShapes = world.staticShapes;
    options.warnings = &warnings;
    const auto begin = std::chrono::steady_clock::now();
    try {
        auto scene = worlds::loadWorld(file, options);
        const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - begin;
        tell({{"loaded", digestOf(*scene)},
              {"warnings", warnings},
              {"errors", lengthOfErrors()},
              {"seconds", duration.count()}});
        for (int i = 0; i < kFrames; ++i) scene->frame();
        tell({{"later", digestOf(*scene)}});
        scene.reset();
    } catch (const worlds::LoadError &error) {
        // The message is sent as bytes, as it may not be UTF-8.
        const std::string what = error.what();
        tell({{"refused", nameOf(error.kind())},
              {"message", std::vector<unsigned char>(what.begin(), what.end())},
              {"file", error.place().file},
              {"path", error.place().path},
              {"errors", lengthOfErrors()}});
    }
    if (__lsan_do_recoverable_leak_check && __lsan_do_recoverable_leak_check())
        return fuzz_driver::kSanitizerExitCode;
    return 0;
}

std::string faultOf(const Ending &ending, const std::string &stage) {
    std::string fault = ending.text() + " while it " + stage;
    const std::string report = fuzz_driver::sanitizerReportIn(ending.errors);
    if (!report.empty())
        fault += ": " + report;
    else if (!ending.errors.empty())
        fault += ": " + fuzz_driver::shown(ending.errors, 1000);
    return fault;
}

}  // namespace

Loading load(const WorldCase &world, const std::filesystem::path &folder) {
    const std::string file = (folder / kWorldFile).string();
    support::Limits limits;
    limits.cpuSeconds = kIsSlowed ? 60 : 20;
    limits.seconds = 8 * limits.cpuSeconds;
    limits.memory = memoryBound(world) * (kIsSlowed ? 3 : 1) + (kIsSlowed ? std::size_t{1} << 30 : 0);
    const Ending ending = support::runFunction([&] { return loadAndStep(world, file); }, limits);

    Loading loading;
    loading.errors = ending.errors;
    loading.peakMemory = ending.peakMemory;
    std::string stage = "loads";
    std::istringstream lines(ending.output);
    for (std::string line; std::getline(lines, line);) {
        const json told = json::parse(line, nullptr, false);
        if (told.is_discarded()) continue;
        if (told.value("errors", 0) > 0) {
            loading.fault =
                "words on standard error while it loads: " + fuzz_driver::shown(ending.errors, 1000);
            return loading;
        }
        if (told.contains("loaded")) {
            stage = "steps";
            loading.digest = told["loaded"];
            loading.warnings = told["warnings"].get<std::vector<std::string>>();
            loading.loadSeconds = told["seconds"];
        } else if (told.contains("later")) {
            stage = "ends";
            loading.laterDigest = told["later"];
            loading.result = Loading::Result::Loaded;
        } else {
            stage = "ends";
            loading.errorKind = told["refused"];
            const auto bytes = told["message"].get<std::vector<unsigned char>>();
            loading.message.assign(bytes.begin(), bytes.end());
            loading.placeFile = told["file"];
            loading.placePath = told["path"];
            loading.result = Loading::Result::Refused;
        }
    }
    if (ending.ranOutOfTime && stage == "steps") {
        loading.result = Loading::Result::SlowToStep;
        return loading;
    }
    if (ending.exited() && ending.exitCode() == 0 && loading.result != Loading::Result::Broken)
        return loading;
    loading.result = Loading::Result::Broken;
    loading.fault = faultOf(ending, stage);
    return loading;
}

}  // namespace fuzz_worlds
