// The rows of permanent joints, and their forces: ball joints and hinges, with motors and stops. Other types have none here.
#pragma once

#include "contact_rows.h"

#include <map>

namespace quality {

// Motors' speeds and largest forces, which a scene's controller sets. Saved and restored as bytes.
struct JointState {
    static constexpr int kCount = 4;
    dReal driven[kCount];
};

JointState stateOf(dJointID joint);
void restore(dJointID joint, const JointState &state);

class JointRows {
public:
    // Of joints as they were made, before the first step: a hinge's axis in its second body, which no getter tells later.
    explicit JointRows(const std::vector<dJointID> &joints);

    // Appends the rows of the joint, as it stands before the step.
    void append(dJointID joint, const RowContext &context, std::vector<ConstraintRow> &rows) const;

    // Enters the forces of these rows, whose sum the feedback is.
    static void readForces(const dJointFeedback &feedback, ConstraintRow *first, ConstraintRow *end);

private:
    struct Axis {
        dVector3 inSecond;
    };

    void appendHinge(dJointID joint, const RowContext &context, std::vector<ConstraintRow> &rows) const;

    std::map<dJointID, Axis> m_hinges;
};

}  // namespace quality
