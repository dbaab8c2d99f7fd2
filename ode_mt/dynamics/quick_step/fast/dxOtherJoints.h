// The joints of a group that are not solved as lanes (hinges, motors, contacts with rolling friction), and their rows as they say
// them.
#pragma once

#include <optional>

#include "dynamics/quick_step/dxJointRows.h"
#include "dynamics/quick_step/fast/dxConstraintPlan.h"
#include "dynamics/step/islands/dxIslandStep.h"

class dxOtherJoints {
public:
    // Asks the joints for their rows. Takes memory of the step's arena, in which upstream's estimate has room for it. May call
    // the user's message handlers.
    dxOtherJoints(const dxIslandStep &step, const dxConstraintPlan &plan);

    dxConstraintRow *rows() const { return m_rows; }
    unsigned rowCount() const { return m_reader ? m_reader->rowCount() : 0; }

    // Calls visit(joint, its first row, number of rows) for those that have any, in the order of the group.
    template <class Visit>
    void forJoints(const Visit &visit) const {
        if (m_reader) m_reader->forJoints(visit);
    }

    // Requires forces in the rows' lambda.
    void giveFeedback() const {
        if (m_reader) m_reader->giveFeedback(m_rows);
    }

private:
    dxIslandStep m_step;  // of these joints alone
    std::optional<dxJointRows> m_reader;
    dxConstraintRow *m_rows = nullptr;
};
