#include "town.h"

#include "engine_statistics.h"
#include "only_ours.h"

#include <array>
#include <cstddef>
#include <iterator>

namespace soak {

namespace {

// The scenes that never come to rest.
constexpr const char *kResidents[] = {"churn:150,hash",     "churn:150,sap,world", "churn:150,quadtree", "churn:100,simple",
                                      "humanoids:2,simple", "soccer:4",            "rover:20,sap",       "vehicles:2"};

constexpr const char *kGuests[] = {"stacks:12",
                                   "pile:120,sap",
                                   "spheres:80,quadtree,autodisable",
                                   "ragdolls:8,simple",
                                   "chain:20",
                                   "wall:7,hash",
                                   "vehicles_heightfield:3,sap",
                                   "crowd:300,quadtree,autodisable",
                                   "mesh_terrain:60,hash",
                                   "heightfield_terrain:60,sap",
                                   "convex:60,quadtree",
                                   "rays:100",
                                   "humanoids:6,hash",
                                   "churn:200,sap,autodisable",
                                   "stacks:4,world,simple"};

constexpr int kFramesOfATurn = 50;
constexpr int kFramesOfAGuest = 100;
constexpr int kFramesOfASetting = 5;
constexpr int kFramesOfAnEvening = 20;

template <std::size_t size>
const char *drawnOf(const char *const (&names)[size], scenes::Generator &draws) {
    return names[draws.next() % size];
}

}  // namespace

Town::Town(std::uint64_t seed, int maxThreads) : m_draws(seed), m_maxThreads(maxThreads) {
    for (const char *resident : kResidents) m_residents.push_back(scenes::makeScene(resident));
}

int Town::blocksOfADay() { return static_cast<int>(std::size(kGuests)); }

std::uint64_t Town::playBlock() {
    for (const auto &resident : m_residents) playTurn(*resident, kFramesOfATurn);
    playTurn(*scenes::makeScene(kGuests[m_block % std::size(kGuests)]), kFramesOfAGuest);
    if (++m_block % std::size(kGuests) == 0)
        for (const auto &resident : m_residents) playTurn(*resident, kFramesOfAnEvening, true);
    return m_hash;
}

// Callbacks that may run at once have no order to compare.
void Town::playTurn(scenes::Scene &scene, int frames, bool isEvening) {
    using Order = exactness::Recorder::Order;
    const std::string policy = isEvening ? "serial" : drawPolicy();
    fuzz::callIfThere("dODE_MT_SetCallbackPolicy", policy.c_str());
    if (isEvening) useEveningSettings();
    exactness::Recorder recorder(scene, exactness::Recorder::noStep, policy == "serial" ? Order::kept : Order::ignored);
    scene.observe(&recorder);
    for (int frame = 0; frame < frames; ++frame) {
        if (!isEvening && frame % kFramesOfASetting == 0) drawSettings();
        scene.frame();
    }
    recorder.endStage("turn");
    scene.observe(nullptr);
    m_frames += static_cast<std::uint64_t>(frames);
    const std::uint64_t seen = recorder.take({}).stages.back().hash;
    m_hash = (m_hash ^ seen) * 0x9e3779b97f4a7c15u;
    m_hash ^= m_hash >> 32;
}

std::string Town::drawPolicy() {
    constexpr const char *policies[] = {"serial", "serial", "concurrent", "independent"};
    return drawnOf(policies, m_draws);
}

void Town::drawSettings() {
    constexpr const char *managers[] = {"pthread", "pthread", "pthread", "openmp"};
    constexpr const char *algorithms[] = {"auto",   "auto",   "lcp",         "lcp",       "serial",
                                          "static", "original", "static-unmerged", "duplication", "decluster"};
    constexpr const char *heuristics[] = {"default", "none", "cells,centre", "crossover,declustering,threads"};
    fuzz::callIfThere("dToggleODE_MT", static_cast<int>(m_draws.next() % static_cast<unsigned>(m_maxThreads + 1)));
    fuzz::callIfThere("dODE_MT_SetThreadManager", drawnOf(managers, m_draws));
    fuzz::callIfThere("dODE_MT_SetAlgorithm", drawnOf(algorithms, m_draws));
    fuzz::callIfThere("dODE_MT_SetHeuristics", drawnOf(heuristics, m_draws));
}

// All workers take part, and spaces have no clusters.
void Town::useEveningSettings() const {
    fuzz::callIfThere("dToggleODE_MT", m_maxThreads);
    fuzz::callIfThere("dODE_MT_SetThreadManager", "pthread");
    fuzz::callIfThere("dODE_MT_SetAlgorithm", "lcp");
    fuzz::callIfThere("dODE_MT_SetHeuristics", "default");
}

}  // namespace soak
