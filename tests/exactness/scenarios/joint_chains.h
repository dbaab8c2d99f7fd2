// Chains of boxes held by joints of one type, swinging from the world down to the ground, each chain with
// other motors, stops and breaking. Joints report their forces; those that pull too hard are destroyed.
#pragma once

#include "scenario_scene.h"

namespace exactness {

class JointChains : public ManyParts {
public:
    void control() override;

protected:
    using ManyParts::ManyParts;

    using SetParameter = void (*)(dJointID, int, dReal);

    // Builds the chains; to be called at the end of the constructor, as it calls join().
    void build();

    // Joins two bodies of chain `part`, at `anchor`. `before` is null for the first link: the world.
    virtual dJointID join(int part, dBodyID before, dBodyID body, Vector3 anchor) = 0;
    // Changes a joint's parameters in every frame.
    virtual void drive(dJointID /*joint*/, int /*place*/) {}

    // One of six settings, by the number of the chain: free, motor, stops, stops that bounce, motor with
    // a fudge factor at a stop, soft stops. `axis` from 0; `range` in m or rad.
    static void setLimits(dJointID joint, SetParameter set, int axis, int part, dReal range);

    static constexpr int links = 8;
    static constexpr dReal length = 0.4;  // m, of a link

private:
    void breakOverloaded();
};

}  // namespace exactness
