// Towers of boxes, with the classes of odecpp.h. Prints where the top of each tower ends, in metres.
#include <ode/ode.h>

#include <ode/odecpp.h>

#include <cstdio>
#include <memory>
#include <vector>

namespace {

constexpr double kEdge = 0.5, kDensity = 500;  // m, kg/m^3
constexpr int kTowers = 8, kLevels = 5;

class Block {
public:
    Block(dWorld &world, dSpace &space, double x, double z) : m_body(world), m_box(space, kEdge, kEdge, kEdge) {
        dMass mass;
        mass.setBox(kDensity, kEdge, kEdge, kEdge);
        m_body.setMass(mass);
        m_body.setPosition(x, 0, z);
        m_box.setBody(m_body);
    }
    double height() const { return m_body.getPosition()[2]; }

private:
    dBody m_body;
    dBox m_box;
};

class Scene {
public:
    Scene() : m_ground(m_space, 0, 0, 1, 0) {
        m_world.setGravity(0, 0, -9.81);
        for (int tower = 0; tower < kTowers; ++tower)
            for (int level = 0; level < kLevels; ++level)
                m_blocks.push_back(std::make_unique<Block>(m_world, m_space, 2 * tower, kEdge * (level + 0.5)));
    }

    void step() {
        m_space.collide(this, [](void *scene, dGeomID geom1, dGeomID geom2) { static_cast<Scene *>(scene)->touch(geom1, geom2); });
        m_world.quickStep(0.005);
        m_contacts.empty();
    }

    double topOf(int tower) const { return m_blocks[tower * kLevels + kLevels - 1]->height() + kEdge / 2; }

private:
    void touch(dGeomID geom1, dGeomID geom2) {
        dContact contacts[8];
        const int count = dCollide(geom1, geom2, 8, &contacts[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) {
            contacts[i].surface.mode = dContactApprox1;
            contacts[i].surface.mu = 0.8;
            dJointAttach(dJointCreateContact(m_world, m_contacts, &contacts[i]), dGeomGetBody(geom1), dGeomGetBody(geom2));
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
    dToggleODE_MT(dODE_MT_AUTO);  // towers that do not touch are islands: each may be stepped by another thread
    {
        Scene scene;
        for (int step = 0; step < 200; ++step) scene.step();
        for (int tower = 0; tower < kTowers; ++tower) std::printf("tower %d: %.4f m\n", tower, scene.topOf(tower));
    }
    dCloseODE();
}
