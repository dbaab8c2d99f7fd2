#include "body_states.h"

namespace observer {

BodyStates::BodyStates(const OdeLibrary &library, const check::WorldState &world) : m_library(library), m_world(world) {
    mix(m_world.bodies);
    for (const std::uint64_t word : m_world.words) mix(word);
}

// Each word changes the hash one to one (Fibonacci hashing's multiplier is odd): two states that differ in one word never share a
// hash.
void BodyStates::mix(std::uint64_t word) {
    m_hash = (m_hash ^ word) * 0x9e3779b97f4a7c15;
    m_hash ^= m_hash >> 32;
}

std::uint64_t BodyStates::hash() const { return m_hash; }

template <class State>
void BodyStates::keepBytes(const State &state) {
    const auto *const bytes = reinterpret_cast<const unsigned char *>(&state);
    m_kept.insert(m_kept.end(), bytes, bytes + sizeof state);
}

void BodyStates::keep() {
    m_isKept = true;
    keepBytes(m_world);
}

void BodyStates::add(dxBody *body, std::uint64_t number) {
    check::BodyState state{};
    state.number = number;
    std::uint64_t *next = state.words;
    const auto reals = [&](const double *values, int count) {
        for (int i = 0; i < count; ++i) *next++ = bitsOf(values[i]);
    };
    reals(m_library.bodyGetPosition(body), 3);
    reals(m_library.bodyGetQuaternion(body), 4);
    reals(m_library.bodyGetLinearVel(body), 3);
    reals(m_library.bodyGetAngularVel(body), 3);
    reals(m_library.bodyGetForce(body), 3);
    reals(m_library.bodyGetTorque(body), 3);
    *next = static_cast<std::uint64_t>(m_library.bodyIsEnabled(body));

    mix(number);
    for (const std::uint64_t word : state.words) mix(word);
    if (m_isKept) keepBytes(state);
}

}  // namespace observer
