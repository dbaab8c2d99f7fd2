#include "scenes/state_hash.h"

#include <cmath>
#include <cstring>
#include <limits>

namespace scenes {

namespace {

// Fowler, Noll and Vo, 64 bits, taken a byte at a time (draft-eastlake-fnv).
class Fnv1a {
public:
    void add(const dReal *values, int count) {
        for (int i = 0; i < count; ++i) add(values[i]);
    }

    void add(dReal value) {
        if (std::isnan(value)) value = std::numeric_limits<dReal>::quiet_NaN();
        unsigned char bytes[sizeof value];
        std::memcpy(bytes, &value, sizeof value);
        for (unsigned char byte : bytes) m_hash = (m_hash ^ byte) * 0x100000001b3;
    }

    std::uint64_t value() const { return m_hash; }

private:
    std::uint64_t m_hash = 0xcbf29ce484222325;
};

}  // namespace

std::uint64_t stateHash(const Inventory &inventory) {
    Fnv1a hash;
    for (dBodyID body : inventory.bodies) {
        hash.add(dBodyGetPosition(body), 3);
        hash.add(dBodyGetQuaternion(body), 4);
        hash.add(dBodyGetLinearVel(body), 3);
        hash.add(dBodyGetAngularVel(body), 3);
        hash.add(dBodyIsEnabled(body) ? 1 : 0);
    }
    for (dReal reading : inventory.readings) hash.add(reading);
    return hash.value();
}

}  // namespace scenes
