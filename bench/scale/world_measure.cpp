#include "scale/world_measure.h"

#include "library_folders.h"
#include "support/text_file.h"

#include <unistd.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <thread>

#include "support/process.h"
#include "support/temporary_folder.h"

namespace scale {

namespace {

constexpr std::chrono::milliseconds kLimit = std::chrono::minutes(5);  // for one batch of frames

constexpr const char *kTool = "odemt_scale";  // names folders for files of a measurement

struct FrameTimes {
    std::vector<double> frame, step;
    std::uint64_t hash = 0;
};

// A world in a process of its own, and its workers.
struct Party {
    std::string workers = "none";  // ODE_MT_WORKERS
    unsigned count = 0;
    bool sendsAll = false;
    std::string arguments;  // of workers
};

class Player {
public:
    Player(const std::string &world, const MeasureSettings &settings, const Party &party, const std::string &log)
        : m_log(log), m_process(command(world, settings, party, log), environment(settings, party)) {}

    FrameTimes run(int frames) {
        m_process.writeLine(std::to_string(frames));
        try {
            const nlohmann::json answer = nlohmann::json::parse(m_process.readLine(kLimit));
            return {answer.at("frame"), answer.at("step"), answer.at("hash")};
        } catch (const std::exception &error) {
            throw std::runtime_error(std::string(error.what()) + "\n" + support::readWhatIsThere(m_log));  // the program may not have begun
        }
    }
    void end() {
        m_process.writeEnd();
        m_process.waitForExit();
    }

private:
    // Workers by MPI are processes of the same job. Each chooses by its rank which program it is: the mpirun of Open MPI 5.0.7 crashes when it is to
    // start two (its issue 13303).
    static std::vector<std::string> command(const std::string &world, const MeasureSettings &settings, const Party &party, const std::string &log) {
        std::vector<std::string> words;
        if (party.workers != "mpi") return {settings.program, world, log};
        if (settings.worker.empty())
            throw std::runtime_error("there is no odemt_worker beside libode.so.8 in '" + settings.library +
                                     "' or beside this program (docs/packages.md)");
        return {"mpirun", "--enable-recovery", "-np", std::to_string(party.count + 1), "sh", "-c",
                R"([ "$OMPI_COMM_WORLD_RANK" != 0 ] || exec "$@"; exec "$0")", settings.worker, settings.program, world, log};
    }

    static support::Environment environment(const MeasureSettings &settings, const Party &party) {
        support::Environment changes;
        for (const std::string &name : bench::libraryVariables()) changes[name] = "";
        changes["ODE_MT_THREADS"] = "0";
        changes["ODE_MT_WORKERS"] = party.workers == "loopback" ? "loopback:" + std::to_string(party.count) : party.workers;
        changes["ODE_MT_LOG"] = "info";
        if (party.sendsAll) changes["ODE_MT_ALGORITHM"] = "lcp";
        changes["ODEMT_WORKER_ARGUMENTS"] = party.arguments;
        changes["LD_LIBRARY_PATH"] = settings.library;
        return changes;
    }

    const std::string m_log;
    support::LineProcess m_process;
};

// Two players in turns, on the same frames.
class Race {
public:
    Race(Player &home, Player &other) : m_home(home), m_other(other) {}

    // Throws if the worlds differ afterwards.
    void run(int frames) {
        if (frames <= 0) return;
        const FrameTimes atHome = m_home.run(frames), of = m_other.run(frames);
        if (atHome.hash != of.hash) throw std::runtime_error("results with workers differ from those at home");
        append(home, atHome);
        append(other, of);
        m_steppedNs = std::accumulate(of.step.begin(), of.step.end(), m_steppedNs);
    }
    void runBatches(int frames) {
        constexpr int kInTurn = 4;  // frames; machines change their speed within seconds
        for (int left = frames; left > 0; left -= kInTurn) run(std::min(left, kInTurn));
    }
    void forget() { home = other = {}; }

    // All steps of the other one, those that are forgotten, too.
    double steppedNs() const { return m_steppedNs; }

    FrameTimes home, other;

private:
    static void append(FrameTimes &to, const FrameTimes &from) {
        to.frame.insert(to.frame.end(), from.frame.begin(), from.frame.end());
        to.step.insert(to.step.end(), from.step.begin(), from.step.end());
    }

    Player &m_home, &m_other;
    double m_steppedNs = 0;
};

struct Link {
    double latencyNs, nsPerByte;
};

// "remote workers: 1 of 1 by mpi; latency 97 us, 3.21 GB/s"
Link readLink(const std::string &log) {
    const std::size_t line = log.find("remote workers: ");
    unsigned usable = 0, all = 0;
    double us = 0, gigabytes = 0;
    char name[32];
    if (line == std::string::npos ||
        std::sscanf(log.c_str() + line, "remote workers: %u of %u by %31[^;]; latency %lf us, %lf GB/s", &usable, &all, name, &us, &gigabytes) != 5 ||
        usable == 0)
        throw std::runtime_error("no worker:\n" + log);
    return {us * 1e3, gigabytes > 0 ? 1 / gigabytes : 0};
}

// Of all steps: how long home's threads have waited for workers.
double readWaitedNs(const std::string &log) {
    const std::size_t at = log.rfind("waited for them ");
    double ms = 0;
    if (at == std::string::npos || std::sscanf(log.c_str() + at, "waited for them %lf ms", &ms) != 1)
        throw std::runtime_error("the library has not told how long it waited:\n" + log);
    return ms * 1e6;
}

double measureSleep() {
    constexpr int kSleeps = 200;
    constexpr std::chrono::microseconds kAsked{20};
    std::vector<double> longer;
    for (int i = 0; i < kSleeps; ++i) {
        const auto begin = std::chrono::steady_clock::now();
        std::this_thread::sleep_for(kAsked);
        longer.push_back(std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - begin - kAsked).count());
    }
    return typical(longer);
}

// What a handshake measures while processes start varies by a factor of two: the least latency of several is that of a link in use.
Link measureLink(const std::string &world, const MeasureSettings &settings, const support::TemporaryFolder &scratch) {
    constexpr int kHandshakes = 5;
    std::vector<double> latencies, nsPerByte;
    for (int i = 0; i < kHandshakes; ++i) {
        const std::string log = scratch.file("link");
        Player(world, settings, {settings.transport, 1, true, ""}, log).end();
        const Link link = readLink(support::readWhatIsThere(log));
        latencies.push_back(link.latencyNs);
        nsPerByte.push_back(link.nsPerByte);
    }
    return {*std::min_element(latencies.begin(), latencies.end()), typical(nsPerByte)};
}

}  // namespace

MeasuredWorld measureWorld(const std::string &world, const MeasureSettings &settings) {
    const support::TemporaryFolder scratch(kTool);
    const std::string record = scratch.file("record"), log = scratch.file("away");
    Player home(world, settings, {}, scratch.file("home"));
    Player away(world, settings, {settings.transport, 1, true, "--record " + record}, log);
    Race race(home, away);
    MeasuredWorld measured;
    measured.world = world;
    // The first frames say how many there are time for: in the last of them things lie on one another.
    constexpr int kProbed = 4, kMinFrames = 4, kMaxFrames = 2000, kMaxWarmUp = 100;
    race.run(kProbed);
    measured.frames = static_cast<int>(
        std::clamp(settings.seconds * 1e9 / (race.home.frame.back() + race.other.frame.back()), double{kMinFrames}, double{kMaxFrames}));
    measured.warmUp = std::min(measured.frames, kMaxWarmUp);
    race.run(measured.warmUp - kProbed);
    race.forget();
    if (truncate(record.c_str(), 0) != 0) throw std::runtime_error("no worker has written " + record);
    race.runBatches(measured.frames);
    away.end();
    home.end();
    measured.homeFrameNs = typical(race.home.frame);
    measured.homeStepNs = typical(race.home.step);
    measured.awayStepNs = std::max(race.steppedNs() - readWaitedNs(support::readTextFile(log)), 0.0) / (measured.warmUp + measured.frames);
    measured.sleepNs = measureSleep();
    const Link link = measureLink(world, settings, scratch);
    measured.latencyNs = link.latencyNs;
    measured.nsPerByte = link.nsPerByte;
    measured.steps = readWorkRecord(support::readTextFile(record));
    return measured;
}

MeasuredFrames measureFrames(const MeasuredWorld &measured, const Cluster &cluster, const MeasureSettings &settings) {
    const support::TemporaryFolder scratch(kTool);
    Player home(measured.world, settings, {}, scratch.file("home"));
    Player other(measured.world, settings, {settings.transport, cluster.workers, cluster.sendsAll, cluster.network.workerArguments()},
                 scratch.file("other"));
    Race race(home, other);
    race.run(measured.warmUp);
    race.forget();
    race.runBatches(measured.frames);
    other.end();
    home.end();
    const std::string log = support::readTextFile(scratch.file("other"));
    unsigned long long sent = 0, solved = 0, taken = 0;
    unsigned late = 0;
    const std::size_t counts = log.rfind("remote workers: ");
    if (counts == std::string::npos ||
        std::sscanf(log.c_str() + counts, "remote workers: %llu islands sent, %llu solved there, %llu taken back; late %u times", &sent, &solved,
                    &taken, &late) != 4)
        throw std::runtime_error("the library has not counted islands:\n" + log);
    return {typical(race.home.frame), typical(race.other.frame), static_cast<double>(sent) / (measured.warmUp + measured.frames), late};
}

}  // namespace scale
