// What a soak plays: scenes that stay for all its time, and guests that come, live for some frames and go.
#pragma once

#include "recorder.h"

#include "scenes/generator.h"
#include "scenes/scene.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace soak {

// A block is one turn of every resident and the life of one guest. After a day, a number of blocks, the same guest comes
// again, and a day ends with an evening, a turn of every resident with the same settings each day, so that what memory is in
// use may be compared. Draws are the same on both libraries.
class Town {
public:
    // `maxThreads`: of ODE_MT, whose settings are drawn anew in every turn.
    Town(std::uint64_t seed, int maxThreads);

    static int blocksOfADay();

    // Returns a hash of all so far: of events, and of the state of all scenes at the ends of their turns.
    std::uint64_t playBlock();

    std::uint64_t frames() const { return m_frames; }

private:
    void playTurn(scenes::Scene &scene, int frames, bool isEvening = false);
    std::string drawPolicy();
    void drawSettings();
    void useEveningSettings() const;

    scenes::Generator m_draws;
    const int m_maxThreads;
    std::vector<std::unique_ptr<scenes::Scene>> m_residents;
    std::uint64_t m_hash = 0;
    std::uint64_t m_frames = 0;
    std::size_t m_block = 0;
};

}  // namespace soak
