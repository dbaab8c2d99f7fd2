#include "collision/spaces/sweep_and_prune/dxSapSort.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>

#include "core/dxRadixSort.h"

namespace {

constexpr std::uint32_t kSign = UINT32_C(1) << 31;

// Shifts per key, above which an insertion sort takes longer than a radix sort.
constexpr std::size_t kMaxShiftsPerKey = 4;

// Largest number of calls without a trial of an insertion sort, after many failed trials.
constexpr unsigned kMaxPause = 15;

std::uint32_t bitsOf(float key) {
    std::uint32_t bits;
    std::memcpy(&bits, &key, sizeof bits);
    return bits;
}

// Returns an integer that sorts as the number with these bits, and NaN beyond all other numbers of its sign.
std::uint32_t sortable(std::uint32_t bits) {
    return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

}  // namespace

const std::vector<std::uint32_t> &dxSapSort::sort(const std::vector<float> &keys) {
    if (m_order.size() != keys.size()) {
        m_order.resize(keys.size());
        std::iota(m_order.begin(), m_order.end(), 0);
    }
    if (isInOrder(keys) || tryInserting(keys)) return m_order;
    setTieOrder(keys);
    dxRadixSort(m_items, m_spare);
    for (std::size_t place = 0; place < m_items.size(); ++place) m_order[place] = m_tieOrder[static_cast<std::uint32_t>(m_items[place])];
    return m_order;
}

// As in upstream, a comparison with NaN counts as in order.
bool dxSapSort::isInOrder(const std::vector<float> &keys) const {
    for (std::size_t place = 1; place < m_order.size(); ++place)
        if (keys[m_order[place]] < keys[m_order[place - 1]]) return false;
    return true;
}

// If an insertion sort took too long, it mostly would in the next call, too.
bool dxSapSort::tryInserting(const std::vector<float> &keys) {
    if (m_untried != 0) {
        --m_untried;
        return false;
    }
    const bool isDone = insertFew(keys);
    m_untried = m_pause = isDone ? 0 : std::min(2 * m_pause + 1, kMaxPause);
    return isDone;
}

// Insertion sort, for keys of which few have changed or all have changed little. Returns false, and changes nothing, if it would take long. It
// reverses equal negative keys, as setTieOrder() does.
bool dxSapSort::insertFew(const std::vector<float> &keys) {
    m_tieOrder = m_order;
    m_sorted.resize(keys.size());
    for (std::size_t place = 0; place < keys.size(); ++place) m_sorted[place] = sortable(bitsOf(keys[m_order[place]]));
    std::size_t shifts = kMaxShiftsPerKey * keys.size();
    for (std::size_t place = 1; place < keys.size(); ++place) {
        const std::uint32_t key = m_sorted[place], index = m_tieOrder[place];
        std::size_t at = place;
        for (; at > 0 && key < m_sorted[at - 1]; --at) {
            if (shifts-- == 0) return false;
            m_sorted[at] = m_sorted[at - 1];
            m_tieOrder[at] = m_tieOrder[at - 1];
        }
        m_sorted[at] = key;
        m_tieOrder[at] = index;
    }
    const std::uint32_t firstPositive = kSign;
    for (std::size_t begin = 0, end; begin < keys.size() && m_sorted[begin] < firstPositive; begin = end) {
        for (end = begin + 1; end < keys.size() && m_sorted[end] == m_sorted[begin];) ++end;
        std::reverse(m_tieOrder.begin() + static_cast<std::ptrdiff_t>(begin), m_tieOrder.begin() + static_cast<std::ptrdiff_t>(end));
    }
    m_order.swap(m_tieOrder);
    return true;
}

// Sets the order that a stable sort must leave among equal keys: negative keys from the back, the others from the front.
void dxSapSort::setTieOrder(const std::vector<float> &keys) {
    const std::size_t count = m_order.size();
    m_sorted.resize(count);
    m_tieOrder.resize(count);
    m_items.resize(count);
    std::size_t negative = 0;
    for (std::size_t place = 0; place < count; ++place) {
        m_sorted[place] = bitsOf(keys[m_order[place]]);
        negative += m_sorted[place] >> 31;
    }
    std::size_t left = negative, positive = negative;
    for (std::size_t place = 0; place < count; ++place) {
        const std::uint32_t bits = m_sorted[place], isNegative = bits >> 31;
        left -= isNegative;
        const std::size_t tie = isNegative != 0 ? left : positive;
        positive += 1 - isNegative;
        m_tieOrder[tie] = m_order[place];
        m_items[tie] = std::uint64_t{sortable(bits)} << 32 | tie;
    }
}
