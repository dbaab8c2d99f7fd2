#include "core/dxSapSort.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <numeric>

namespace {

constexpr std::uint32_t kSign = UINT32_C(1) << 31;

std::uint32_t bitsOf(float key) {
    std::uint32_t bits;
    std::memcpy(&bits, &key, sizeof bits);
    return bits;
}

bool isNegative(float key) { return (bitsOf(key) & kSign) != 0; }

// Sorts as the numbers do, and NaN beyond all others of its sign.
std::uint32_t sortable(float key) {
    const std::uint32_t bits = bitsOf(key);
    return (bits & kSign) != 0 ? ~bits : bits | kSign;
}

}  // namespace

const std::vector<std::uint32_t> &dxSapSort::sort(const std::vector<float> &keys) {
    if (m_order.size() != keys.size()) {
        m_order.resize(keys.size());
        std::iota(m_order.begin(), m_order.end(), 0);
    }
    if (isInOrder(keys)) return m_order;
    takeTieOrder(keys);
    m_items.resize(m_tieOrder.size());
    for (std::uint32_t tie = 0; tie < m_tieOrder.size(); ++tie) m_items[tie] = {sortable(keys[m_tieOrder[tie]]), tie};
    dxRadixSort(m_items, m_spare);
    for (std::size_t place = 0; place < m_items.size(); ++place) m_order[place] = m_tieOrder[m_items[place].index];
    return m_order;
}

// A comparison with NaN counts as in order, as upstream's does.
bool dxSapSort::isInOrder(const std::vector<float> &keys) const {
    for (std::size_t place = 1; place < m_order.size(); ++place)
        if (keys[m_order[place]] < keys[m_order[place - 1]]) return false;
    return true;
}

// Negative numbers from the back, the others from the front.
void dxSapSort::takeTieOrder(const std::vector<float> &keys) {
    m_tieOrder.clear();
    for (auto index = m_order.rbegin(); index != m_order.rend(); ++index)
        if (isNegative(keys[*index])) m_tieOrder.push_back(*index);
    for (const std::uint32_t index : m_order)
        if (!isNegative(keys[index])) m_tieOrder.push_back(index);
}
