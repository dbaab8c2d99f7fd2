#include "scenes/state_hash.h"

#include "scenes/fnv1a.h"

#include <cmath>
#include <limits>

namespace scenes {

namespace {

class StateHash {
public:
    void add(const dReal *values, int count) {
        for (int i = 0; i < count; ++i) add(values[i]);
    }

    void add(dReal value) {
        if (std::isnan(value)) value = std::numeric_limits<dReal>::quiet_NaN();
        m_hash.add(&value, sizeof value);
    }

    std::uint64_t value() const { return m_hash.value(); }

private:
    Fnv1a m_hash;
};

}  // namespace

std::uint64_t stateHash(const Inventory &inventory) {
    StateHash hash;
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
