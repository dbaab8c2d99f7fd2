// Stacks of boxes and of cylinders fall on the ground; written with odecpp.h. Prints the hash of the final
// state.
#include "stacks.h"

#include <ode/odecpp.h>

#include <memory>
#include <vector>

namespace {

class Block {
public:
    Block(dWorld &world, dSpace &space, int stack, int level) : m_body(world) {
        dMass mass;
        mass.setBox(DENSITY, EDGE, EDGE, EDGE);
        m_body.setMass(mass);
        m_body.setPosition(startX(stack), startY(level), startZ(level));
        if (hasCylinders(stack))
            m_cylinder.create(space, EDGE / 2, EDGE);
        else
            m_box.create(space, EDGE, EDGE, EDGE);
        dGeomSetBody(hasCylinders(stack) ? m_cylinder.id() : m_box.id(), m_body);
    }

    dBodyID id() const { return m_body.id(); }

private:
    dBody m_body;
    dBox m_box;
    dCylinder m_cylinder;
};

class Scene {
public:
    Scene() : m_ground(m_space, 0, 0, 1, 0) {
        m_world.setGravity(0, 0, GRAVITY);
        for (int stack = 0; stack < STACKS; stack++)
            for (int level = 0; level < LEVELS; level++)
                m_blocks.push_back(std::make_unique<Block>(m_world, m_space, stack, level));
    }

    void step(int number) {
        m_space.collide(
            this, [](void *scene, dGeomID g1, dGeomID g2) { static_cast<Scene *>(scene)->collide(g1, g2); });
        if (number % 2)
            m_world.step(STEP_SIZE);
        else
            m_world.quickStep(STEP_SIZE);
        m_contacts.empty();
    }

    void print() const {
        std::vector<dBodyID> bodies;
        for (const auto &block : m_blocks) bodies.push_back(block->id());
        printState(bodies.data());
    }

private:
    void collide(dGeomID g1, dGeomID g2) {
        dContact contact[MAX_CONTACTS];
        const int count = dCollide(g1, g2, MAX_CONTACTS, &contact[0].geom, sizeof(dContact));
        for (int i = 0; i < count; i++) {
            setSurface(&contact[i].surface);
            dJointAttach(dJointCreateContact(m_world, m_contacts, &contact[i]), dGeomGetBody(g1),
                         dGeomGetBody(g2));
        }
    }

    dWorld m_world;
    dHashSpace m_space;
    dJointGroup m_contacts;
    dPlane m_ground;
    std::vector<std::unique_ptr<Block>> m_blocks;
};

}  // namespace

int main() {
    dInitODE2(0);
    {
        Scene scene;
        for (int step = 0; step < STEPS; step++) scene.step(step);
        scene.print();
    }
    dCloseODE();
}
