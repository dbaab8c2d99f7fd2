#include "dynamics/dxUndoLog.h"

#include <cstring>

namespace {

struct Header {
    void *address;
    std::size_t size;
};

}  // namespace

void dxUndoLog::saveBytes(void *address, std::size_t size) {
    const Header header{address, size};
    const std::size_t at = m_bytes.size();
    m_bytes.resize(at + sizeof header + size);
    std::memcpy(m_bytes.data() + at, &header, sizeof header);
    std::memcpy(m_bytes.data() + at + sizeof header, address, size);
}

void dxUndoLog::save(const dxIsland &island) {
    for (unsigned i = 0; i < island.bodyCount; ++i) {
        dxBody &body = *island.bodies[i];
        saveBytes(&body.posr, sizeof body.posr);
        saveBytes(&body.q, sizeof body.q);
        saveBytes(&body.lvel, sizeof body.lvel);
        saveBytes(&body.avel, sizeof body.avel);
        saveBytes(&body.facc, sizeof body.facc);
        saveBytes(&body.tacc, sizeof body.tacc);
    }
    for (unsigned i = 0; i < island.jointCount; ++i) {
        dxJoint &joint = *island.joints[i];
        if (joint.feedback) saveBytes(joint.feedback, sizeof *joint.feedback);
        saveBytes(&joint, joint.size());
    }
}

void dxUndoLog::restore(Mark begin, Mark end) const {
    for (std::size_t at = begin; at < end;) {
        Header header;
        std::memcpy(&header, m_bytes.data() + at, sizeof header);
        std::memcpy(header.address, m_bytes.data() + at + sizeof header, header.size);
        at += sizeof header + header.size;
    }
}
