// Members of a space with ranks as those of a quad tree, which come, go and change at random.
#pragma once

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "collision/pairs/dxMembers.h"

class RankedMembers : public testing::Test {
protected:
    using Slot = dxMembers::Slot;

    Slot add() {
        const Slot slot = members.add(reinterpret_cast<dxGeom *>(8));  // not read
        members.setRank(slot, nextRank());
        taken.push_back(slot);
        return slot;
    }
    void removeAny() {
        const std::size_t i = random() % taken.size();
        members.remove(taken[i]);
        taken.erase(taken.begin() + static_cast<std::ptrdiff_t>(i));
    }
    // They neither rise nor fall with time.
    dxRank nextRank() { return (random() % 4 << 40) + ++ranks; }
    Slot any() { return taken[random() % taken.size()]; }

    std::mt19937_64 random{1};
    dxMembers members;
    std::vector<Slot> taken;
    dxRank ranks = 0;
};
