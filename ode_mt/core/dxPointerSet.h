// A set of addresses, which tells whether one has come before. Open addressing: one array, at most half full.
//
// Threading: one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

class dxPointerSet {
public:
    // Returns false if it is in the set already. Requires an address other than null. Throws std::bad_alloc, and changes nothing then.
    bool insert(const void *pointer) {
        if (2 * m_count >= m_slots.size()) grow();
        const void *&slot = slotOf(m_slots, pointer);
        if (slot == pointer) return false;
        slot = pointer;
        ++m_count;
        return true;
    }

private:
    using Slots = std::vector<const void *>;

    // Returns the slot where it is, or else the slot for it.
    static const void *&slotOf(Slots &slots, const void *pointer) {
        constexpr std::uint64_t kGoldenRatio = 0x9e3779b97f4a7c15u;  // Knuth, "Sorting and Searching", 6.4: multiplicative hashing
        const std::size_t mask = slots.size() - 1;
        std::size_t at = (reinterpret_cast<std::uintptr_t>(pointer) * kGoldenRatio >> 32) & mask;
        while (slots[at] != nullptr && slots[at] != pointer) at = (at + 1) & mask;
        return slots[at];
    }

    void grow() {
        Slots larger(m_slots.empty() ? 64 : 4 * m_slots.size());
        for (const void *pointer : m_slots)
            if (pointer != nullptr) slotOf(larger, pointer) = pointer;
        m_slots = std::move(larger);
    }

    Slots m_slots;
    std::size_t m_count = 0;
};
