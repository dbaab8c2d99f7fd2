// Meshes that move: the triangles that they remember, their last transforms, and data that are exchanged.
//
// Covers api/collision_trimesh.cpp.
#include "additions.h"
#include "ground_grid.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <cmath>
#include <memory>

namespace exactness {

namespace {

dReal dish(int x, int y) { return 0.02 * ((x - 3) * (x - 3) + (y - 3) * (y - 3)); }

// Two dishes for every part that fall on one another and on a plane, with a shape in them.
class Dishes : public ManyParts {
protected:
    explicit Dishes(Stepper stepper)
        : ManyParts(stepper), m_grid(std::make_shared<GridMesh>(Ground{7, 0.2, dish})) {
        keep(m_grid);
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 2; ++i) {
                const dGeomID mesh = dCreateTriMesh(space(), m_grid->data(), nullptr, nullptr, nullptr);
                const dBodyID body =
                    carry(mesh, origin + Vector3{dReal(0.04) * part, 0, dReal(0.1) + dReal(0.3) * i});
                dBodySetAngularVel(body, 0, 0.1 * i, 0.2 * (part % 5));
                m_dishes.push_back(mesh);
            }
            carry(createShape(space(), allShapes[part % 6]), origin + Vector3{dReal(0.1), 0, 1});
        });
    }

    std::shared_ptr<GridMesh> m_grid;
    std::vector<dGeomID> m_dishes;
};

// Meshes that remember which triangles a geom touched last; the memory is cleared and switched off and on.
class Coherent : public Dishes {
public:
    explicit Coherent(Stepper stepper) : Dishes(stepper) {
        for (dGeomID mesh : m_dishes) setCoherence(mesh, 1);
    }

    void control() override {
        const dGeomID mesh = m_dishes[frameNumber() % m_dishes.size()];
        if (frameNumber() % 4 == 0) dGeomTriMeshClearTCCache(mesh);
        if (frameNumber() % 6 == 3) setCoherence(mesh, 0);
        if (frameNumber() % 6 == 5) setCoherence(mesh, 1);
        note("remembers spheres", dGeomTriMeshIsTCEnabled(mesh, dSphereClass));
    }

private:
    static void setCoherence(dGeomID mesh, int coherent) {
        for (int geomClass : {dSphereClass, dBoxClass, dCapsuleClass})
            dGeomTriMeshEnableTC(mesh, geomClass, coherent);
    }
};

// The user sets the last transform, of meshes that move and of one that does not.
class LastTransform : public Dishes {
public:
    explicit LastTransform(Stepper stepper) : Dishes(stepper) {}

    void control() override {
        for (dGeomID mesh : m_dishes) {
            const dReal *place = dGeomGetPosition(mesh), *turn = dGeomGetRotation(mesh);
            const dMatrix4 last = {turn[0], turn[4], turn[8],  0, turn[1],  turn[5],  turn[9],  0,
                                   turn[2], turn[6], turn[10], 0, place[0], place[1], place[2], 1};
            if ((frameNumber() + dGeomGetClass(mesh)) % 3 != 0) dGeomTriMeshSetLastTransform(mesh, last);
        }
        note("last height", dGeomTriMeshGetLastTransform(m_dishes[3])[14]);
    }
};

// The data of meshes is exchanged between frames, for finer and coarser, deeper and flatter dishes.
class ExchangedData : public Dishes {
public:
    explicit ExchangedData(Stepper stepper) : Dishes(stepper) {
        m_others = {
            m_grid, std::make_shared<GridMesh>(Ground{4, 0.4, [](int x, int y) { return 0.1 * (x + y); }}),
            std::make_shared<GridMesh>(Ground{13, 0.1, [](int x, int y) { return 0.03 * ((x + y) % 3); }})};
        for (const auto &each : m_others) keep(each);
    }

    void control() override {
        if (frameNumber() % 3 != 0) return;
        const dGeomID mesh = m_dishes[frameNumber() / 3 % m_dishes.size()];
        dGeomTriMeshSetData(mesh, m_others[frameNumber() % m_others.size()]->data());
        const dBodyID body = dGeomGetBody(mesh);  // upstream learns of the new bounds when the geom moves
        const dReal *place = dBodyGetPosition(body);
        dBodySetPosition(body, place[0], place[1], place[2] + 0.05);
        note("triangles", dGeomTriMeshGetTriangleCount(mesh));
    }

private:
    std::vector<std::shared_ptr<GridMesh>> m_others;
};

// A sea: the vertices of one mesh, which carries everything, are moved in place.
class Sea : public ManyParts {
public:
    explicit Sea(Stepper stepper)
        : ManyParts(stepper), m_grid(std::make_shared<GridMesh>(Ground{65, 1.25, waves})) {
        keep(m_grid);
        m_sea = add(dCreateTriMesh(space(), m_grid->data(), nullptr, nullptr, nullptr));
        dGeomSetPosition(m_sea, 30, 30, 0);
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 5; ++i) {
                const Shape shape = allShapes[i == 4 ? 5 : i];  // convex geoms want angles of faces that stay
                carry(createShape(space(), shape), origin + Vector3{dReal(0.9) * i, dReal(0.1) * part, 1.3});
            }
        });
    }

    void control() override {
        const dReal t = 0.1 * frameNumber();
        const bool isStill = frameNumber() % 4 == 0;
        if (!isStill) {
            m_grid->reshape([t](int x, int y) { return waves(x, y) + 0.15 * std::sin(t + 0.5 * x); });
            if (frameNumber() % 8 < 4) dGeomSetPosition(m_sea, 30, 30, 0);  // or the old bounds stay
        }
    }

private:
    std::shared_ptr<GridMesh> m_grid;
    dGeomID m_sea;
};

// Meshes whose place is set by the user in every frame, without bodies, that push what lies on them.
class Lifts : public ManyParts {
public:
    explicit Lifts(Stepper stepper)
        : ManyParts(stepper), m_grid(std::make_shared<GridMesh>(Ground{9, 0.5, waves})) {
        keep(m_grid);
        addParts([this](int part, Vector3 origin) {
            m_lifts.push_back(add(dCreateTriMesh(space(), m_grid->data(), nullptr, nullptr, nullptr)));
            m_origins.push_back(origin);
            for (int i = 0; i < 4; ++i)
                carry(createShape(space(), allShapes[(part + i) % 6]),
                      origin + Vector3{dReal(0.8) * i - 1, 0, 1.3});
        });
    }

    void control() override {
        for (std::size_t i = 0; i < m_lifts.size(); ++i) {
            const dReal t = 0.08 * frameNumber() + i;
            dMatrix3 turn;
            dRFromAxisAndAngle(turn, 0, 0, 1, 0.2 * std::sin(t));
            dGeomSetPosition(m_lifts[i], m_origins[i].x, m_origins[i].y, 0.2 * std::cos(t));
            dGeomSetRotation(m_lifts[i], turn);
        }
    }

private:
    std::shared_ptr<GridMesh> m_grid;
    std::vector<dGeomID> m_lifts;
    std::vector<Vector3> m_origins;
};

}  // namespace

void addMovingMeshes(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make,
                         Scenario::Callbacks callbacks = Scenario::Callbacks::oneAtATime) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make), callbacks));
    };
    add("moving_meshes/coherent", "falling meshes that remember triangles, or forget them", make<Coherent>());
    add("moving_meshes/last_transform", "falling meshes whose last transform is set",
        make<LastTransform>());
    add("moving_meshes/exchanged_data", "falling meshes whose triangles are exchanged",
        make<ExchangedData>());
    add("moving_meshes/sea", "a mesh whose vertices are moved between frames", make<Sea>(),
        Scenario::Callbacks::reentrant);
    add("moving_meshes/lifts", "meshes without bodies moved by the user", make<Lifts>(),
        Scenario::Callbacks::shared);
}

}  // namespace exactness
