// Partitions bodies into compact parts of about equal weight, by recursive coordinate bisection (RCB) along the longest
// axis (Berger and Bokhari, "A partitioning strategy for nonuniform problems on multiprocessors", 1987).
//
// Linear in the bodies for each doubling of the parts. Any partition is correct: it affects speed alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <ode/common.h>

struct dxPlace {
    dReal at[3];
};

class dxBodyPartition {
public:
    using Partition = std::uint16_t;

    // `places`, `weights`: by body.
    void partition(const std::vector<dxPlace> &places, const std::vector<unsigned> &weights, unsigned parts);

    Partition partitionOf(std::size_t body) const { return m_partition[body]; }

private:
    struct Bisection {
        std::size_t begin, end;  // in m_bodies
        unsigned firstPart, parts;
    };

    std::vector<Partition> m_partition;             // by body
    std::vector<unsigned> m_bodies;       // those of a part lie side by side
    std::vector<Bisection> m_open;
};
