// The states of a world's bodies behind a step, as one hash and, where they are asked for, as they are.
#pragma once

#include <cstring>
#include <vector>

#include "ode_library.h"
#include "record_format.h"

namespace observer {

// By whole numbers: reading states raises no flag of the floating-point unit.
inline std::uint64_t bitsOf(double real) {
    constexpr std::uint64_t kSign = 1ull << 63, kInfinity = 0x7ff0000000000000, kNaN = 0x7ff8000000000000;
    std::uint64_t bits;
    std::memcpy(&bits, &real, sizeof bits);
    return (bits & ~kSign) > kInfinity ? kNaN : bits;
}

class BodyStates {
public:
    BodyStates(const OdeLibrary &library, const check::WorldState &world);

    void keep();  // to be called before add()
    void add(dxBody *body, std::uint64_t number);

    std::uint64_t hash() const;
    // A WorldState and its BodyStates.
    const std::vector<unsigned char> &kept() const { return m_kept; }

private:
    void mix(std::uint64_t word);
    template <class State>
    void keepBytes(const State &state);

    const OdeLibrary &m_library;
    const check::WorldState m_world;
    bool m_isKept = false;
    std::uint64_t m_hash = 0;
    std::vector<unsigned char> m_kept;
};

}  // namespace observer
