// All bodies and joints of a world as one group, as a step finds it.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "config.h"
#include "objects.h"
#include "joints/joint.h"

#include "dynamics/step/islands/dxIsland.h"

// Joints between bodies that do not move are left out.
class WorldGroup {
public:
    explicit WorldGroup(dWorldID world) {
        for (dxBody *body = world->firstbody; body != nullptr; body = static_cast<dxBody *>(body->next)) {
            body->tag = static_cast<int>(m_bodies.size());
            m_bodies.push_back(body);
        }
        for (dxJoint *joint = world->firstjoint; joint != nullptr; joint = static_cast<dxJoint *>(joint->next))
            if (joint->isEnabled()) m_joints.push_back(joint);
    }

    dxIsland island() const {
        return {m_bodies.data(), m_joints.data(), static_cast<unsigned>(m_bodies.size()), static_cast<unsigned>(m_joints.size())};
    }

private:
    std::vector<dxBody *> m_bodies;
    std::vector<dxJoint *> m_joints;
};
