// The problem that one step of a scene solves: what is needed to step it again in a new copy of the scene, on another library. The
// copy is made by the same program, so that bodies' masses, joints and parameters are equal.
#pragma once

#include "joint_rows.h"
#include "lcp_residual.h"

#include <string>
#include <vector>

namespace quality {

struct SavedProblem {
    std::vector<BodyState> bodies;
    std::vector<JointState> joints;
    std::vector<SavedContact> contacts;
};

// In bytes of this machine. Both throw std::runtime_error.
void write(const std::vector<SavedProblem> &problems, const std::string &path);
std::vector<SavedProblem> readProblems(const std::string &path);

}  // namespace quality
