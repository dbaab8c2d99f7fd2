// Fowler, Noll and Vo, 64 bits, taken a byte at a time (draft-eastlake-fnv).
#pragma once

#include <cstddef>
#include <cstdint>

namespace scenes {

class Fnv1a {
public:
    void add(const void *data, std::size_t count) {
        const auto *const bytes = static_cast<const unsigned char *>(data);
        for (std::size_t i = 0; i < count; ++i) m_hash = (m_hash ^ bytes[i]) * 0x100000001b3;
    }

    std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325;
};

}  // namespace scenes
