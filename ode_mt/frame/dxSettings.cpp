#include "frame/dxSettings.h"

#include <ode/error.h>
#include <ode/ode_MT.h>
#include <sched.h>

#include <cstdlib>
#include <cstring>

namespace {

struct AlgorithmName {
    const char *name;
    dxAlgorithm algorithm;
};
constexpr AlgorithmName kAlgorithms[] = {
    {"auto", dxAlgorithm::Auto}, {"serial", dxAlgorithm::Serial}, {"lcp", dxAlgorithm::Lcp}};

unsigned usableCores() {
    cpu_set_t set;
    if (sched_getaffinity(0, sizeof set, &set) != 0) return 1;
    const int count = CPU_COUNT(&set);
    return count > 0 ? static_cast<unsigned>(count) : 1;
}

}  // namespace

dxSettings &dxSettings::instance() {
    static dxSettings *const settings = new dxSettings;  // never destroyed: steps may run while the process ends
    return *settings;
}

dxSettings::dxSettings() : m_cores(usableCores()) {
    if (const char *text = std::getenv("ODE_MT_THREADS")) readThreads(text);
    if (const char *text = std::getenv("ODE_MT_ALGORITHM")) setAlgorithm(text);
}

void dxSettings::readThreads(const char *text) {
    if (std::strcmp(text, "auto") == 0) {
        setThreads(dODE_MT_AUTO);
        return;
    }
    char *end = nullptr;
    const long number = std::strtol(text, &end, 10);
    if (end == text || *end != '\0') {
        dMessage(0, "ODE_MT_THREADS is '%s'; known: auto, or a number from 0 to %d. Steps stay serial.", text,
                 dODE_MT_MAX_THREADS);
        return;
    }
    setThreads(number < 0 ? -1 : number >= dODE_MT_AUTO ? dODE_MT_AUTO - 1 : static_cast<int>(number));
}

void dxSettings::setThreads(int threads) {
    if (threads == dODE_MT_AUTO) {
        threads = static_cast<int>(m_cores);
    } else if (threads < 0) {
        dMessage(0, "ODE_MT: %d threads asked for; the least is 0 (serial), which is taken", threads);
        threads = 0;
    }
    if (threads > dODE_MT_MAX_THREADS) {
        dMessage(0, "ODE_MT: %d threads asked for; the most is %d, which is taken", threads, dODE_MT_MAX_THREADS);
        threads = dODE_MT_MAX_THREADS;
    }
    m_threads.store(static_cast<unsigned>(threads), std::memory_order_relaxed);
}

const char *dxSettings::algorithmName() const {
    for (const AlgorithmName &known : kAlgorithms) {
        if (known.algorithm == algorithm()) return known.name;
    }
    return "";
}

bool dxSettings::setAlgorithm(const std::string &name) {
    std::string names;
    for (const AlgorithmName &known : kAlgorithms) {
        if (name == known.name) {
            m_algorithm.store(known.algorithm, std::memory_order_relaxed);
            return true;
        }
        names += (names.empty() ? "" : ", ") + std::string(known.name);
    }
    dMessage(0, "ODE_MT: no algorithm '%s'; known: %s", name.c_str(), names.c_str());
    return false;
}
