// Islands of hundreds of rows for the exact step: beyond the numbers from which its solver skips zeros
// (64) and keeps rows by their elements (256), and across them from frame to frame.
#include "additions.h"
#include "dice.h"
#include "scenario_scene.h"

#include <string>
#include <utility>
#include <vector>

namespace exactness {

namespace {

// Three walls of bricks, one of which is pushed.
class Walls : public ManyParts {
public:
    explicit Walls(Stepper stepper) : ManyParts(stepper) {
        addGround();
        dWorldSetCFM(world(), 0);
        m_surface.mode = dContactApprox1;
        addParts([this](int part, Vector3 origin) { addWall(3 + part, origin); }, 3);
    }

    void control() override { dBodyAddForce(m_inventory.bodies[1], 0, 30, 10); }

private:
    void addWall(int length, Vector3 origin) {
        for (int z = 0; z < 3; ++z)
            for (int x = 0; x < length; ++x)
                addBox(origin + Vector3{dReal(0.499) * x + dReal(0.25) * (z % 2), 0,
                                        dReal(0.15) + dReal(0.299) * z},
                       {0.5, 0.3, 0.3}, 1);
    }
};

// Chains that lie on the ground in coils: joints throughout, contacts that slide between them.
class ChainsOnGround : public ManyParts {
public:
    explicit ChainsOnGround(Stepper stepper) : ManyParts(stepper), m_dice(29) {
        addGround();
        addParts(
            [this](int part, Vector3 origin) {
                dBodyID before = nullptr;
                for (int link = 0; link < 30 + 10 * part; ++link) {
                    const Vector3 place = origin + Vector3{dReal(0.2) * link, 0, 0.099};
                    const dBodyID body = addCapsule(place, scenes::kAxisX, 0.1, 0.1, m_dice.between(0.1, 2));
                    if (before != nullptr) addBall(body, before, place + Vector3{-0.1, 0, 0});
                    dBodySetLinearVel(body, 0, m_dice.between(-2, 2), 0);
                    before = body;
                }
            },
            3);
    }

private:
    Dice m_dice;
};

// Piles on which more and more contacts are made, from a few rows to eight hundred, and fewer again.
class GrowingPiles : public ManyParts {
public:
    explicit GrowingPiles(Stepper stepper) : ManyParts(stepper), m_dice(31) {
        addGround();
        m_contactLimit = kMaxContacts;
        addParts(
            [this](int part, Vector3 origin) {
                for (int i = 0; i < 12 + 4 * part; ++i)
                    addBox(origin + Vector3{dReal(0.49) * (i % 4), dReal(0.49) * (i / 4 % 2),
                                            dReal(0.25) + dReal(0.49) * (i / 8)},
                           {0.5, 0.5, 0.5}, 1);
            },
            2);
    }

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        constexpr int tenths[] = {1, 2, 3, 4, 6, 8, 5, 3, 1, 2, 7, 1};
        if (m_dice.below(10) < tenths[frameNumber() % 12]) ManyParts::onNearPair(o1, o2);
    }

private:
    Dice m_dice;
};

// Figures of hinged limbs with motors at their stops, standing on many feet: rows without limits, with wide
// ones and with narrow ones, and masses apart by nine decades.
class Figures : public ManyParts {
public:
    explicit Figures(Stepper stepper) : ManyParts(stepper), m_dice(37) {
        addGround();
        dWorldSetCFM(world(), 0);
        m_surface.mode = 0;
        addParts(
            [this](int, Vector3 origin) {
                const dBodyID trunk = addBox(origin + Vector3{1.4, 0, 1.15}, {3, 0.4, 0.3}, 1000);
                for (int leg = 0; leg < 8; ++leg)
                    addLeg(leg, trunk, origin + Vector3{dReal(0.4) * leg, 0, 0});
            },
            3);
    }

    void control() override {
        for (const dJointID hinge : m_inventory.joints)
            dJointSetHingeParam(hinge, dParamVel, m_dice.between(-3, 3));
    }

private:
    void addLeg(int number, dBodyID trunk, Vector3 origin) {
        const dBodyID thigh =
                          addBox(origin + Vector3{0, 0, 0.8}, {0.1, 0.1, 0.39}, number % 2 == 0 ? 1e-6 : 10),
                      shank = addBox(origin + Vector3{0, 0, 0.4}, {0.1, 0.1, 0.39}, 1),
                      foot = addBox(origin + Vector3{0.05, 0, 0.0999}, {0.25, 0.2, 0.2}, 1);
        power(addHinge(thigh, trunk, origin + Vector3{0, 0, 1}, scenes::kAxisY));
        power(addHinge(shank, thigh, origin + Vector3{0, 0, 0.6}, scenes::kAxisY));
        power(addHinge(foot, shank, origin + Vector3{0, 0, 0.2}, scenes::kAxisX));
    }

    static void power(dJointID hinge) {
        dJointSetHingeParam(hinge, dParamLoStop, -0.02);
        dJointSetHingeParam(hinge, dParamHiStop, 0.02);
        dJointSetHingeParam(hinge, dParamFMax, 40);
    }

    Dice m_dice;
};

}  // namespace

void addManyRows(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        Scenario scenario{std::string("many_rows/") + name, meaning, 12, std::move(make)};
        scenario.steppers = {Stepper::World};
        catalogue.push_back(std::move(scenario));
    };
    add("walls", "three walls, no softness", make<Walls>());
    add("chains_on_ground", "chains that slide over the ground", make<ChainsOnGround>());
    add("growing_piles", "piles of a few rows to eight hundred and back", make<GrowingPiles>());
    add("figures", "figures with eight legs, motors at stops, masses apart by nine decades", make<Figures>());
}

}  // namespace exactness
