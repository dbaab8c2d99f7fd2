#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

// Many piles that fall asleep. Most of a space has not moved then, until something wakes it.
class Sleepers : public ManyParts {
protected:
    Sleepers(Stepper stepper, SpaceKind kind) : ManyParts(stepper, kind) {
        dWorldSetAutoDisableFlag(world(), 1);
        dWorldSetAutoDisableLinearThreshold(world(), 0.2);
        dWorldSetAutoDisableAngularThreshold(world(), 0.3);
        dWorldSetAutoDisableSteps(world(), 4);
        addGround();
        addParts([this](int, Vector3 origin) {
            for (int i = 0; i < 12; ++i) {
                const Vector3 place{dReal(0.55) * (i % 3), dReal(0.55) * (i / 3 % 2),
                                    dReal(0.25) + dReal(0.5) * (i / 6)};
                m_stones.push_back(addBox(origin + place, {0.5, 0.5, 0.5}, 1));
            }
            m_corners.push_back(origin);
        });
    }

    int awake() const {
        int count = 0;
        for (dBodyID stone : m_stones) count += dBodyIsEnabled(stone);
        return count;
    }

    std::vector<dBodyID> m_stones;
    std::vector<Vector3> m_corners;
};

// Balls roll into sleeping piles, one after another.
class Rollers : public Sleepers {
public:
    Rollers(Stepper stepper, SpaceKind kind) : Sleepers(stepper, kind) {}

    void control() override {
        note("awake", awake());
        if (frameNumber() % 7 != 0 || frameNumber() < 14) return;
        for (int i = 0; i < 2; ++i) {
            const Vector3 corner = m_corners[(frameNumber() / 7 + 5 * i) % m_corners.size()];
            const dBodyID ball = addSphere(corner + Vector3{-0.6, 0.2, 0.25}, 0.2, 2);
            dBodySetLinearVel(ball, 5, 0.3, 0);
        }
    }
};

// Callbacks and the user wake and put to sleep; kinematic plates lift sleeping piles, which does not wake
// them.
class Plates : public Sleepers {
public:
    Plates(Stepper stepper, SpaceKind kind) : Sleepers(stepper, kind) {
        for (std::size_t i = 0; i < m_corners.size(); i += 2) {
            const dBodyID plate = addBox(m_corners[i] + Vector3{0.5, 0.3, -0.06}, {2, 1.5, 0.1}, 1);
            dBodySetKinematic(plate);
            dBodySetAutoDisableFlag(plate, 0);
            m_plates.push_back(plate);
        }
    }

    void control() override {
        note("awake", awake());
        for (dBodyID plate : m_plates)
            dBodySetLinearVel(plate, 0, 0, frameNumber() > 25 && frameNumber() < 40 ? 0.2 : 0);
        if (frameNumber() % 10 == 9) dBodyEnable(m_stones[31 * frameNumber() % m_stones.size()]);
        if (frameNumber() == 42) dBodyDisable(m_plates[0]);
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        Sleepers::onNearPair(o1, o2);
        const int pair = m_pairs++;
        if (pair % 700 == 350 && dGeomGetBody(o1) != nullptr) dBodyEnable(dGeomGetBody(o1));
        if (pair % 900 == 450 && dGeomGetBody(o2) != nullptr) dBodyDisable(dGeomGetBody(o2));
    }

private:
    std::vector<dBodyID> m_plates;
    int m_pairs = 0;
};

// Sleeping bodies are moved, turned and taken apart by the user, and stay asleep.
class MovedInSleep : public Sleepers {
public:
    MovedInSleep(Stepper stepper, SpaceKind kind) : Sleepers(stepper, kind) {}

    void control() override {
        note("awake", awake());
        if (frameNumber() % 5 != 0) return;
        for (std::size_t i = 0; i < 8; ++i) {
            const dBodyID stone = m_stones[(11 * frameNumber() + 23 * i) % m_stones.size()];
            const dReal *place = dBodyGetPosition(stone);
            dBodySetPosition(stone, place[0] + 0.05, place[1], place[2] + 0.01);
        }
    }
};

}  // namespace

void addSleepingCrowds(Catalogue &catalogue) {
    constexpr auto oneAtATime = Scenario::Callbacks::oneAtATime, shared = Scenario::Callbacks::shared;
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks) {
        catalogue.push_back(collisionScenario(name, meaning, 48, std::move(make), callbacks));
    };
    add("sleeping_crowds/rollers", "balls wake sleeping piles, hash space", make<Rollers>(SpaceKind::Hash),
        shared);
    add("sleeping_crowds/rollers_in_simple", "balls wake sleeping piles, simple space",
        make<Rollers>(SpaceKind::Simple), oneAtATime);
    add("sleeping_crowds/rollers_in_sweep_and_prune", "balls wake sleeping piles, sweep-and-prune space",
        make<Rollers>(SpaceKind::SweepAndPrune), shared);
    add("sleeping_crowds/rollers_in_quad_tree", "balls wake sleeping piles, quad-tree space",
        make<Rollers>(SpaceKind::QuadTree), shared);
    add("sleeping_crowds/plates", "kinematic plates, callbacks and the user disturb sleeping piles",
        make<Plates>(SpaceKind::Hash), oneAtATime);
    add("sleeping_crowds/moved_in_sleep", "sleeping bodies are moved by the user",
        make<MovedInSleep>(SpaceKind::Hash), shared);
}

}  // namespace exactness
