#include "dynamics/remote/dxPackedProblem.h"

#include <ode/error.h>

#include <cfenv>
#include <cstring>
#include <string>

#include "dynamics/exactstep/dxExactMatrix.h"
#include "dynamics/exactstep/dxExactProblem.h"
#include "threading/dxFloatEnvironment.h"

namespace {

constexpr std::size_t kAlignment = 8;
constexpr unsigned kSides = dxExactProblem::kSides, kPair = 2;
static_assert(dxExactProblem::kElements == kRowElements && sizeof(dxInverseInertia) == dxPackedProblem::kInertiaElements * sizeof(dReal),
              "arrays are packed as they lie");

std::size_t aligned(std::size_t bytes) { return (bytes + kAlignment - 1) / kAlignment * kAlignment; }

// Sizes of the arrays, in their order, in 64 bits: counts of 32 cannot overflow them.
struct Layout {
    explicit Layout(const dxPackedCounts &counts)
        : joints(aligned(counts.joints * sizeof(dxConstraintJoint))),
          jacobian(aligned(std::size_t(counts.rows) * kSides * kRowElements * sizeof(dReal))),
          inverseInertia(aligned(std::size_t(counts.bodies) * dxPackedProblem::kInertiaElements * sizeof(dReal))),
          motions(aligned(std::size_t(counts.bodies) * kRowElements * sizeof(dReal))),
          pairs(aligned(std::size_t(counts.rows) * kPair * sizeof(dReal))),
          normals(aligned(std::size_t(counts.rows) * sizeof(int))) {}

    std::size_t total() const { return sizeof(dxPackedCounts) + joints + jacobian + inverseInertia + motions + 2 * pairs + normals; }

    std::size_t joints, jacobian, inverseInertia, motions, pairs, normals;
};

// Joints have rows one after the other, of bodies that there are.
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

// A row of friction comes after that of its normal.
bool areNormalsSound(const dxPackedProblem &problem) {
    for (unsigned i = 0; i < problem.counts.rows; ++i) {
        int normal = 0;
        std::memcpy(&normal, problem.normalOf + i * sizeof normal, sizeof normal);
        if (normal < -1 || normal >= static_cast<int>(i)) return false;
    }
    return true;
}

}  // namespace

bool dxPackedProblem::read(const std::byte *bytes, std::size_t size) {
    constexpr std::uint32_t kMaxRows = 1u << 20;
    if (size < sizeof counts) return false;
    std::memcpy(&counts, bytes, sizeof counts);
    if (counts.rows == 0 || counts.rows > kMaxRows || counts.unboundedJoints > counts.joints) return false;
    const Layout layout(counts);
    if (layout.total() != size) return false;
    joints = bytes + sizeof counts;
    jacobian = joints + layout.joints;
    inverseInertia = jacobian + layout.jacobian;
    motions = inverseInertia + layout.inverseInertia;
    pairsBX = motions + layout.motions;
    pairsLoHi = pairsBX + layout.pairs;
    normalOf = pairsLoHi + layout.pairs;
    return areJointsSound(*this) && areNormalsSound(*this);
}

void dxPackProblem(const dxExactProblem &problem, dReal stepSize, std::vector<std::byte> &bytes) {
    const dxPackedCounts counts{dxFloatMode(),  problem.bodyCount, problem.jointCount, problem.rowCount, problem.unboundedJoints, 0};
    const Layout layout(counts);
    bytes.resize(layout.total());
    std::byte *to = bytes.data();
    const auto add = [&to](const void *array, std::size_t size, std::size_t room) {
        std::memcpy(to, array, size);
        std::memset(to + size, 0, room - size);
        to += room;
    };
    add(&counts, sizeof counts, sizeof counts);
    // Where they lie in the bytes they are aligned for their own type: all sizes before them are multiples of eight.
    dxListConstraintJoints(problem, reinterpret_cast<dxConstraintJoint *>(to));
    to += layout.joints;
    add(problem.jacobian, std::size_t(counts.rows) * kSides * kRowElements * sizeof(dReal), layout.jacobian);
    std::byte *const inertia = to;
    to += layout.inverseInertia;
    dxFindMotions(problem, stepSize, reinterpret_cast<dReal *>(to));
    to += layout.motions;
    std::memcpy(inertia, problem.inverseInertia, std::size_t(counts.bodies) * sizeof(dxInverseInertia));
    add(problem.pairsBX, std::size_t(counts.rows) * kPair * sizeof(dReal), layout.pairs);
    add(problem.pairsLoHi, std::size_t(counts.rows) * kPair * sizeof(dReal), layout.pairs);
    add(problem.normalOf, std::size_t(counts.rows) * sizeof(int), layout.normals);
}

dxPackedAnswer dxReadPackedResult(const std::vector<std::byte> &bytes, const dxExactProblem &problem) {
    dxPackedResult::Head head;
    if (bytes.size() < sizeof head) return dxPackedAnswer::Wrong;
    std::memcpy(&head, bytes.data(), sizeof head);
    if (head.outcome == dxPackedResult::Outcome::GivenBack) return dxPackedAnswer::GivenBack;
    const std::size_t size = std::size_t(problem.rowCount) * sizeof(dReal);
    if (head.outcome != dxPackedResult::Outcome::Solved || head.rows != problem.rowCount || bytes.size() < sizeof head + aligned(size) ||
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
    std::size_t at = sizeof head + aligned(head.rows * sizeof(dReal));
    for (unsigned i = 0; i < head.messages; ++i) {
        dxPackedResult::Message message;
        if (bytes.size() - at < sizeof message) return;
        std::memcpy(&message, bytes.data() + at, sizeof message);
        at += sizeof message;
        if (bytes.size() - at < message.length) return;
        const std::string text(reinterpret_cast<const char *>(bytes.data() + at), message.length);
        at += message.length;
        dMessage(message.number, "%s", text.c_str());
    }
}
