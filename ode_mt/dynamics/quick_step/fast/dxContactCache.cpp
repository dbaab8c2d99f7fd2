#include "dynamics/quick_step/fast/dxContactCache.h"

#include <algorithm>
#include <utility>

#include "core/dxPrefetch.h"

namespace {

// Upstream uses flags up to 256; the bits above hold a number.
constexpr unsigned kNumberShift = 10, kUpstreamsFlags = (1u << kNumberShift) - 1, kMaxNumber = ~0u >> kNumberShift;

constexpr dReal kWarmStart = dReal(0.75), kMaxFullErp = dReal(0.2);

}  // namespace

dReal dxWarmStartFactor(dReal erp) {
    return erp <= kMaxFullErp ? kWarmStart : kWarmStart * std::max(dReal(0), (1 - erp) / (1 - kMaxFullErp));  // NaN: none
}

void dxContactCache::begin(const dxWorldProcessIslandsInfo &info, bool isWarm) {
    unsigned bodyCount = 0, jointCount = 0;
    const unsigned *const sizes = info.GetIslandSizes();
    for (std::size_t i = 0; i < info.GetIslandsCount(); ++i) {
        bodyCount += sizes[2 * i];
        jointCount += sizes[2 * i + 1];
    }
    m_bodies = info.GetBodiesArray();
    m_joints = info.GetJointsArray();
    std::swap(m_last, m_now);
    if (!isWarm) m_last.bodies.clear();
    m_now.bodies.clear();
    m_now.bodies.resize(bodyCount);
    if (m_now.contacts.size() < jointCount) m_now.contacts.resize(jointCount);
    if (m_now.manifolds.size() < jointCount) m_now.manifolds.resize(jointCount);
    m_lastNumber.resize(bodyCount);
    numberBodies(bodyCount);
}

// A body that was not stepped last time has an older number, under which the last step knows another body.
void dxContactCache::numberBodies(unsigned bodyCount) {
    constexpr unsigned kPrefetchDistance = 16;
    for (unsigned i = 0; i < bodyCount; ++i) {
        if (i + kPrefetchDistance < bodyCount) dxPrefetch::lineForWrite(&m_bodies[i + kPrefetchDistance]->flags);
        dxBody &body = *m_bodies[i];
        const unsigned number = body.flags >> kNumberShift;  // plus one; 0: none
        const bool isKnown = number != 0 && number <= m_last.bodies.size() && m_last.bodies[number - 1].body == &body;
        m_lastNumber[i] = isKnown ? number - 1 : kNone;
        body.flags = (body.flags & kUpstreamsFlags) | (i < kMaxNumber ? (i + 1) << kNumberShift : 0);
        m_now.bodies[i] = {&body, kNone, 0};
    }
}

void dxContactCache::clear(const dxIsland &group) {
    const unsigned first = firstBody(group);
    for (unsigned i = first; i < first + group.bodyCount; ++i) m_now.bodies[i] = {m_bodies[i], kNone, 0};
}

bool dxContactCache::keep(unsigned first, unsigned second, unsigned firstContact, unsigned contactCount) {
    const bool firstOwns = second == kNone || m_now.bodies[first].manifoldCount <= m_now.bodies[second].manifoldCount;
    Body &owner = m_now.bodies[firstOwns ? first : second];
    m_now.manifolds[firstContact] = {firstOwns ? second : first, firstContact, contactCount, owner.firstManifold};
    owner.firstManifold = firstContact;
    ++owner.manifoldCount;
    return firstOwns;
}
