// Memory of messages that have been sent or read, for later ones. Memory that is freed and allocated in every step comes from the system page by
// page, which costs more than everything else that is done with a message.
//
// It is bounded.
//
// Threading: as its owner says.
#pragma once

#include <cstddef>
#include <new>
#include <utility>
#include <vector>

#include "remote/transport/dxRemoteFrame.h"

class dxSpareBytes {
public:
    // Returns empty bytes, with room if any is spare.
    dxRemoteBytes take() {
        if (m_spare.empty()) return {};
        dxRemoteBytes bytes = std::move(m_spare.back());
        m_spare.pop_back();
        m_capacity -= bytes.capacity();
        return bytes;
    }

    void giveBack(dxRemoteBytes &&bytes) noexcept {
        if (m_capacity + bytes.capacity() > kMaxCapacity) return dxRemoteBytes().swap(bytes);
        bytes.clear();
        try {
            const std::size_t capacity = bytes.capacity();
            m_spare.push_back(std::move(bytes));
            m_capacity += capacity;
        } catch (const std::bad_alloc &) {  // then it is freed
        }
    }

    std::size_t capacity() const { return m_capacity; }

    static constexpr std::size_t kMaxCapacity = std::size_t{8} << 20;

private:
    std::vector<dxRemoteBytes> m_spare;
    std::size_t m_capacity = 0;
};
