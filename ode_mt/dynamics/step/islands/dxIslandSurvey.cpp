#include "dynamics/step/islands/dxIslandSurvey.h"

#include <algorithm>
#include <cstring>

#include "contact.h"
#include "core/dxPrefetch.h"
#include "threading/dxUpstreamScope.h"

namespace {

// The step itself will report what joints have to say.
class SilentScope final : public dxUpstreamScope {
public:
    std::uint32_t takeBlock(std::uint64_t) override { return 0; }
    bool defersMoved() const override { return true; }
    bool takeOver(dxReport kind, int, const char *, va_list) override {
        if (kind != dxReport::Message) throw dxUpstreamInterrupted();
        return true;
    }
};

unsigned one(bool row) { return row ? 1 : 0; }

// dxJointContact::getInfo1 without its side effect: that one sets negative coefficients to zero, and counts
// a rolling coefficient of zero differently from a negative one.
unsigned contactRows(const dSurfaceParameters &surface) {
    const bool rolling = (surface.mode & dContactRolling) != 0;
    if ((surface.mode & dContactAxisDep) == 0) {
        return 1 + 2 * one(surface.mu > 0) + 3 * one(rolling && !(surface.rho < 0));
    }
    unsigned rows = 1 + one(surface.mu > 0) + one(surface.mu2 > 0);
    if (rolling) rows += one(!(surface.rho < 0)) + one(!(surface.rho2 < 0)) + one(!(surface.rhoN < 0));
    return rows;
}

// Other joints must be queried. Their getInfo1 keeps what it finds (angles, limit states), which the user can see: it
// is put back.
class JointCopy {
public:
    explicit JointCopy(dxJoint &joint) : m_joint(joint), m_size(joint.size()) {
        if (m_size > sizeof m_bytes) m_large.resize(m_size);
        std::memcpy(bytes(), static_cast<void *>(&joint), m_size);
    }
    ~JointCopy() { std::memcpy(static_cast<void *>(&m_joint), bytes(), m_size); }
    JointCopy(const JointCopy &) = delete;
    JointCopy &operator=(const JointCopy &) = delete;

private:
    void *bytes() { return m_large.empty() ? static_cast<void *>(m_bytes) : m_large.data(); }

    dxJoint &m_joint;
    std::size_t m_size;
    std::byte m_bytes[2048];
    std::vector<std::byte> m_large;
};

unsigned rowsOf(dxJoint &joint) {
    if (joint.type() == dJointTypeContact) return contactRows(static_cast<dxJointContact &>(joint).contact.surface);
    const JointCopy copy(joint);
    dxJoint::Info1 info;
    joint.getInfo1(&info);
    return info.m;
}

}  // namespace

bool dxHasMovedCallback(const dxIsland &island) {
    constexpr unsigned kPrefetchDistance = 16;
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        if (i + kPrefetchDistance < island.bodyCount) dxPrefetch::line(&island.bodies[i + kPrefetchDistance]->moved_callback);
        if (island.bodies[i]->moved_callback != nullptr) return true;
    }
    return false;
}

std::optional<unsigned> dxCountRows(const dxIsland &island) {
    const SilentScope scope;
    unsigned rows = 0;
    try {
        for (unsigned i = 0; i < island.jointCount; ++i) rows += rowsOf(*island.joints[i]);
    } catch (const dxUpstreamInterrupted &) {
        return std::nullopt;
    }
    return rows;
}

void dxCollectFeedback(const dxIsland &island, unsigned unit, std::vector<dxFeedbackUse> &uses) {
    for (unsigned i = 0; i < island.jointCount; ++i) {
        if (const dJointFeedback *feedback = island.joints[i]->feedback) uses.push_back({reinterpret_cast<std::uintptr_t>(feedback), unit});
    }
}
