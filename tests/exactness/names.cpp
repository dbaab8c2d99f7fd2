#include "names.h"

namespace exactness {

template <class Handle>
long Names::Table<Handle>::find(const std::vector<Handle> &listed, Handle handle) const {
    const auto holds = [&](std::size_t place) { return place < listed.size() && listed[place] == handle; };
    auto found = m_places.find(handle);
    if ((found == m_places.end() || !holds(found->second)) && listed != m_counted) {
        m_places.clear();
        for (std::size_t i = 0; i < listed.size(); ++i) m_places[listed[i]] = i;
        m_counted = listed;
        found = m_places.find(handle);
    }
    return found == m_places.end() ? unlisted : static_cast<long>(found->second);
}

long Names::of(dGeomID geom) const {
    if (geom == nullptr) return null;
    if (!dGeomIsSpace(geom)) return m_geoms.find(m_inventory.geoms, geom);
    const long place = m_spaces.find(m_inventory.spaces, reinterpret_cast<dSpaceID>(geom));
    return place < 0 ? place : place + static_cast<long>(m_inventory.geoms.size());
}

long Names::of(dBodyID body) const {
    return body == nullptr ? null : m_bodies.find(m_inventory.bodies, body);
}

long Names::of(dJointID joint) const {
    return joint == nullptr ? null : m_joints.find(m_inventory.joints, joint);
}

}  // namespace exactness
