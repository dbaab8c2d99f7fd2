// What a builder would try: bricks in bond, boxes on two boxes, planks on piers, an arch, a house of cards, a heap of stones. They lie on
// two others each, so that what a step leaves over pushes them apart rather than down: drift in the masonry's own plane is what these
// measure. With ODE_MT_EXACTNESS=thorough they stand for a minute, and there are walls of all settings.
#include "judged_scenes.h"
#include "observation.h"

#include "exactness/thorough.h"
#include "scenes/generator.h"
#include "scenes/random_rotation.h"
#include "scenes/terrain.h"

#include <algorithm>
#include <cmath>
#include <string>

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

    int framesOf(dReal seconds) const { return static_cast<int>(seconds * m_framesPerSecond); }
    void runOn() { run(m_lab, framesOf(exactness::isThorough() ? 60 : 4)); }

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

// For experiments whose number of iterations is not 20: as many in proportion, where others than 20 are asked for.
Stepping inProportion(const Stepping &stepping, int iterations) {
    constexpr int kUsual = 20;
    return {stepping.stepper, (iterations * stepping.iterations + kUsual / 2) / kUsual};
}

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

// A semicircular arch about the y axis through `centre`. Its stones are wedges.
struct Arch {
    static constexpr int kStones = 11;
    static constexpr dReal kRadius = REAL(1.2), kThickness = REAL(0.6), kDepth = REAL(0.4);  // m, the first to the middle of the ring
    static constexpr dReal kTurn = REAL(M_PI) / kStones;

    Vector3 centre;

    // `angle` from the x axis; `further` along the ring.
    Vector3 place(dReal angle, dReal further = 0) const {
        const dReal cosine = std::cos(angle), sine = std::sin(angle);
        return {centre.x + kRadius * cosine - further * sine, centre.y, centre.z + kRadius * sine + further * cosine};
    }
};

// A wedge is a body of two plates, one along each of its joints: two convex hulls have one contact, on which no stone rests, two boxes as
// many as a joint needs.
void addStone(Lab &lab, const Arch &arch, int number) {
    constexpr dReal kPlate = REAL(0.1);  // m
    const dReal begin = Arch::kTurn * static_cast<dReal>(number), end = begin + Arch::kTurn, middle = (begin + end) / 2;
    const dBodyID body = lab.add(dBodyCreate(lab.world()));
    dMass mass;
    dMassSetBox(&mass, kDensity, Arch::kThickness, Arch::kDepth, Arch::kRadius * Arch::kTurn);
    dBodySetMass(body, &mass);
    const Vector3 place = arch.place(middle);
    dBodySetPosition(body, place.x, place.y, place.z);
    tilt(body, -middle);
    for (const dReal joint : {begin, end}) {
        const Vector3 at = arch.place(joint, joint < middle ? kPlate / 2 : -kPlate / 2);
        dMatrix3 rotation;
        dRFromAxisAndAngle(rotation, 0, 1, 0, -joint);
        const dGeomID plate = dCreateBox(lab.space(), Arch::kThickness, Arch::kDepth, kPlate);
        dGeomSetBody(plate, body);
        dGeomSetOffsetWorldPosition(plate, at.x, at.y, at.z);
        dGeomSetOffsetWorldRotation(plate, rotation);
        lab.add(plate);
    }
}

// It has 50 iterations, since with 20 it collapses within a minute with libode8.
std::vector<Quantity> stoneArch(const Stepping &stepping) {
    constexpr dReal kAbutment = 1;  // m, its height
    Masonry masonry(inProportion(stepping, 50), {});
    Lab &lab = masonry.lab();
    const Arch arch{{0, 0, kAbutment}};
    for (const dReal x : {-Arch::kRadius, Arch::kRadius})
        lab.addStaticBox({x, 0, kAbutment / 2}, {Arch::kThickness + REAL(0.2), Arch::kDepth + REAL(0.2), kAbutment});
    for (int i = 0; i < Arch::kStones; ++i) addStone(lab, arch, i);
    return masonry.watch();
}

// Three storeys of cards that lean against one another in pairs, and a card over each storey but the last. (With one card from each pair to
// the next, which lies on 9 mm of it, the house collapses within a minute, with libode8's dWorldStep, too.)
std::vector<Quantity> cardHouse(const Stepping &stepping) {
    constexpr int kStoreys = 3;
    constexpr dReal kLength = REAL(0.4), kWidth = REAL(0.3), kThickness = REAL(0.01), kGap = REAL(0.02), kOverhang = REAL(0.05);  // m
    constexpr dReal kLean = REAL(0.3);                                                                                            // rad
    const dReal halfPair = kLength * std::sin(kLean) + kThickness * std::cos(kLean), pitch = 2 * halfPair + kGap;
    const dReal storey = kLength * std::cos(kLean) + kThickness * std::sin(kLean);  // m, its height
    Masonry masonry(stepping, {dInfinity, 240});
    dReal floor = 0;
    for (int pairs = kStoreys; pairs > 0; --pairs) {
        const dReal width = pitch * static_cast<dReal>(pairs - 1);  // m, from the first ridge to the last one
        for (int i = 0; i < pairs; ++i)
            for (const int side : {-1, 1}) {
                const dReal x = pitch * static_cast<dReal>(i) - width / 2 + side * halfPair / 2;
                tilt(masonry.add({x, 0, floor + storey / 2}, {kThickness, kWidth, kLength}), -side * kLean);
            }
        floor += storey;
        if (pairs > 1) masonry.add({0, 0, floor + kThickness / 2}, {width + 2 * kOverhang, kWidth, kThickness});
        floor += kThickness;
    }
    return masonry.watch();
}

// A box with a ball at either end.
dBodyID addLump(Lab &lab, const Vector3 &place, dReal size) {
    const dBodyID body = lab.addBox(place, {2 * size, REAL(1.4) * size, REAL(1.2) * size}, 15);
    const auto addBall = [&](dReal radius, dReal x, dReal z) {
        const dGeomID ball = dCreateSphere(lab.space(), radius);
        dGeomSetBody(ball, body);
        dGeomSetOffsetPosition(ball, x, 0, z);
        lab.add(ball);
    };
    addBall(REAL(0.7) * size, size, REAL(0.5) * size);
    addBall(REAL(0.4) * size, -size, 0);
    return body;
}

// 60 lumps that have fallen into a valley of bumpy ground, which is a mesh. (They are no convex hulls, since the contacts of these with a
// mesh are others in each run of the same program, with libode8, too.)
std::vector<Quantity> heapOnMesh(const Stepping &stepping) {
    constexpr int kLumps = 60, kColumns = 4;
    constexpr dReal kCell = REAL(0.5), kPitch = REAL(0.5);  // m
    const Vector3 valley{REAL(3.14), REAL(7.85), REAL(-0.6)};
    Masonry masonry(stepping, {REAL(0.7), 100});
    Lab &lab = masonry.lab();
    scenes::Terrain(12, kPitch).addMesh(lab);
    scenes::Generator random(11);
    const auto cells = [](int number) { return kCell * (static_cast<dReal>(number) - REAL(0.5) * (kColumns - 1)); };
    for (int i = 0; i < kLumps; ++i) {
        const dReal height = kCell * static_cast<dReal>(1 + i / (kColumns * kColumns));
        const Vector3 place = valley + Vector3{cells(i % kColumns), cells(i / kColumns % kColumns), height};
        scenes::turnAtRandom(addLump(lab, place, random.between(REAL(0.1), REAL(0.14))), random);
    }
    return observeRest(lab, masonry.framesOf(3), masonry.framesOf(exactness::isThorough() ? 60 : 1));
}

// A wall ten bricks long with settings that simulations have.
struct WallSettings {
    int rows, framesPerSecond, iterations;
    dReal friction;

    std::string name() const {
        const std::string tenths = std::to_string(std::lround(10 * std::min(friction, REAL(1.))));
        return "wall_" + std::to_string(rows) + "x10_" + std::to_string(framesPerSecond) + "hz_" + std::to_string(iterations) + "it_mu" +
               (friction == dInfinity ? "inf" : friction == 1 ? "1" : "0" + tenths);
    }

    Experiment experiment() const {
        return {name(), "rows x bricks, frames, iterations, friction",
                [settings = *this](const Stepping &stepping) {
                    return wall(inProportion(stepping, settings.iterations), settings.rows, 10,
                                {settings.friction, static_cast<dReal>(settings.framesPerSecond)});
                }};
    }
};

// Two, or a night's.
std::vector<WallSettings> wallSettings() {
    if (!exactness::isThorough()) return {{5, 50, 10, REAL(0.3)}, {5, 60, 20, REAL(0.5)}};
    constexpr dReal kFrictions[] = {REAL(0.3), REAL(0.5), 1, dInfinity};
    std::vector<WallSettings> all;
    for (const int rows : {5, 10, 20, 30})
        for (const int framesPerSecond : {50, 60, 100, 240})
            for (const int iterations : {10, 20, 50})
                for (const dReal friction : kFrictions) all.push_back({rows, framesPerSecond, iterations, friction});
    return all;
}

}  // namespace

std::vector<Experiment> masonryExperiments() {
    std::vector<Experiment> all{{"brick_wall", "8 rows of 10 bricks in bond", brickWall},
                                {"slippery_wall", "the same with friction 0.3, 60 Hz", slipperyWall},
                                {"long_wall", "6 rows of 20 bricks, friction without end, 240 Hz", longWall},
                                {"wall_with_opening", "8 rows, a lintel over a door", opening},
                                {"round_tower", "16 rings of 10 bricks", roundTower},
                                {"pyramid", "12 boxes at the base", pyramid},
                                {"dry_stones", "8 rows of stones of any length", dryStones},
                                {"shelves", "two planks on piers with boxes on them, 50 Hz", shelves},
                                {"loaded_bridge", "beams on piers under a moving load", loadedBridge},
                                {"standing_dominoes", "30 that nobody pushes", dominoes},
                                {"arch", "eleven wedges on two abutments, 50 iterations", stoneArch},
                                {"card_house", "three storeys of leaning cards, friction without end, 240 Hz", cardHouse},
                                {"heap_on_mesh", "60 lumps that have fallen into a valley", heapOnMesh}};
    for (const WallSettings &settings : wallSettings()) all.push_back(settings.experiment());
    return all;
}

}  // namespace quality
