// The order of upstream's sweep-and-prune space: by one number for each geom, and among equal numbers by the history of
// earlier calls.
//
// Upstream's radix sort begins with the order of its last call if there are as many numbers as then, else with that of
// their indices, and changes nothing if the numbers do not fall along it. Otherwise numbers rise, by their bits (-0
// before 0), and of equal ones those with their sign bit clear keep that order while those with it set reverse it. So
// the order of indices is a state that every call of upstream's changes, and every call here must change it likewise.
// docs/collision.md. Not thread safe.
#pragma once

#include <cstdint>
#include <vector>

class dxSapSort {
public:
    // Returns the indices of `keys` in order. NaN keys are ordered by their bits.
    const std::vector<std::uint32_t> &sort(const std::vector<float> &keys);

private:
    bool isInOrder(const std::vector<float> &keys) const;
    bool tryInserting(const std::vector<float> &keys);
    bool insertFew(const std::vector<float> &keys);
    void takeTieOrder(const std::vector<float> &keys);

    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t> m_tieOrder;  // indices in the order in which a stable sort must leave equal keys
    std::vector<std::uint64_t> m_items, m_spare;  // keys with places in m_tieOrder
    std::vector<std::uint32_t> m_sorted;          // scratch: keys, in order
    unsigned m_untried = 0, m_pause = 0;  // calls that do not try to insert few: still to come, and after the last that tried in vain
};
