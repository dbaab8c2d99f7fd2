#include "additions.h"
#include "dice.h"
#include "ground_grid.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <cmath>
#include <memory>

namespace exactness {

namespace {

// A crowd of every shape, close together, on one ground.
class TerrainCrowd : public ScenarioScene {
protected:
    explicit TerrainCrowd(Stepper stepper) : ScenarioScene(stepper), m_dice(11) {}

    void addCrowd(int count, dReal halfEdge) {
        for (int i = 0; i < count; ++i) {
            const Vector3 place = m_dice.within(halfEdge);
            const dBodyID body = carry(createShape(space(), allShapes[i % 6]),
                                       {place.x, place.y, dReal(1.2) + dReal(0.4) * (i % 3)});
            dBodySetAngularVel(body, 0.1 * (i % 7), 0.2, 0.1 * (i % 5));
        }
    }

    Dice m_dice;
};

class OnHeights : public TerrainCrowd {
public:
    OnHeights(Stepper stepper, HeightOptions options) : TerrainCrowd(stepper) {
        m_grid = std::make_shared<HeightGrid>(Ground{25, 0.5, waves}, options);
        keep(m_grid);
        m_heights = add(m_grid->createGeom(space()));
        addCrowd(110, 5.5);
    }

    void control() override {
        note("heights asked", m_grid->heightsAsked().value());
        if (frameNumber() % 7 == 3) drop(m_inventory.bodies[7 * frameNumber() % m_inventory.bodies.size()]);
    }

protected:
    std::shared_ptr<HeightGrid> m_grid;
    dGeomID m_heights;

private:
    static void drop(dBodyID body) {
        const dReal *place = dBodyGetPosition(body);
        dBodySetPosition(body, -place[0], place[1], 2.5);
    }
};

// An infinite height field: the crowd leaves the samples on all sides.
class Repeating : public OnHeights {
public:
    Repeating(Stepper stepper, HeightOptions options) : OnHeights(stepper, options) {
        for (dBodyID body : m_inventory.bodies) {
            const dReal *place = dBodyGetPosition(body);
            dBodySetPosition(body, 3 * place[0], 3 * place[1], place[2]);
        }
    }
};

// The user writes into the numbers that the height field reads.
class ChangedHeights : public OnHeights {
public:
    ChangedHeights(Stepper stepper, HeightOptions options) : OnHeights(stepper, options) {}

    void control() override {
        OnHeights::control();
        if (frameNumber() % 3 == 0) return;
        const dReal t = 0.1 * frameNumber();
        m_grid->reshape([t](int x, int y) { return waves(x, y) + 0.1 * std::sin(t + x); });
    }
};

// The height field itself moves, rotates, changes its data and is disabled for a frame.
class MovedHeights : public OnHeights {
public:
    MovedHeights(Stepper stepper, HeightOptions options) : OnHeights(stepper, options) {
        m_other = std::make_shared<HeightGrid>(
            Ground{13, 1, [](int x, int y) { return 0.2 * ((x + y) % 4); }}, options);
        keep(m_other);
        const dGeomID second = add(m_grid->createGeom(space()));
        dGeomSetPosition(second, 4, 3, -0.3);
    }

    void control() override {
        OnHeights::control();
        const dReal t = 0.05 * frameNumber();
        dMatrix3 tilt;
        dRFromAxisAndAngle(tilt, 1, 0.1 * std::sin(t), 0, M_PI / 2);
        dGeomSetRotation(m_heights, tilt);
        dGeomSetPosition(m_heights, 0.3 * std::sin(t), 0, 0.1 * std::cos(t));
        if (frameNumber() == 20) exchangeData();
        if (frameNumber() == 30) dGeomDisable(m_heights);
        if (frameNumber() == 32) dGeomEnable(m_heights);
    }

private:
    void exchangeData() {
        const dGeomID lent = m_other->createGeom(nullptr);
        dGeomHeightfieldSetHeightfieldData(m_heights, dGeomHeightfieldGetHeightfieldData(lent));
        dGeomDestroy(lent);
    }

    std::shared_ptr<HeightGrid> m_other;
};

class OnMesh : public TerrainCrowd {
public:
    explicit OnMesh(Stepper stepper) : TerrainCrowd(stepper) {
        const auto grid = std::make_shared<GridMesh>(Ground{25, 0.5, waves});
        keep(grid);
        add(dCreateTriMesh(space(), grid->data(), nullptr, nullptr, nullptr));
        addCrowd(150, 5.5);
    }
};

// Rays from above, below and along, over heights, carried by bodies and not.
class RaysOnHeights : public OnHeights {
public:
    RaysOnHeights(Stepper stepper, HeightOptions options) : OnHeights(stepper, options) {
        for (int i = 0; i < 120; ++i) {
            const dGeomID ray = add(dCreateRay(space(), m_dice.between(0, 6)));
            const Vector3 from = m_dice.within(6), to = m_dice.within(1);
            dGeomRaySet(ray, from.x, from.y, from.z / 3 + 0.5, to.x, to.y, to.z);
            dGeomRaySetClosestHit(ray, i % 2);
            dGeomSetCategoryBits(ray, kDynamicCategory);
            if (i % 3 == 0) dGeomSetBody(ray, m_inventory.bodies[i / 2]);
        }
    }

protected:
    // Rays push nothing.
    void onNearPair(dGeomID o1, dGeomID o2) override {
        if (dGeomGetClass(o1) != dRayClass && dGeomGetClass(o2) != dRayClass) {
            OnHeights::onNearPair(o1, o2);
            return;
        }
        dContact hits[4] = {};
        const int count = dCollide(o1, o2, 4, &hits[0].geom, sizeof(dContact));
        for (int i = 0; i < count; ++i) tell(hits[i]);
    }
};

}  // namespace

void addTerrainCrowds(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make), callbacks));
    };
    HeightOptions options;
    options.source = HeightSource::Callback;
    add("terrain_crowds/called_back", "110 bodies on heights from a callback", make<OnHeights>(options));
    options = {};
    options.source = HeightSource::Bytes;
    options.repeats = true;
    options.scale = 0.01;
    add("terrain_crowds/repeating_bytes", "bodies on heights of bytes that repeat infinitely",
        make<Repeating>(options));
    options = {};
    options.source = HeightSource::Shorts;
    options.scale = 0.001;
    options.offset = 0.25;
    options.thickness = 0;
    add("terrain_crowds/thin_shorts", "bodies on heights of shorts, set off, not thick",
        make<OnHeights>(options));
    options = {};
    options.source = HeightSource::Floats;
    options.thickness = 20;
    options.isCopied = false;
    add("terrain_crowds/changed_floats", "bodies on the user's own floats, changed between frames",
        make<ChangedHeights>(options), Scenario::Callbacks::reentrant);
    options = {};
    add("terrain_crowds/moved_doubles", "two height fields, one moved, tilted, exchanged, switched off",
        make<MovedHeights>(options), Scenario::Callbacks::reentrant);
    add("terrain_crowds/rays", "rays and bodies on a height field", make<RaysOnHeights>(options));
    add("terrain_crowds/mesh", "150 bodies on one mesh", make<OnMesh>(), Scenario::Callbacks::reentrant);
}

}  // namespace exactness
