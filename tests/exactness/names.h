// Gives ODE's handles numbers that mean the same in two processes: places in the scene's inventory.
#pragma once

#include "scenes/scene.h"

#include <unordered_map>
#include <vector>

namespace exactness {

class Names {
public:
    // Null has a number of its own, and so have all objects that the scene does not list.
    static constexpr long null = -1;
    static constexpr long unlisted = -2;

    explicit Names(const scenes::Inventory &inventory) : m_inventory(inventory) {}

    long of(dGeomID geom) const;  // spaces come after the geoms
    long of(dBodyID body) const;
    long of(dJointID joint) const;

private:
    // Objects are created and destroyed, and addresses are reused, so a number found is checked against the inventory before it is
    // believed, and one that is not found is unlisted only if the inventory is the one that was counted. Most are: contact joints.
    template <class Handle>
    class Table {
    public:
        long find(const std::vector<Handle> &listed, Handle handle) const;

    private:
        mutable std::unordered_map<Handle, std::size_t> m_places;
        mutable std::vector<Handle> m_counted;
    };

    const scenes::Inventory &m_inventory;
    Table<dGeomID> m_geoms;
    Table<dSpaceID> m_spaces;
    Table<dBodyID> m_bodies;
    Table<dJointID> m_joints;
};

}  // namespace exactness
