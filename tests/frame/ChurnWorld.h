// A small world in full churn: boxes and balls in groups that touch, one of which goes and another comes in every frame, while
// one jumps elsewhere, one is pushed and one falls asleep. Islands, pairs and joint lists change with every frame.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <vector>

class ChurnWorld {
public:
    ChurnWorld();
    ~ChurnWorld();
    ChurnWorld(const ChurnWorld &) = delete;
    ChurnWorld &operator=(const ChurnWorld &) = delete;

    void frames(int count);

    // FNV-1a over poses, velocities, enabled flags and the random seed.
    std::uint64_t hash() const;

private:
    void add();
    void change();

    static constexpr unsigned kBodies = 48, kGroups = 8;

    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_group;
    std::vector<dBodyID> m_bodies;
    unsigned m_frame = 0, m_made = 0;
};
