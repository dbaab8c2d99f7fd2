#include "judged_scenes.h"

#include "lab.h"
#include "scenes/generator.h"

#include <functional>

namespace quality {

namespace {

using scenes::Vector3;

// Boxes of several sizes and turns above the ground, in layers of five by five.
void addHeap(Lab &lab, int count, std::uint64_t seed) {
    constexpr dReal kCell = REAL(0.55);  // m
    lab.addGround();
    scenes::Generator random(seed);
    for (int i = 0; i < count; ++i) {
        const Vector3 sides{random.between(REAL(0.2), REAL(0.4)), random.between(REAL(0.2), REAL(0.4)), random.between(REAL(0.2), REAL(0.4))};
        const dReal layer = static_cast<dReal>(i / 25);
        const Vector3 place{kCell * (i % 5), kCell * (i / 5 % 5), kCell * layer + REAL(0.3)};
        tilt(lab.addBox(place, sides, 500 * sides.x * sides.y * sides.z), random.between(-1, 1));
    }
}

// Limits of friction that no normal force changes.
void furnishFixedFriction(Lab &lab) {
    lab.surfaceOfAll().mode &= ~dContactApprox1;
    lab.surfaceOfAll().mu = 20;  // N
    addHeap(lab, 50, 1);
}

void furnishInfiniteFriction(Lab &lab) {
    lab.surfaceOfAll().mode &= ~dContactApprox1;
    lab.surfaceOfAll().mu = dInfinity;
    addHeap(lab, 50, 2);
}

// The world's own erp and cfm: hardly any softness.
void furnishHardContacts(Lab &lab) {
    lab.surfaceOfAll().mode = dContactApprox1;
    addHeap(lab, 50, 3);
}

// All are pushed to and fro, so that in every fifth frame the forces of the one before are a bad guess.
void furnishShaken(Lab &lab) {
    addHeap(lab, 50, 6);
    lab.setController([&lab](int frame) {
        const dReal push = (frame + 1) / 5 % 2 == 0 ? 8 : -8;  // N a kg
        for (const dBodyID body : lab.inventory().bodies) {
            dMass mass;
            dBodyGetMass(body, &mass);
            dBodyAddForce(body, push * mass.mass, 0, push / 2 * mass.mass);
        }
    });
}

void furnishRolling(Lab &lab) {
    lab.surfaceOfAll().mode |= dContactRolling;
    lab.surfaceOfAll().rho = lab.surfaceOfAll().rhoN = REAL(0.02);  // m
    lab.addSlope(REAL(0.15));
    scenes::Generator random(4);
    for (int i = 0; i < 60; ++i)
        lab.addSphere({REAL(0.45) * (i % 8), REAL(0.45) * (i / 8 % 4), REAL(0.9) + REAL(0.45) * static_cast<dReal>(i / 32)},
                      random.between(REAL(0.15), REAL(0.22)), 5);
}

// A kinematic slab that moves to and fro under towers, and ground that moves along y as a conveyor belt does.
void furnishConveyor(Lab &lab) {
    lab.addGround();
    const dBodyID slab = lab.addKinematicBox({0, 0, REAL(0.1)}, {3, 3, REAL(0.2)});
    for (int i = 0; i < 4; ++i) addTower(lab, {REAL(-0.9) + REAL(0.6) * i, 0, REAL(0.4)}, 3, REAL(0.4), 20);
    for (int i = 0; i < 5; ++i) addTower(lab, {2 + REAL(0.5) * i, 0, REAL(0.15)}, 2, REAL(0.3), 10);
    lab.setController([slab](int frame) { dBodySetLinearVel(slab, frame / 40 % 2 ? REAL(-0.5) : REAL(0.5), 0, 0); });
    const dSurfaceParameters standard = lab.surfaceOfAll();
    lab.setSurface([standard](dGeomID first, dGeomID second) {
        dSurfaceParameters surface = standard;
        if (dGeomGetClass(first) == dPlaneClass || dGeomGetClass(second) == dPlaneClass) {
            surface.mode |= dContactMotion1 | dContactSlip1;
            surface.motion1 = REAL(0.3);  // m/s
            surface.slip1 = REAL(1e-4);
        }
        return surface;
    });
}

// One kinematic body that hundreds of contacts share.
void furnishHub(Lab &lab) {
    const dBodyID slab = lab.addKinematicBox({0, 0, REAL(-0.5)}, {20, 20, 1});
    dBodySetAngularVel(slab, 0, 0, REAL(0.2));
    for (int i = 0; i < 49; ++i) addTower(lab, {REAL(0.6) * (i % 7 - 3), REAL(0.6) * (i / 7 - 3), REAL(0.2)}, 2, REAL(0.4), 20);
}

void furnishRestingHub(Lab &lab) {
    lab.addKinematicBox({0, 0, REAL(-0.5)}, {20, 20, 1});
    for (int i = 0; i < 49; ++i) addTower(lab, {REAL(0.6) * (i % 7 - 3), REAL(0.6) * (i / 7 - 3), REAL(0.2)}, 2, REAL(0.4), 20);
}

// Heavy boxes on light ones.
void furnishMassRatio(Lab &lab) {
    lab.addGround();
    for (int i = 0; i < 6; ++i) {
        addTower(lab, {2 * static_cast<dReal>(i), 0, REAL(0.25)}, 4, REAL(0.5), 1);
        lab.addBox({2 * static_cast<dReal>(i), 0, REAL(2.25)}, {REAL(0.5), REAL(0.5), REAL(0.5)}, 20 * static_cast<dReal>(i + 1));
    }
}

void furnishBouncing(Lab &lab) {
    lab.surfaceOfAll().mode |= dContactBounce;
    lab.surfaceOfAll().bounce = REAL(0.7);
    lab.surfaceOfAll().bounce_vel = REAL(0.1);
    lab.addGround();
    lab.addWalls(2, 0, 2);
    scenes::Generator random(5);
    for (int i = 0; i < 60; ++i) {
        const dReal layer = static_cast<dReal>(i / 16);
        const dBodyID ball = lab.addSphere({REAL(0.35) + REAL(0.43) * (i % 4), REAL(0.35) + REAL(0.43) * (i / 4 % 4), REAL(0.4) + REAL(0.42) * layer},
                                           REAL(0.2), 5);
        dBodySetLinearVel(ball, random.between(-2, 2), random.between(-2, 2), random.between(-2, 0));
    }
}

// Planks on hinges across a gap, with boxes on them. The last one hangs on two soft ball joints, so that the bridge may sag.
void furnishBridge(Lab &lab) {
    constexpr int kPlanks = 8;
    dBodyID previous = nullptr;
    for (int i = 0; i < kPlanks; ++i) {
        const dReal x = REAL(0.5) * static_cast<dReal>(i);
        const dBodyID plank = lab.addBox({x + REAL(0.25), 0, 3}, {REAL(0.46), 1, REAL(0.08)}, 10);
        lab.addHinge(plank, previous, {x, 0, 3}, scenes::kAxisY);
        previous = plank;
    }
    for (const dReal side : {REAL(-0.4), REAL(0.4)}) {
        const dJointID end = lab.addBall(previous, nullptr, {REAL(0.5) * kPlanks, side, 3});
        dJointSetBallParam(end, dParamERP, REAL(0.3));
        dJointSetBallParam(end, dParamCFM, REAL(2e-5));
    }
    for (int i = 0; i < 6; ++i) lab.addBox({REAL(0.5) * static_cast<dReal>(i + 1), 0, REAL(3.3)}, {REAL(0.3), REAL(0.3), REAL(0.3)}, 20);
}

// A movable body that dozens of contacts and four joints share.
void addDeck(Lab &lab, dReal mass, int side) {
    constexpr dReal kHalf = 10;  // m
    const dBodyID deck = lab.addBox({0, 0, REAL(-0.5)}, {2 * kHalf, 2 * kHalf, 1}, mass);
    for (const dReal x : {-kHalf, kHalf})
        for (const dReal y : {-kHalf, kHalf}) lab.addBall(deck, nullptr, {x, y, REAL(-0.5)});
    const dReal cell = 2 * kHalf / static_cast<dReal>(side);
    const auto place = [&](int i) { return cell * (static_cast<dReal>(i) + REAL(0.5)) - kHalf; };
    for (int i = 0; i < side * side; ++i)
        lab.addBox({place(i % side), place(i / side), REAL(0.499)}, {REAL(0.7) * cell, REAL(0.7) * cell, 1}, 1);
}

void furnishDeck(Lab &lab) { addDeck(lab, 10, 10); }

void furnishHeavyDeck(Lab &lab) { addDeck(lab, 100, 6); }

// Columns of pairs of boxes, each pair on a fixed joint: what joints and contacts have not found tilts a column.
void furnishFixedPairs(Lab &lab) {
    constexpr int kColumns = 8, kHeight = 6;
    constexpr dReal kSide = REAL(0.2), kGap = REAL(0.01);  // m
    lab.surfaceOfAll().mode = dContactApprox1;
    lab.addGround();
    for (int column = 0; column < kColumns; ++column)
        for (int i = 0; i < kHeight; ++i) {
            dBodyID pair[2];
            for (int half = 0; half < 2; ++half)
                pair[half] = lab.addBox({3 * kSide * static_cast<dReal>(column) + (kSide + kGap) * static_cast<dReal>(half), 0,
                                         kSide * (static_cast<dReal>(i) + REAL(0.5))},
                                        {kSide, kSide, kSide}, 1);
            lab.addFixed(pair[0], pair[1]);
        }
}

// A net of plates that falls to the ground; so many joints that fast QuickStep solves them in lanes. Half of them are hinges, with motors or stops.
void furnishNet(Lab &lab) {
    constexpr int kSide = 30;
    constexpr dReal kPitch = REAL(0.3), kPlate = REAL(0.24);  // m
    lab.addGround();
    std::vector<dBodyID> plates;
    const auto connect = [&](int i, int other, const Vector3 &anchor, const Vector3 &axis) {
        if (i % 2 == 0) {
            lab.addBall(plates[i], plates[other], anchor);
            return;
        }
        const dJointID hinge = lab.addHinge(plates[i], plates[other], anchor, axis);
        if (i % 3 == 0) dJointSetHingeParam(hinge, dParamFMax, 5);
        if (i % 3 != 1) return;
        dJointSetHingeParam(hinge, dParamLoStop, REAL(-0.2));
        dJointSetHingeParam(hinge, dParamHiStop, REAL(0.2));
    };
    for (int i = 0; i < kSide * kSide; ++i) {
        const dReal z = REAL(0.2) + REAL(0.0005) * static_cast<dReal>(i);
        const Vector3 at{kPitch * static_cast<dReal>(i % kSide), kPitch * static_cast<dReal>(i / kSide), z};
        plates.push_back(lab.addBox(at, {kPlate, kPlate, REAL(0.05)}, 1));
        if (i % kSide != 0) connect(i, i - 1, at - Vector3{kPitch / 2, 0, 0}, scenes::kAxisY);
        if (i >= kSide) connect(i, i - kSide, at - Vector3{0, kPitch / 2, 0}, {1, 0, 0});
    }
}

struct OwnScene {
    const char *name, *meaning;
    dReal stepSize;  // s
    void (*furnish)(Lab &);
};

constexpr OwnScene kOwnScenes[] = {
    {"fixed_friction", "heap of 50 boxes, friction without dContactApprox1", REAL(0.01), furnishFixedFriction},
    {"infinite_friction", "heap of 50 boxes that do not slide", REAL(0.01), furnishInfiniteFriction},
    {"hard_contacts", "heap of 50 boxes with the world's erp and cfm", REAL(0.01), furnishHardContacts},
    {"shaken", "heap of 50 boxes that is pushed to and fro", REAL(0.01), furnishShaken},
    {"rolling", "60 balls with rolling friction on a slope", REAL(0.01), furnishRolling},
    {"conveyor", "towers on a moving kinematic slab and on a conveyor belt", REAL(0.01), furnishConveyor},
    {"hub", "98 boxes on one kinematic body that turns", REAL(0.01), furnishHub},
    {"resting_hub", "98 boxes on one kinematic body", REAL(0.01), furnishRestingHub},
    {"mass_ratio", "four boxes of 1 kg under one of 20 to 120 kg", REAL(0.01), furnishMassRatio},
    {"bouncing", "60 balls that bounce between walls", REAL(0.005), furnishBouncing},
    {"deck", "100 boxes of 1 kg on a deck of 10 kg that four ball joints hold", REAL(0.01), furnishDeck},
    {"heavy_deck", "36 boxes of 1 kg on a deck of 100 kg that four ball joints hold", REAL(0.01), furnishHeavyDeck},
    {"fixed_pairs", "eight columns of six pairs of boxes on fixed joints", REAL(0.01), furnishFixedPairs},
    {"net", "900 plates on balls and hinges with motors and stops, falling to the ground", REAL(0.005), furnishNet},
    {"bridge", "planks on hinges with boxes on them", REAL(0.005), furnishBridge},
};

}  // namespace

std::unique_ptr<scenes::Scene> makeJudgedScene(const std::string &name, scenes::Stepper stepper) {
    for (const OwnScene &own : kOwnScenes) {
        if (name != own.name) continue;
        auto lab = std::make_unique<Lab>(stepper, own.stepSize);
        own.furnish(*lab);
        return lab;
    }
    return scenes::makeScene(name + (stepper == scenes::Stepper::World ? ",world" : ",quick"));
}

std::vector<scenes::SceneDescription> ownScenes() {
    std::vector<scenes::SceneDescription> list;
    for (const OwnScene &own : kOwnScenes) list.push_back({own.name, own.meaning});
    return list;
}

}  // namespace quality
