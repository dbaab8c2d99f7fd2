#include "remote/islands/dxPackedProblem.h"

#include <ode/error.h>

#include <cfenv>
#include <cstring>
#include <utility>

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/exact/dxDantzigSolver.h"
#include "threading/dxFloatEnvironment.h"

namespace {

constexpr unsigned kSides = dxWorldStepProblem::kSides, kPair = 2;
static_assert(dxWorldStepProblem::kElements == kRowElements && sizeof(dxInverseInertia) == dxPackedProblem::kInertiaElements * sizeof(dReal),
              "arrays are packed as they lie");

// Returns whether joints have consecutive rows, and bodies that exist.
bool areJointsSound(const dxPackedProblem &problem) {
    unsigned row = 0;
    for (unsigned i = 0; i < problem.counts.joints; ++i) {
        dxConstraintJoint joint;
        std::memcpy(&joint, problem.joints + i * sizeof joint, sizeof joint);
        const bool hasSecond = joint.bodies[1] != dxConstraintJoint::kNoBody;
        if (joint.firstRow != row || joint.rows < 1 || joint.rows > kMaxJointRows || joint.bodies[0] >= problem.counts.bodies) return false;
        if (hasSecond && joint.bodies[1] >= problem.counts.bodies) return false;
        row += joint.rows;
    }
    return row == problem.counts.rows;
}

// Returns whether a friction row comes after the row of its normal.
bool areNormalsSound(const dxPackedProblem &problem) {
    for (unsigned i = 0; i < problem.counts.rows; ++i) {
        int normal = 0;
        std::memcpy(&normal, problem.normalOf + i * sizeof normal, sizeof normal);
        if (normal < -1 || normal >= static_cast<int>(i)) return false;
    }
    return true;
}

}  // namespace

dxPackedLayout::dxPackedLayout(const dxPackedCounts &counts) : total(sizeof counts) {
    const auto add = [this](std::size_t count, std::size_t size) { return std::exchange(total, total + dxPackedRoom(count * size)); };
    const std::size_t rows = counts.rows, bodies = counts.bodies;
    joints = add(counts.joints, sizeof(dxConstraintJoint));
    jacobian = add(rows * kSides * kRowElements, sizeof(dReal));
    inverseInertia = add(bodies * dxPackedProblem::kInertiaElements, sizeof(dReal));
    motions = add(bodies * kRowElements, sizeof(dReal));
    pairsBX = add(rows * kPair, sizeof(dReal));
    pairsLoHi = add(rows * kPair, sizeof(dReal));
    normalOf = add(rows, sizeof(int));
}

bool dxPackedProblem::read(const std::byte *bytes, std::size_t size) {
    constexpr std::uint32_t kMaxRows = 1u << 20;
    if (size < sizeof counts) return false;
    std::memcpy(&counts, bytes, sizeof counts);
    if (counts.rows == 0 || counts.rows > kMaxRows || counts.bilateralJoints > counts.joints) return false;
    const dxPackedLayout layout(counts);
    if (layout.total != size) return false;
    joints = bytes + layout.joints;
    jacobian = bytes + layout.jacobian;
    inverseInertia = bytes + layout.inverseInertia;
    motions = bytes + layout.motions;
    pairsBX = bytes + layout.pairsBX;
    pairsLoHi = bytes + layout.pairsLoHi;
    normalOf = bytes + layout.normalOf;
    return areJointsSound(*this) && areNormalsSound(*this);
}

void dxPackProblem(const dxWorldStepProblem &problem, dReal stepSize, std::vector<std::byte> &bytes) {
    const dxPackedCounts counts{dxFloatMode(),  problem.bodyCount, problem.jointCount, problem.rowCount, problem.bilateralJoints, 0};
    const dxPackedLayout layout(counts);
    bytes.assign(layout.total, std::byte{0});
    const auto put = [&bytes](std::size_t at, const void *array, std::size_t size) { std::memcpy(bytes.data() + at, array, size); };
    put(0, &counts, sizeof counts);
    // Where they lie in the bytes they are aligned for their own type: all sizes before them are multiples of eight.
    dxListConstraintJoints(problem, reinterpret_cast<dxConstraintJoint *>(bytes.data() + layout.joints));
    dxFindMotions(problem, stepSize, reinterpret_cast<dReal *>(bytes.data() + layout.motions));  // completes the tensors
    const std::size_t rows = counts.rows, bodies = counts.bodies;
    put(layout.jacobian, problem.jacobian, rows * kSides * kRowElements * sizeof(dReal));
    put(layout.inverseInertia, problem.inverseInertia, bodies * sizeof(dxInverseInertia));
    put(layout.pairsBX, problem.pairsBX, rows * kPair * sizeof(dReal));
    put(layout.pairsLoHi, problem.pairsLoHi, rows * kPair * sizeof(dReal));
    put(layout.normalOf, problem.normalOf, rows * sizeof(int));
}

dxPackedAnswer dxReadPackedResult(const std::vector<std::byte> &bytes, const dxWorldStepProblem &problem) {
    dxPackedResult::Head head;
    if (bytes.empty()) return dxPackedAnswer::GivenBack;
    if (bytes.size() < sizeof head) return dxPackedAnswer::Wrong;
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.outcome == dxPackedResult::Outcome::GivenBack) return dxPackedAnswer::GivenBack;
    const std::size_t size = std::size_t(problem.rowCount) * sizeof(dReal);
    if (head.outcome != dxPackedResult::Outcome::Solved || head.rows != problem.rowCount || bytes.size() < sizeof head + dxPackedRoom(size) ||
        (head.exceptions & ~unsigned{FE_ALL_EXCEPT}) != 0)
        return dxPackedAnswer::Wrong;
    const std::byte *from = bytes.data() + sizeof head;
    for (unsigned i = 0; i < problem.rowCount; ++i, from += sizeof(dReal))
        std::memcpy(problem.pairsBX + std::size_t(i) * kPair + dxJoint::GI2_CFM, from, sizeof(dReal));
    if (head.exceptions != 0) {
        const auto flags = static_cast<std::fexcept_t>(head.exceptions);
        std::fesetexceptflag(&flags, static_cast<int>(head.exceptions));  // does not trap
    }
    return dxPackedAnswer::Solved;
}

void dxReportPackedMessages(const std::vector<std::byte> &bytes) {
    dxPackedResult::Head head;
    std::memcpy(&head, bytes.data(), sizeof head);
    std::size_t at = sizeof head + dxPackedRoom(head.rows * sizeof(dReal));
    for (unsigned i = 0; i < head.messages; ++i) {
        dxPackedResult::Message message;
        if (bytes.size() - at < sizeof message) return;
        std::memcpy(&message, bytes.data() + at, sizeof message);
        at += sizeof message;
        if (bytes.size() - at < message.length) return;
        const auto *const text = reinterpret_cast<const char *>(bytes.data() + at);
        at += message.length;
        dMessage(message.number, "%.*s", static_cast<int>(message.length), text);
    }
}
