// The sort of upstream's sweep-and-prune space: by one key for each geom, and among equal keys by the history of earlier calls.
//
// Upstream's radix sort begins with the order of its last call if the number of keys is the same, otherwise with the order of indices. If the keys
// do not fall along that order, it leaves it unchanged. Otherwise it sorts by the bits of the keys (-0 before 0); equal keys without the sign bit
// keep their order, and equal keys with the sign bit reverse it. So the order of indices is a state that every sort changes, and each sort of
// upstream needs one here. docs/collision.md. Threading: not thread-safe.
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
    void setTieOrder(const std::vector<float> &keys);

    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t> m_tieOrder;  // indices in the order in which a stable sort must leave equal keys
    std::vector<std::uint64_t> m_items, m_spare;  // keys with their places in m_tieOrder
    std::vector<std::uint32_t> m_sorted;          // scratch: keys, in order
    unsigned m_untried = 0;  // number of the next calls that do not try an insertion sort
    unsigned m_pause = 0;    // the same number after the last failed trial
};
