// Small bodies on a square grid, each joined to its neighbours, held at two corners: one island of joints
// alone, full of closed loops. The bodies have no geoms.
#pragma once

#include "dice.h"
#include "scenario_scene.h"

#include <vector>

namespace exactness {

class JointLattice : public ScenarioScene {
protected:
    explicit JointLattice(Stepper stepper, int side = 18) : ScenarioScene(stepper), m_dice(7), m_side(side) {}

    // Builds the lattice; to be called at the end of the constructor, as it calls join().
    void build();

    // The joint or joints between two neighbours, half way between which `anchor` lies. Joints are numbered.
    virtual void join(int number, dBodyID first, dBodyID second, Vector3 anchor) = 0;

    const std::vector<dBodyID> &knots() const { return m_knots; }
    Dice m_dice;

private:
    const dBodyID &knot(int x, int y) const { return m_knots[static_cast<std::size_t>(y * m_side + x)]; }

    static constexpr dReal kPitch = 0.5;  // m
    static constexpr dReal kHeight = 5;   // m

    int m_side;
    std::vector<dBodyID> m_knots;
};

}  // namespace exactness
