#include "heuristics/dxHeuristicsManager.h"

#include <algorithm>

#include "heuristics/dxScopedFlag.h"

bool dxHeuristicsManager::insert(const std::string &name, std::unique_ptr<dxHeuristicBase> heuristic) {
    if (heuristic == nullptr || name.empty() || find(name) != nullptr) return false;
    m_entries.push_back({name, std::move(heuristic)});
    return true;
}

dxHeuristicBase *dxHeuristicsManager::find(const std::string &name) const {
    for (const Entry &entry : m_entries) {
        if (entry.heuristic != nullptr && entry.name == name) return entry.heuristic.get();
    }
    return nullptr;
}

bool dxHeuristicsManager::remove(const std::string &name) {
    for (Entry &entry : m_entries) {
        if (entry.heuristic == nullptr || entry.name != name) continue;
        m_removed.push_back(std::move(entry.heuristic));
        if (!m_ticking) sweep();
        return true;
    }
    return false;
}

std::vector<std::string> dxHeuristicsManager::names() const {
    std::vector<std::string> names;
    for (const Entry &entry : m_entries) {
        if (entry.heuristic != nullptr) names.push_back(entry.name);
    }
    return names;
}

bool dxHeuristicsManager::tick() {
    if (m_ticking) return false;
    ++m_frames;
    {
        const dxScopedFlag ticking(m_ticking);
        for (std::size_t i = 0, end = m_entries.size(); i < end; ++i) {
            if (m_entries[i].heuristic != nullptr) m_entries[i].heuristic->tick();
        }
    }
    sweep();
    return true;
}

void dxHeuristicsManager::sweep() {
    m_entries.erase(std::remove_if(m_entries.begin(), m_entries.end(),
                                   [](const Entry &entry) { return entry.heuristic == nullptr; }),
                    m_entries.end());
    m_removed.clear();
}

unsigned dxHeuristicsManager::forAll(bool (dxHeuristicBase::*change)()) {
    unsigned followed = 0;
    for (Entry &entry : m_entries) {
        if (entry.heuristic != nullptr && (entry.heuristic.get()->*change)()) ++followed;
    }
    return followed;
}

unsigned dxHeuristicsManager::startAll() { return forAll(&dxHeuristicBase::start); }
unsigned dxHeuristicsManager::pauseAll() { return forAll(&dxHeuristicBase::pause); }
unsigned dxHeuristicsManager::resetAll() { return forAll(&dxHeuristicBase::reset); }
unsigned dxHeuristicsManager::stopAll() { return forAll(&dxHeuristicBase::stop); }
