// A simulation that kills its remote workers (SIGKILL), stops and continues them (SIGSTOP), and has them send flipped bits, while islands are sent:
//
//   ODE_MT_WORKERS=mpi:4 LD_PRELOAD=libodemt_flipped_bits.so ODEMT_FAULT_TABLE=file mpirun --enable-recovery -np 1 odemt_worker_faults FAULTS [SEED
//   [SECONDS]]
//
// Each step has the hash of that without workers; the last line says how many faults there were, and how long steps took. It ends when there have
// been FAULTS, or after SECONDS (600), with status 1 if there have been fewer.
#include <fcntl.h>
#include <ode/ode.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <random>
#include <thread>
#include <utility>
#include <vector>

#include "fault_table.h"
#include "scenes/fnv1a.h"

namespace {

using Clock = std::chrono::steady_clock;
using Milliseconds = std::chrono::milliseconds;

constexpr int kChains = 16, kLinks = 60, kStepsOfRound = 50;

// Chains that swing from fixed points, each an island.
class Chains {
public:
    Chains() : m_world(dWorldCreate()) {
        dWorldSetGravity(m_world, 0, 0, dReal(-9.81));
        for (int chain = 0; chain < kChains; ++chain) {
            dBodyID last = nullptr;
            for (int i = 0; i < kLinks; ++i) {
                const dBodyID body = dBodyCreate(m_world);
                dMass mass;
                dMassSetBox(&mass, 1, dReal(0.9), dReal(0.2), dReal(0.1));
                dBodySetMass(body, &mass);
                dBodySetPosition(body, i + dReal(0.5), 3 * chain, dReal(0.01) * chain);
                dBodySetAngularVel(body, dReal(0.1) * i, 0, dReal(0.3) * (chain % 5));
                const dJointID joint = dJointCreateHinge(m_world, nullptr);
                dJointAttach(joint, body, last);
                dJointSetHingeAnchor(joint, i, 3 * chain, dReal(0.01) * chain);
                dJointSetHingeAxis(joint, i % 2, 1, 0);
                dJointSetHingeParam(joint, dParamLoStop, dReal(-0.8));
                dJointSetHingeParam(joint, dParamHiStop, dReal(0.8));
                m_bodies.push_back(body);
                last = body;
            }
        }
    }
    ~Chains() { dWorldDestroy(m_world); }
    Chains(const Chains &) = delete;
    Chains &operator=(const Chains &) = delete;

    void step() { dWorldStep(m_world, dReal(0.005)); }

    std::uint64_t hash() const {
        scenes::Fnv1a hash;
        for (const dBodyID body : m_bodies) {
            hash.add(dBodyGetPosition(body), 3 * sizeof(dReal));
            hash.add(dBodyGetQuaternion(body), 4 * sizeof(dReal));
            hash.add(dBodyGetLinearVel(body), 3 * sizeof(dReal));
            hash.add(dBodyGetAngularVel(body), 3 * sizeof(dReal));
        }
        return hash.value();
    }

private:
    const dWorldID m_world;
    std::vector<dBodyID> m_bodies;
};

// Hashes of all steps of a round without workers, by a process that has none.
std::vector<std::uint64_t> referenceOf() {
    std::vector<std::uint64_t> hashes(kStepsOfRound);
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    const pid_t child = fork();
    if (child == 0) {
        unsetenv("ODE_MT_WORKERS");
        dInitODE();
        Chains chains;
        for (std::uint64_t &hash : hashes) {
            chains.step();
            hash = chains.hash();
        }
        const ssize_t bytes = static_cast<ssize_t>(hashes.size() * sizeof hashes[0]);
        _exit(write(ends[1], hashes.data(), static_cast<std::size_t>(bytes)) == bytes ? 0 : 1);
    }
    close(ends[1]);
    char *to = reinterpret_cast<char *>(hashes.data());
    for (std::size_t left = hashes.size() * sizeof hashes[0]; left > 0;) {
        const ssize_t got = read(ends[0], to, left);
        if (got <= 0) std::abort();
        to += got;
        left -= static_cast<std::size_t>(got);
    }
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return hashes;
}

FaultTable *openTable() {
    const char *const file = std::getenv(FaultTable::kVariable);
    const int descriptor = file != nullptr ? open(file, O_RDWR | O_CREAT | O_TRUNC, 0600) : -1;
    if (descriptor < 0 || ftruncate(descriptor, sizeof(FaultTable)) != 0) return nullptr;
    return FaultTable::map(descriptor);
}

// Harms workers that have been welcomed and are given problems, one after the other.
class Harm {
public:
    struct Counts {
        unsigned kills = 0, stops = 0, flips = 0;
        unsigned all() const { return kills + stops + flips; }
    };

    Harm(FaultTable &table, unsigned seed) : m_table(table), m_random(seed), m_seen(FaultTable::kMaxWorkers), m_isHarmed(FaultTable::kMaxWorkers) {}

    // Once in a while, on its own thread.
    void harmOne() {
        continueStopped(false);
        const unsigned count = std::min(m_table.count.load(), FaultTable::kMaxWorkers);
        std::vector<unsigned> able;
        for (unsigned i = 0; i < count; ++i) {
            FaultTable::Worker &worker = m_table.workers[i];
            if (m_isHarmed[i]) continue;
            constexpr unsigned kGreetings = 10;  // hello and echoes
            const unsigned sent = worker.sent;
            if (sent > kGreetings && sent != std::exchange(m_seen[i], sent)) able.push_back(i);
        }
        if (able.empty()) return;
        const unsigned index = able[m_random() % able.size()];
        FaultTable::Worker &worker = m_table.workers[index];
        const unsigned kind = m_random() % 10;
        const pid_t process = worker.process;
        if (kind < 2) {
            m_isHarmed[index] = true;
            if (kill(process, SIGKILL) == 0) ++m_counts.kills;
        } else if (kind < 4) {
            m_isHarmed[index] = true;
            worker.wantFlip = 1 + m_random() % 100000;
            ++m_counts.flips;
        } else if (kill(process, SIGSTOP) == 0) {
            m_stopped.push_back({process, Clock::now() + Milliseconds(1 + m_random() % 300)});
            ++m_counts.stops;
        }
    }

    void continueStopped(bool all) {
        for (auto one = m_stopped.begin(); one != m_stopped.end();) {
            if (!all && Clock::now() < one->until) {
                ++one;
                continue;
            }
            kill(one->process, SIGCONT);
            one = m_stopped.erase(one);
        }
    }

    // Those that were asked for and happened.
    Counts counts() const {
        Counts counts = m_counts;
        counts.flips = 0;
        for (const FaultTable::Worker &worker : m_table.workers) counts.flips += worker.flipped;
        return counts;
    }

private:
    struct Stopped {
        pid_t process;
        Clock::time_point until;
    };

    FaultTable &m_table;
    std::mt19937 m_random;
    std::vector<unsigned> m_seen;  // messages
    std::vector<bool> m_isHarmed;
    std::vector<Stopped> m_stopped;
    Counts m_counts;
};

struct Span {
    Clock::time_point begin, end;

    double ms() const { return std::chrono::duration<double, std::milli>(end - begin).count(); }
    bool overlaps(const Span &other) const { return begin < other.end && other.begin < end; }
};

// The longest of the steps during which the process ran.
double longestOf(const std::vector<Span> &steps, const std::vector<Span> &pauses) {
    double longest = 0;
    for (const Span &step : steps) {
        if (std::none_of(pauses.begin(), pauses.end(), [&step](const Span &pause) { return pause.overlaps(step); }))
            longest = std::max(longest, step.ms());
    }
    return longest;
}

double msSince(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

}  // namespace

int main(int argumentCount, char **arguments) {
    const unsigned wanted = argumentCount > 1 ? static_cast<unsigned>(std::atoi(arguments[1])) : 20;
    const unsigned seed = argumentCount > 2 ? static_cast<unsigned>(std::atoi(arguments[2])) : 1;
    const double seconds = argumentCount > 3 ? std::atof(arguments[3]) : 600;
    FaultTable *const table = openTable();
    if (table == nullptr) {
        std::fprintf(stderr, "odemt_worker_faults: %s names no file that can be written\n", FaultTable::kVariable);
        return 2;
    }
    const std::vector<std::uint64_t> reference = referenceOf();
    dInitODE();
    Harm harm(*table, seed);
    std::mutex mutex;
    bool hasEnded = false;
    std::vector<Span> pauses;  // in which this process did not run, though it had not asked for that
    std::thread thread([&] {
        std::mt19937 random(seed + 1);
        for (;;) {
            const Clock::time_point sleepBegin = Clock::now();
            std::this_thread::sleep_for(Milliseconds(5 + random() % 60));
            if (msSince(sleepBegin) > 500) pauses.push_back({sleepBegin, Clock::now()});
            const std::lock_guard<std::mutex> hold(mutex);
            if (hasEnded) break;
            if (harm.counts().all() < wanted)
                harm.harmOne();
            else
                harm.continueStopped(false);
        }
        harm.continueStopped(true);
    });
    const Clock::time_point begin = Clock::now();
    std::vector<Span> steps;
    unsigned wrong = 0, faults = 0;
    while (wrong == 0 && faults < wanted && msSince(begin) < 1e3 * seconds) {
        Chains chains;
        for (const std::uint64_t hash : reference) {
            const Clock::time_point stepBegin = Clock::now();
            chains.step();
            steps.push_back({stepBegin, Clock::now()});
            wrong += chains.hash() != hash;
        }
        const std::lock_guard<std::mutex> hold(mutex);
        faults = harm.counts().all();
    }
    {
        const std::lock_guard<std::mutex> hold(mutex);
        hasEnded = true;
    }
    thread.join();
    dCloseODE();
    const Harm::Counts counts = harm.counts();
    const double longest = longestOf(steps, pauses);
    std::vector<double> times;
    for (const Span &step : steps) times.push_back(step.ms());
    std::sort(times.begin(), times.end());
    std::printf(
        "%u faults (%u killed, %u stopped, %u flipped bits) of %u worker processes in %.0f s; %zu steps, %u with another hash; median %.2f ms, 99 %% "
        "%.1f ms, longest %.1f ms (%.1f ms with %zu pauses of the whole process)\n",
        counts.all(), counts.kills, counts.stops, counts.flips, table->count.load(), msSince(begin) / 1e3, times.size(), wrong,
        times[times.size() / 2], times[times.size() * 99 / 100], longest, times.back(), pauses.size());
    std::fflush(nullptr);
    return wrong == 0 && counts.all() >= wanted ? 0 : 1;
}
