// Steps a scene and judges the solution: joint feedback tells the forces, getters the velocities.
#pragma once

#include "saved_problem.h"

#include "scenes/scene.h"

#include <vector>

namespace quality {

struct Judgement {
    Residual residual, start;  // of the solution, and of no forces at all
    double inconsistency = 0;  // largest difference of a velocity from what the forces give the body; m/s or rad/s
    double change = 0;         // largest change of a velocity by joints; m/s or rad/s
    double seconds = 0;        // that the step took, feedback included
    std::vector<Velocity> velocities;
};

class JudgedScene {
public:
    // Of a scene that has not been stepped. Damping and gyroscopic torques are switched off, since no getter tells what they add.
    explicit JudgedScene(scenes::Scene &scene);

    // Advances the scene by a frame as it is. Returns how long the step took, s.
    double frame();
    // Advances it by a frame, keeps the problem that is solved, and judges the solution.
    Judgement judgedFrame(SavedProblem &problem);
    // Steps the scene from the saved problem, with contacts of its own.
    Judgement replay(const SavedProblem &problem);

private:
    class ContactLog;

    SavedProblem problemNow(const std::vector<dContact> &contacts) const;
    std::vector<dJointID> contactJoints(const std::vector<SavedContact> &contacts) const;
    double timedStep();
    Judgement step(const std::vector<SavedContact> &contacts, const std::vector<dJointID> &joints);

    scenes::Scene &m_scene;
    const std::vector<dBodyID> &m_bodies;
    const std::vector<dJointID> &m_joints;  // permanent ones
    const JointRows m_jointRows;
};

}  // namespace quality
