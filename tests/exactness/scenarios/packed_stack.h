// Boxes of different heights packed closely on the ground: every one touches its neighbours, so all are one
// island.
#pragma once

#include "dice.h"
#include "scenario_scene.h"

#include <vector>

namespace exactness {

class PackedStack : public ScenarioScene {
public:
    explicit PackedStack(Stepper stepper, int columns = 8, int rows = 8, int layers = 4);

protected:
    static constexpr dReal kEdge = 0.5;  // m: neighbours overlap by a centimetre

    const std::vector<dBodyID> &bricks() const { return m_bricks; }  // x fastest, then y, then z
    void setMass(dBodyID brick, dReal kilograms);
    Dice m_dice;

private:
    void addBrick(Vector3 place);

    std::vector<dBodyID> m_bricks;
};

}  // namespace exactness
