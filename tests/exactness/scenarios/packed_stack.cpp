#include "packed_stack.h"

namespace exactness {

PackedStack::PackedStack(Stepper stepper, int columns, int rows, int layers)
    : ScenarioScene(stepper), m_dice(3) {
    addGround();
    for (int z = 0; z < layers; ++z)
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                addBrick({dReal(0.49) * x, dReal(0.49) * y, 0.24 + dReal(0.48) * z});
}

void PackedStack::addBrick(Vector3 place) {
    const dReal height = m_dice.between(0.48, 0.52);
    m_bricks.push_back(addBox(place + m_dice.within(0.004), {kEdge, kEdge, height}, 1));
    dBodySetLinearVel(m_bricks.back(), m_dice.between(-0.2, 0.2), m_dice.between(-0.2, 0.2), 0);
}

void PackedStack::setMass(dBodyID brick, dReal kilograms) {
    dMass mass;
    dMassSetBoxTotal(&mass, kilograms, kEdge, kEdge, kEdge);
    dBodySetMass(brick, &mass);
}

}  // namespace exactness
