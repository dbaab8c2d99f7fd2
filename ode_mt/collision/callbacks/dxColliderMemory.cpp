#include "collision/callbacks/dxColliderMemory.h"

#include <algorithm>
#include <functional>

#include "collision/narrowphase/dxHeightField.h"

void dxColliderMemory::reset(Slot end) {
    m_members.assign(end, 0);
    m_uses.clear();
}

void dxColliderMemory::look(const dxGeom *member, Slot slot) {
    if ((m_members[slot] & kSeen) != 0) return;
    m_members[slot] |= kSeen;
    add(member, slot);
}

// Disabled geoms in nested spaces are never collided, and what is in their transforms may be gone.
void dxColliderMemory::add(const dxGeom *geom, Slot slot) {
    if (dxIsHeightField(*geom)) {
        m_members[slot] |= kHasHeights;
        m_uses.push_back({dxHeightsOf(*geom), slot});
    } else if (geom->type == dGeomTransformClass) {
        const dxGeom *const inner = dGeomTransformGetGeom(const_cast<dxGeom *>(geom));
        if (inner == nullptr) return;
        m_uses.push_back({inner, slot});
        add(inner, slot);
    } else if (IS_SPACE(geom)) {
        for (const dxGeom *inner = static_cast<const dxSpace *>(geom)->first; inner != nullptr; inner = inner->next)
            if ((inner->gflags & GEOM_ENABLED) != 0) add(inner, slot);
    }
}

void dxColliderMemory::sort() {
    std::sort(m_uses.begin(), m_uses.end(), [](const Use &a, const Use &b) {
        return a.memory != b.memory ? std::less<const void *>()(a.memory, b.memory) : a.slot < b.slot;
    });
}
