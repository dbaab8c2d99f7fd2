#include "dynamics/step/islands/dxUndoLog.h"

#include <cstring>

#include "joints/contact.h"

namespace {

struct Header {
    void *address;
    std::size_t size;
};

// dxJointContact::getInfo1 makes negative coefficients zero; all else that a step writes to a contact it finds again.
bool hasNegativeCoefficient(const dSurfaceParameters &surface) {
    const bool perAxis = (surface.mode & dContactAxisDep) != 0, rolling = (surface.mode & dContactRolling) != 0;
    return surface.mu < 0 || (perAxis && surface.mu2 < 0) || (rolling && surface.rho < 0) ||
           (rolling && perAxis && (surface.rho2 < 0 || surface.rhoN < 0));
}

}  // namespace

// Not by resizing first, which would write zeros.
void dxUndoLog::saveBytes(void *address, std::size_t size) {
    const Header header{address, size};
    const auto append = [this](const void *from, std::size_t count) {
        const auto *const begin = static_cast<const std::byte *>(from);
        m_bytes.insert(m_bytes.end(), begin, begin + count);
    };
    append(&header, sizeof header);
    append(address, size);
}

void dxUndoLog::save(const dxIsland &island) {
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        dxBody &body = *island.bodies[i];
        // Position, orientation, velocities and accumulators stand next to one another.
        saveBytes(&body.posr, static_cast<std::size_t>(reinterpret_cast<std::byte *>(&body.finite_rot_axis) -
                                                       reinterpret_cast<std::byte *>(&body.posr)));
    }
    for (unsigned i = 0; i < island.jointCount; ++i) {
        dxJoint &joint = *island.joints[i];
        if (joint.feedback) saveBytes(joint.feedback, sizeof *joint.feedback);
        saveJoint(joint);
    }
}

void dxUndoLog::saveJoint(dxJoint &joint) {
    if (joint.type() != dJointTypeContact) {
        saveBytes(&joint, joint.size());
        return;
    }
    dSurfaceParameters &surface = static_cast<dxJointContact &>(joint).contact.surface;
    if (hasNegativeCoefficient(surface)) saveBytes(&surface, sizeof surface);
}

void dxUndoLog::restore(Mark begin, Mark end) const {
    for (std::size_t at = begin; at < end;) {
        Header header;
        std::memcpy(&header, m_bytes.data() + at, sizeof header);
        std::memcpy(header.address, m_bytes.data() + at + sizeof header, header.size);
        at += sizeof header + header.size;
    }
}
