#include "dynamics/quick_step/fast/dxOtherJoints.h"

#include <algorithm>

namespace {

constexpr unsigned kCacheLine = 64;

}  // namespace

dxOtherJoints::dxOtherJoints(const dxIslandStep &step, const dxConstraintPlan &plan) : m_step(step) {
    const std::vector<dxConstraintPlan::OtherJoint> &others = plan.otherJoints();
    m_step.island.jointCount = static_cast<unsigned>(others.size());
    if (others.empty()) return;
    dxJoint **const joints = step.arena->AllocateArray<dxJoint *>(others.size());
    std::transform(others.begin(), others.end(), joints,
                   [&step](const dxConstraintPlan::OtherJoint &other) { return step.island.joints[other.joint]; });
    m_step.island.joints = joints;
    m_reader.emplace(m_step);
    if (rowCount() == 0) return;
    m_rows = step.arena->AllocateOveralignedArray<dxConstraintRow>(rowCount(), kCacheLine);
    m_reader->read(m_rows);
}
