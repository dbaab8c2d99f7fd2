// Disabled geoms: moved, shrunk and taken out of spaces while they are, and enabled and disabled in callbacks.
//
// Covers api/collision.cpp.
#include "additions.h"
#include "crowd.h"
#include "order_sum.h"
#include "spaces.h"

namespace exactness {

namespace {

// A crowd, and balls that wait in one place, disabled, as pools of objects do. They are fetched and put back, moved while
// they wait, shrunk to nothing, and taken out; between frames, and the switches in callbacks too.
class Pool : public Crowd {
public:
    // A sweep-and-prune space of upstream's loses its way where a call within a call finds others enabled.
    Pool(Stepper stepper, SpaceKind kind, int crowd, int pool)
        : Crowd(stepper, kind, 41), m_collidesInside(kind != SpaceKind::SweepAndPrune) {
        addMembers(crowd / 2, 7, 1);
        for (int i = 0; i < pool; ++i) m_pool.push_back(wait(dCreateSphere(space(), 0.3 + 0.1 * m_dice.below(2))));
        for (int i = 0; i < 6; ++i) dGeomEnable(m_pool[i]);  // whose bounds are equal
        addMembers(crowd / 2, 7, 1);
        m_ray = dCreateRay(nullptr, 30);
    }

    ~Pool() override { dGeomDestroy(m_ray); }

    void control() override {
        alternate();
        const bool nothingChanges = frameNumber() % 12 == 3 || frameNumber() % 12 == 9;
        if (nothingChanges) return lookAlongARay();
        for (int i = 0; i < 4; ++i) {
            putBack(some());
            fetch(some());
        }
        nudge(some());
        dGeomSphereSetRadius(some(), m_dice.oneIn(2) ? 0 : 0.5);
        const dGeomID other = some();
        nudge(other);  // a clean one would come in front of those that are not
        dSpaceRemove(space(), other);
        dSpaceAdd(space(), other);
        m_switchesLeft = frameNumber() % 3 == 0 ? 3 : 0;
        lookAlongARay();
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Crowd::onNearPair(o1, o2);
        if (++m_pairs % 17 != 0 || m_switchesLeft == 0) return;
        --m_switchesLeft;
        // Those that wait have pairs with all that is enabled there: few are.
        if (m_pairs % 2 == 0) dGeomEnable(some());
        if (m_pairs % 3 == 0) dGeomDisable(o2);
        if (m_pairs % 4 == 0) dGeomDisable(some());
        if (m_pairs % 5 == 0 && m_collidesInside) dSpaceCollide(space(), this, &countInside);
    }

private:
    dGeomID some() { return m_pool[m_dice.below(static_cast<int>(m_pool.size()))]; }

    dGeomID wait(dGeomID ball) {
        add(ball);
        dGeomSetCollideBits(ball, ~0ul);
        keepFromContacts(ball);
        dGeomDisable(ball);
        return ball;
    }

    void putBack(dGeomID ball) {
        dGeomDisable(ball);
        dGeomSetPosition(ball, 0, 0, 0);
    }

    void fetch(dGeomID ball) {
        const Vector3 place = m_dice.within(7);
        dGeomSetPosition(ball, place.x, place.y, place.z);
        dGeomEnable(ball);
    }

    void lookAlongARay() {
        dGeomRaySet(m_ray, -10, m_dice.between(-1, 1), 0, 1, 0, 0);
        m_inside = OrderSum();
        dSpaceCollide2(m_ray, reinterpret_cast<dGeomID>(space()), this, &countInside);
        note("met by a ray", static_cast<double>(m_inside.count()));
    }

    static void countInside(void *data, dGeomID o1, dGeomID o2) {
        Pool &scene = *static_cast<Pool *>(data);
        scene.m_inside.add(dGeomGetClass(o1) * 16 + dGeomGetClass(o2));
        scene.note("inside", scene.m_inside.value());
        if (scene.m_inside.count() % 9 == 8) dGeomEnable(scene.some());
        if (scene.m_inside.count() % 7 == 1) scene.collideWithout(o1 == scene.m_ray ? o2 : o1);
    }

    // For a moment, within a call: afterwards all is as it was.
    void collideWithout(dGeomID geom) {
        const bool wasEnabled = dGeomIsEnabled(geom) != 0;
        dGeomDisable(geom);
        dSpaceCollide(space(), this, [](void *data, dGeomID o1, dGeomID o2) {
            static_cast<Pool *>(data)->m_inside.add(100 + dGeomGetClass(o1) * 16 + dGeomGetClass(o2));
        });
        if (wasEnabled) dGeomEnable(geom);
    }

    const bool m_collidesInside;
    std::vector<dGeomID> m_pool;
    dGeomID m_ray;
    OrderSum m_inside;
    int m_pairs = 0, m_switchesLeft = 0;
};

}  // namespace

void addDisabledGeoms(Catalogue &catalogue) {
    for (const SpaceKind kind : allSpaceKinds) {
        const std::string name = std::string("disabled_geoms/") + nameOf(kind);
        catalogue.push_back(collisionScenario(name + "_small", "90 geoms, and 60 that wait, disabled, in one place", 40,
                                              make<Pool>(kind, 90, 60)));
        catalogue.push_back(collisionScenario(name, "200 geoms, and 150 that wait, disabled, in one place", 20,
                                              make<Pool>(kind, 200, 150)));
        catalogue.push_back(collisionScenario(name + "_large", "700 geoms, and 600 that wait, disabled, in one place", 10,
                                              make<Pool>(kind, 700, 600)));
    }
}

}  // namespace exactness
