#include "clusters/dxInhabitantLinks.h"

#include <algorithm>
#include <functional>

#include "config.h"
#include "objects.h"
#include "collision_kernel.h"
#include "joints/joint.h"

namespace {

using Kind = dxClusterScene::Kind;

const dxGeom *firstInside(const dxGeom *geom) {
    return IS_SPACE(geom) ? static_cast<const dxSpace *>(geom)->first : nullptr;
}

// Visits the bodies of a geom or of the geoms of a space, however deep, without recursion, until visit returns
// true; returns whether it did.
template <class Visit>
bool forBodies(const dxGeom *top, Visit &&visit) {
    const dxGeom *geom = top;
    while (true) {
        if (geom->body != nullptr && visit(geom->body)) return true;
        if (const dxGeom *const inner = firstInside(geom)) {
            geom = inner;
            continue;
        }
        while (geom != top && geom->next == nullptr) geom = geom->parent_space;
        if (geom == top) return false;
        geom = geom->next;
    }
}

}  // namespace

Kind dxKindOf(const dxGeom *geom) {
    return forBodies(geom, [](const dxBody *) { return true; }) ? Kind::dynamicGeom : Kind::staticGeom;
}

bool dxInhabitantLinks::gather(const dxMembers &members, const dxClusterScene &scene) {
    m_bodies.clear();
    for (const Slot slot : scene.all(Kind::dynamicGeom))
        forBodies(members[slot].geom, [&](const dxBody *body) {
            m_bodies.emplace_back(body, slot);
            return false;
        });
    std::sort(m_bodies.begin(), m_bodies.end());
    m_links.swap(m_before);
    m_links.clear();
    linkGeomsOfBodies();
    linkJointedBodies();
    std::sort(m_links.begin(), m_links.end());
    return m_links != m_before;
}

void dxInhabitantLinks::linkGeomsOfBodies() {
    for (std::size_t i = 1; i < m_bodies.size(); ++i)
        if (m_bodies[i - 1].first == m_bodies[i].first)
            m_links.emplace_back(m_bodies[i - 1].second, m_bodies[i].second);
}

void dxInhabitantLinks::linkJointedBodies() {
    const std::less<const dxBody *> isBefore;
    const auto find = [&](const dxBody *body) {
        return std::lower_bound(m_bodies.begin(), m_bodies.end(), body,
                                [&](const BodySlot &entry, const dxBody *b) { return isBefore(entry.first, b); });
    };
    for (std::size_t i = 0; i < m_bodies.size(); ++i) {
        const dxBody *const body = m_bodies[i].first;
        if (i > 0 && m_bodies[i - 1].first == body) continue;
        for (const dxJointNode *node = body->firstjoint; node != nullptr; node = node->next) {
            if (node->body == nullptr || !isBefore(body, node->body)) continue;
            const auto other = find(node->body);
            if (other != m_bodies.end() && other->first == node->body)
                m_links.emplace_back(m_bodies[i].second, other->second);
        }
    }
}
