// What the joints of an island say: their constraint rows; and what they are told: the forces that kept them.
#pragma once

#include "dynamics/step/islands/dxIslandProblem.h"
#include "dynamics/step/islands/dxIslandStep.h"

// Asks one joint for its rows (dxJoint::getInfo2), `count` by getInfo1, of which the first one has the number `firstRow`. Afterwards the rows'
// Jacobians, right-hand sides, cfm, limits, bodies and bounding rows are set, and lambda is 0.
void dxReadJointRows(const dxIslandStep &step, dxJoint &joint, unsigned firstRow, unsigned count, dxConstraintRow *rows);

class dxJointRows {
public:
    // Asks the joints how many rows they have (dxJoint::getInfo1). Serial, in the island's order. Takes memory of the step's arena.
    explicit dxJointRows(const dxIslandStep &step);

    unsigned rowCount() const { return m_joints[m_jointCount].firstRow; }

    // Asks them for their rows (dxJoint::getInfo2), and copies the Jacobians of joints with feedback. Parallel in an island of
    // contacts alone: other joints may push their bodies (motors at their stops), which has to go in order.
    //
    // Afterwards the rows' Jacobians, right-hand sides, cfm, limits, bodies and bounding rows are set, and lambda is 0.
    void read(dxConstraintRow *rows);

    // Calls visit(joint, its first row, number of rows), in the island's order. Joints without rows are left out.
    template <class Visit>
    void forJoints(const Visit &visit) const {
        for (unsigned i = 0; i < m_jointCount; ++i) visit(m_joints[i].joint, m_joints[i].firstRow, rowsOf(m_joints[i]));
    }

    // Writes the forces J' lambda to the joints' feedback. Serial.
    void giveFeedback(const dxConstraintRow *rows) const;

private:
    struct Joint {
        dxJoint *joint;
        unsigned firstRow;   // of the island's
        unsigned firstCopy;  // of the copied Jacobians
    };

    static constexpr std::size_t kCopyColumns = 12;

    bool hasOnlyContacts() const;
    void readAll(dxConstraintRow *rows, std::size_t begin, std::size_t end) const;
    void readJoint(dxConstraintRow *rows, const Joint &joint) const;
    void copyJacobian(const dxConstraintRow *rows, const Joint &joint) const;
    unsigned rowsOf(const Joint &joint) const { return (&joint)[1].firstRow - joint.firstRow; }
    bool hasCopy(const Joint &joint) const { return (&joint)[1].firstCopy != joint.firstCopy; }

    const dxIslandStep &m_step;
    Joint *m_joints;            // with rows, and behind the last one where its rows end
    unsigned m_jointCount = 0;
    dReal *m_copies = nullptr;  // of rows of joints with feedback: columns of body 1, of body 2
};
