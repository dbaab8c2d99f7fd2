// The rows of a contact joint, and their forces.
#pragma once

#include "constraint_row.h"

#include <vector>

namespace quality {

// A contact and the places of the bodies that it is attached to, in the order of dJointAttach. Saved and restored as bytes.
struct SavedContact {
    dContact contact;
    int body[2];  // ConstraintRow::kNone: the static world
};

struct RowContext {
    dWorldID world;
    dReal stepSize;
    const std::vector<dBodyID> &bodies;
};

// Appends the rows of the contact: the normal, up to two of friction, up to three of rolling friction.
void appendContactRows(const SavedContact &saved, const RowContext &context, std::vector<ConstraintRow> &rows);

// Enters the forces of rows that begin with `first`, whose sum the feedback is.
void readContactForces(const dJointFeedback &feedback, ConstraintRow *first, ConstraintRow *end);

}  // namespace quality
