#include "dynamics/iterative/dxOtherJoints.h"

#include "joints/contact.h"

namespace {

constexpr unsigned kCacheLine = 64;

}  // namespace

bool dxOtherJoints::isOther(const dxJoint &joint) {
    return joint.type() != dJointTypeContact ||
           (static_cast<const dxJointContact &>(joint).contact.surface.mode & dContactRolling) != 0;
}

dxOtherJoints::dxOtherJoints(const dxIslandStep &step) : m_step(step) {
    const dxIsland &group = step.island;
    unsigned count = 0;
    for (unsigned i = 0; i < group.jointCount; ++i) count += isOther(*group.joints[i]);
    m_step.island.jointCount = count;
    if (count == 0) return;
    dxJoint **const joints = step.arena->AllocateArray<dxJoint *>(count);
    unsigned end = 0;
    for (unsigned i = 0; i < group.jointCount; ++i)
        if (isOther(*group.joints[i])) joints[end++] = group.joints[i];
    m_step.island.joints = joints;
    m_reader.emplace(m_step);
    if (rowCount() == 0) return;
    m_rows = step.arena->AllocateOveralignedArray<dxConstraintRow>(rowCount(), kCacheLine);
    m_reader->read(m_rows);
}
