// The default broad phase of a space: brute force, a Verlet list or neighbours, as dxChooseBroadphase() decides.
#pragma once

#include <memory>

#include "collision/broadphase/dxBroadphase.h"
#include "collision/broadphase/dxBroadphaseChoice.h"
#include "collision/broadphase/dxBruteForce.h"
#include "collision/broadphase/dxNeighbourBroadphase.h"
#include "collision/broadphase/dxVerletBroadphase.h"

class dxAdaptiveBroadphase final : public dxBroadphase {
public:
    // `maxPairs` is as in dxGridBroadphase.
    explicit dxAdaptiveBroadphase(dxPairLimit maxPairs = dxUnlimitedPairs) : m_maxPairs(maxPairs) {}

    void findOverlaps(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches) override;

    dxBroadphaseKind current() const;

private:
    dxBroadphaseFacts factsOf(const dxMembers &members) const;
    void chooseBySize(const dxMembers &members);
    void findWithVerletList(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);
    void findWithNeighbours(const dxMembers &members, dxTaskRunner &runner, std::vector<Match> &matches);

    const dxPairLimit m_maxPairs;
    // One of them exists from the first call on.
    std::unique_ptr<dxBruteForceBroadphase> m_bruteForce;
    std::unique_ptr<dxVerletBroadphase> m_verlet;
    std::unique_ptr<dxNeighbourBroadphase> m_neighbours;
    int m_mismatchStreak = 0;  // in a row (dxPrefersOtherBroadphase)
};
