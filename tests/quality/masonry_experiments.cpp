// What a builder would try: bricks in bond, boxes on two boxes, planks on piers. They lie on two others each, so that what a step leaves
// over pushes them apart rather than down: drift in the masonry's own plane is what these measure. A minute with ODE_MT_EXACTNESS=thorough.
#include "judged_scenes.h"
#include "observation.h"

#include "exactness/thorough.h"
#include "scenes/generator.h"

#include <cmath>

namespace quality {

namespace {

using scenes::Vector3;

constexpr dReal kDensity = 1800;                                          // kg/m3, of bricks
constexpr dReal kLength = REAL(0.4), kWidth = REAL(0.2), kHeight = kWidth;  // m, of a brick and its joint
constexpr dReal kJoint = REAL(0.002);                                     // m, between bricks of a row

// How a masonry is stepped; friction is Coulomb's.
struct Ground {
    dReal friction = 1, framesPerSecond = 100;
};

class Masonry {
public:
    Masonry(const Stepping &stepping, const Ground &ground)
        : m_lab(stepping.stepper, 1 / ground.framesPerSecond), m_framesPerSecond(ground.framesPerSecond) {
        use(stepping, m_lab);
        dSurfaceParameters &surface = m_lab.surfaceOfAll();
        surface = {};
        surface.mode = dContactApprox1 | dContactSoftERP | dContactSoftCFM;
        surface.mu = ground.friction;
        surface.soft_erp = REAL(0.2);
        surface.soft_cfm = REAL(1e-6);
        m_lab.addGround();
    }

    Lab &lab() { return m_lab; }

    dBodyID add(const Vector3 &place, const Vector3 &sides, dReal turn = 0) {
        const dBodyID body = m_lab.addBox(place, sides, kDensity * sides.x * sides.y * sides.z);
        dMatrix3 rotation;
        dRFromAxisAndAngle(rotation, 0, 0, 1, turn);
        dBodySetRotation(body, rotation);
        return body;
    }

    // A row along x from `begin` to `end`, its joints half a brick further in every other row.
    void addRow(int row, dReal begin, dReal end) {
        for (dReal left = begin; left < end - REAL(1e-6);) {
            const bool isHalf = left == begin && row % 2 != 0;
            const dReal right = std::min(end, left + (isHalf ? kLength / 2 : kLength));
            add({(left + right) / 2, 0, heightOf(row)}, {right - left - kJoint, kWidth, kHeight});
            left = right;
        }
    }

    static dReal heightOf(int row) { return kHeight * (REAL(0.5) + static_cast<dReal>(row)); }

    void runOn() { run(m_lab, static_cast<int>((exactness::isThorough() ? 60 : 4) * m_framesPerSecond)); }

    std::vector<Quantity> watch() {
        const Places places(m_lab.inventory().bodies);
        runOn();
        return {{"fallen", "bodies", static_cast<double>(places.countLower(kHeight / 2)), 0},
                {"median drift", "m", places.medianMove(), 5e-4},
                {"largest drift", "m", places.largestMove(), 1e-3},
                {"kinetic energy", "J", kineticEnergy(m_lab.inventory().bodies), 1e-2}};
    }

private:
    Lab m_lab;
    dReal m_framesPerSecond;
};

std::vector<Quantity> wall(const Stepping &stepping, int rows, int bricks, const Ground &ground) {
    Masonry masonry(stepping, ground);
    for (int row = 0; row < rows; ++row) masonry.addRow(row, 0, kLength * static_cast<dReal>(bricks));
    return masonry.watch();
}

std::vector<Quantity> brickWall(const Stepping &stepping) { return wall(stepping, 8, 10, {}); }
std::vector<Quantity> slipperyWall(const Stepping &stepping) { return wall(stepping, 8, 10, {REAL(0.3), 60}); }
std::vector<Quantity> longWall(const Stepping &stepping) { return wall(stepping, 6, 20, {dInfinity, 240}); }

// A lintel of three bricks' length carries what is above the opening.
std::vector<Quantity> opening(const Stepping &stepping) {
    Masonry masonry(stepping, {});
    for (int row = 0; row < 4; ++row) {
        masonry.addRow(row, 0, 4 * kLength);
        masonry.addRow(row, 6 * kLength, 10 * kLength);
    }
    masonry.addRow(4, 0, REAL(3.5) * kLength);
    masonry.add({5 * kLength, 0, Masonry::heightOf(4)}, {3 * kLength - kJoint, kWidth, kHeight});
    masonry.addRow(4, REAL(6.5) * kLength, 10 * kLength);
    for (int row = 5; row < 8; ++row) masonry.addRow(row, 0, 10 * kLength);
    return masonry.watch();
}

std::vector<Quantity> roundTower(const Stepping &stepping) {
    constexpr int kRings = 16, kBricks = 10;
    constexpr dReal kTurn = 2 * M_PI / kBricks, kRadius = REAL(1.12) * kLength / kTurn;
    Masonry masonry(stepping, {});
    for (int ring = 0; ring < kRings; ++ring)
        for (int i = 0; i < kBricks; ++i) {
            const dReal angle = kTurn * (static_cast<dReal>(i) + (ring % 2 != 0 ? REAL(0.5) : 0));
            masonry.add({kRadius * std::cos(angle), kRadius * std::sin(angle), Masonry::heightOf(ring)},
                        {kLength - kJoint, kWidth, kHeight}, angle + REAL(M_PI / 2));
        }
    return masonry.watch();
}

std::vector<Quantity> pyramid(const Stepping &stepping) {
    constexpr int kBase = 12;
    constexpr dReal kSide = REAL(0.5), kStep = REAL(0.55);
    Masonry masonry(stepping, {});
    for (int row = 0; row < kBase; ++row)
        for (int i = 0; i < kBase - row; ++i)
            masonry.add({kStep * (static_cast<dReal>(i) - REAL(0.5) * static_cast<dReal>(kBase - row - 1)), 0,
                         kSide * (REAL(0.5) + static_cast<dReal>(row))},
                        {kSide, kSide, kSide});
    return masonry.watch();
}

// Rows of stones of any length.
std::vector<Quantity> dryStones(const Stepping &stepping) {
    Masonry masonry(stepping, {REAL(0.7), 100});
    scenes::Generator random(7);
    for (int row = 0; row < 8; ++row)
        for (dReal left = 0; left < 4;) {
            const dReal length = random.between(REAL(0.2), REAL(0.5));
            const dReal right = left + length > REAL(3.8) ? 4 : left + length;
            masonry.add({(left + right) / 2, 0, Masonry::heightOf(row)}, {right - left - kJoint, random.between(REAL(0.2), REAL(0.3)), kHeight});
            left = right;
        }
    return masonry.watch();
}

// Two shelves, each of a plank on two piers of two bricks, with things on them.
std::vector<Quantity> shelves(const Stepping &stepping) {
    constexpr dReal kPlank = REAL(0.05), kPier = REAL(0.3);
    Masonry masonry(stepping, {REAL(0.6), 50});
    dReal floor = 0;
    for (int shelf = 0; shelf < 2; ++shelf) {
        for (const dReal x : {REAL(0.), REAL(1.6)})
            for (int i = 0; i < 2; ++i) masonry.add({x, 0, floor + Masonry::heightOf(i)}, {kPier, kPier, kHeight});
        floor += 2 * kHeight + kPlank;
        masonry.add({REAL(0.8), 0, floor - kPlank / 2}, {2, REAL(0.3), kPlank});
        for (int i = 0; i < 4; ++i)
            masonry.add({REAL(0.35) + REAL(0.3) * static_cast<dReal>(i), 0, floor + REAL(0.1)}, {REAL(0.1), REAL(0.2), REAL(0.2)});
    }
    return masonry.watch();
}

// Beams on piers, and a load of 144 kg that slides along them and back.
std::vector<Quantity> loadedBridge(const Stepping &stepping) {
    constexpr dReal kBeam = REAL(1.2), kSpeed = REAL(0.5), kLoad = REAL(0.4);
    constexpr int kBeams = 4;
    Masonry masonry(stepping, {});
    for (int pier = 0; pier <= kBeams; ++pier)
        for (int i = 0; i < 4; ++i) masonry.add({kBeam * static_cast<dReal>(pier), 0, Masonry::heightOf(i)}, {kLength, kLength, kHeight});
    for (int beam = 0; beam < kBeams; ++beam)
        masonry.add({kBeam * (static_cast<dReal>(beam) + REAL(0.5)), 0, Masonry::heightOf(4)}, {kBeam - kJoint, kLength, kHeight});
    Lab &lab = masonry.lab();
    const dBodyID load = lab.addBox({kBeam / 2, 0, 5 * kHeight + kLoad / 2}, {kLoad, kLoad, kLoad}, 144);
    lab.setController([load](int) {
        const dReal x = dBodyGetPosition(load)[0], *const v = dBodyGetLinearVel(load);
        const bool isBack = x > (kBeams - REAL(0.5)) * kBeam || (x >= kBeam / 2 && v[0] < 0);
        dBodySetLinearVel(load, isBack ? -kSpeed : kSpeed, 0, v[2]);
    });
    const Places bridge = [&] {
        std::vector<dBodyID> bodies = lab.inventory().bodies;
        bodies.pop_back();
        return Places(bodies);
    }();
    masonry.runOn();
    return {{"fallen", "bodies", static_cast<double>(bridge.countLower(kHeight / 2)), 0},
            {"median drift", "m", bridge.medianMove(), 1e-3},
            {"largest drift", "m", bridge.largestMove(), 5e-3}};
}

// They must not fall by themselves.
std::vector<Quantity> dominoes(const Stepping &stepping) {
    Masonry masonry(stepping, {REAL(0.5), 240});
    for (int i = 0; i < 30; ++i) masonry.add({REAL(0.25) * static_cast<dReal>(i), 0, REAL(0.25)}, {REAL(0.07), REAL(0.25), REAL(0.5)});
    return masonry.watch();
}

}  // namespace

std::vector<Experiment> masonryExperiments() {
    return {{"brick_wall", "8 rows of 10 bricks in bond", brickWall},
            {"slippery_wall", "the same with friction 0.3, 60 Hz", slipperyWall},
            {"long_wall", "6 rows of 20 bricks, friction without end, 240 Hz", longWall},
            {"wall_with_opening", "8 rows, a lintel over a door", opening},
            {"round_tower", "16 rings of 10 bricks", roundTower},
            {"pyramid", "12 boxes at the base", pyramid},
            {"dry_stones", "8 rows of stones of any length", dryStones},
            {"shelves", "two planks on piers with boxes on them, 50 Hz", shelves},
            {"loaded_bridge", "beams on piers under a moving load", loadedBridge},
            {"standing_dominoes", "30 that nobody pushes", dominoes}};
}

}  // namespace quality
