#include "dynamics/world_step/dxJointOrder.h"

#include "dynamics/world_step/dxWorldStepProblem.h"
#include "dynamics/world_step/kernels/dxConstraintMatrix.h"

namespace {

// Three lists side by side, which grow from the middle of an array in both directions:
//
//   begin           mixed           limited           end
//     | unbounded     | mixed         | limited         |
//
// A mixed joint goes to the end of its list that lies away from where the last joint of another kind went, unless nothing is
// behind it on the other side; the neighbour in its way moves to the far end of its own list. That is upstream's order.
class Lists {
public:
    explicit Lists(dxWorldStepJoint *middle) : m_begin(middle), m_mixed(middle), m_limited(middle), m_end(middle) {}

    void addUnbounded(const dxWorldStepJoint &joint) {
        *--m_begin = joint;
        m_wasUnbounded = true;
    }

    void addLimited(const dxWorldStepJoint &joint) {
        *m_end++ = joint;
        m_wasUnbounded = false;
    }

    void addMixed(const dxWorldStepJoint &joint) {
        if (m_wasUnbounded ? m_limited == m_end : m_begin != m_mixed)
            appendMixed(joint);
        else
            prependMixed(joint);
    }

    dxWorldStepJoint *begin() const { return m_begin; }
    dxWorldStepJoint *end() const { return m_end; }
    unsigned countUnbounded() const { return static_cast<unsigned>(m_mixed - m_begin); }

private:
    // Where the neighbouring list is empty, an element is copied to its own place.
    void appendMixed(const dxWorldStepJoint &joint) {
        *m_end++ = *m_limited;
        *m_limited++ = joint;
    }

    void prependMixed(const dxWorldStepJoint &joint) {
        *--m_begin = m_mixed[-1];
        *--m_mixed = joint;
    }

    dxWorldStepJoint *m_begin, *m_mixed, *m_limited, *m_end;
    bool m_wasUnbounded = false;
};

// Upstream's tag of a joint without rows.
constexpr int kNoRows = -1;

// Numbers the joints and their rows. Returns how many rows there are.
unsigned numberRows(dxWorldStepJoint *begin, const dxWorldStepJoint *end) {
    unsigned row = 0;
    for (dxWorldStepJoint *joint = begin; joint != end; ++joint) {
        joint->joint->tag = static_cast<int>(joint - begin);
        joint->firstRow = row;
        row += joint->rows;
    }
    return row;
}

}  // namespace

void dxOrderJoints(const dxIslandStep &step, dxWorldStepProblem &problem) {
    const std::size_t count = step.island.jointCount;
    dxWorldStepJoint *const array = step.arena->AllocateArray<dxWorldStepJoint>(2 * count);
    Lists lists(array + count);
    for (std::size_t i = 0; i < count; ++i) {
        dxJoint *const joint = step.island.joints[i];
        dxJoint::Info1 info;
        joint->getInfo1(&info);
        dIASSERT(info.m <= kMaxJointRows && info.nub <= info.m);
        if (info.m == 0) {
            joint->tag = kNoRows;
            continue;
        }
        const dxWorldStepJoint entry{joint, 0, info.m};
        if (info.nub == 0)
            lists.addLimited(entry);
        else if (info.nub < info.m)
            lists.addMixed(entry);
        else
            lists.addUnbounded(entry);
    }
    step.arena->ShrinkArray(array, 2 * count, static_cast<std::size_t>(lists.end() - array));
    problem.joints = lists.begin();
    problem.jointCount = static_cast<unsigned>(lists.end() - lists.begin());
    problem.unboundedJoints = lists.countUnbounded();
    problem.rowCount = numberRows(lists.begin(), lists.end());
}
