#include "additions.h"
#include "ground_grid.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <memory>

namespace exactness {

namespace {

// One hilly mesh under every kind of shape and a ray or two. What its callbacks are asked is summed up in
// order.
class AskingMesh : public ManyParts {
public:
    void control() override {
        note("questions", static_cast<double>(m_asked.count()));
        note("sum of the questions", m_asked.value());
    }

protected:
    explicit AskingMesh(Stepper stepper)
        : ManyParts(stepper), m_grid(std::make_shared<GridMesh>(Ground{65, 1.25, waves})) {
        keep(m_grid);
        m_mesh = add(dCreateTriMesh(space(), m_grid->data(), nullptr, nullptr, nullptr));
        dGeomSetPosition(m_mesh, 30, 30, 0);
        addParts([this](int part, Vector3 origin) {
            int number = 0;
            for (Shape shape : allShapes)
                carry(createShape(space(), shape),
                      origin + Vector3{dReal(0.9) * number++, dReal(0.1) * part, 1.3});
            addRays(origin, part);
        });
    }

    // For callbacks, which get no scene.
    static AskingMesh &self() { return static_cast<AskingMesh &>(living()); }
    static int frame() { return self().frameNumber(); }
    static OrderSum &sum() { return self().m_asked; }

    static void asked(dGeomID mesh, dGeomID other, int triangle) {
        sum().add(dGeomGetClass(other));
        sum().addReal(dGeomGetPosition(other)[0]);
        askedOf(mesh, triangle);
    }

    static void askedOf(dGeomID mesh, int triangle) {
        sum().add(mesh == self().m_mesh ? triangle : ~triangle);
    }

    std::shared_ptr<GridMesh> m_grid;
    dGeomID m_mesh;
    OrderSum m_asked;

private:
    void addRays(Vector3 origin, int part) {
        for (int i = 0; i < 3; ++i) {
            const dGeomID ray = add(dCreateRay(space(), 4));
            dGeomSetCategoryBits(ray, kDynamicCategory);
            dGeomRaySet(ray, origin.x + i, origin.y, 2.5, 0.2 * i, 0.05 * part, -1);
            dGeomRaySetClosestHit(ray, i == 1);
            dGeomRaySetParams(ray, i == 2, part % 2);
        }
    }
};

// The mesh's owner refuses some triangles, of some geoms, in some frames.
class Triangles : public AskingMesh {
public:
    explicit Triangles(Stepper stepper) : AskingMesh(stepper) { dGeomTriMeshSetCallback(m_mesh, &accept); }

private:
    static int accept(dGeomID mesh, dGeomID other, int triangle) {
        asked(mesh, other, triangle);
        return (triangle + frame() / 10 + dGeomGetClass(other)) % 9 != 0 ? 1 : 0;
    }
};

// The mesh's owner is shown all triangles of a geom at once.
class Arrays : public AskingMesh {
public:
    explicit Arrays(Stepper stepper) : AskingMesh(stepper) { dGeomTriMeshSetArrayCallback(m_mesh, &see); }

private:
    static void see(dGeomID mesh, dGeomID other, const int *triangles, int count) {
        for (int i = 0; i < count; ++i) asked(mesh, other, triangles[i]);
    }
};

// The mesh's owner lets rays through some triangles; and is asked by dCollide outside dSpaceCollide too.
class Rays : public AskingMesh {
public:
    explicit Rays(Stepper stepper) : AskingMesh(stepper) { dGeomTriMeshSetRayCallback(m_mesh, &stop); }

    void control() override {
        AskingMesh::control();
        for (dGeomID geom : m_inventory.geoms) {
            if (dGeomGetClass(geom) != dRayClass) continue;
            dContactGeom hits[8];
            const int count = dCollide(m_mesh, geom, 8, hits, sizeof(hits[0]));
            for (int i = 0; i < count; ++i) m_asked.addReal(hits[i].depth);
            dGeomRaySetLength(geom, 2 + 0.1 * (frameNumber() % 20));
        }
    }

private:
    static int stop(dGeomID mesh, dGeomID ray, int triangle, dReal u, dReal v) {
        asked(mesh, ray, triangle);
        sum().addReal(u);
        sum().addReal(v);
        return u > v ? 1 : 0;
    }
};

// The mesh's owner chooses the triangle of merged contacts.
class Merges : public AskingMesh {
public:
    explicit Merges(Stepper stepper) : AskingMesh(stepper) {
        m_contactLimit = 16;
        dGeomTriMeshSetTriMergeCallback(m_mesh, &choose);
        for (dGeomID geom : m_inventory.geoms) {
            if (dGeomGetClass(geom) == dTriMeshClass) dGeomTriMeshSetTriMergeCallback(geom, &choose);
        }
    }

private:
    static int choose(dGeomID mesh, int first, int second) {
        askedOf(mesh, first);
        askedOf(mesh, second);
        return first > second ? first : second;
    }
};

// Callbacks are set and removed between frames, and a refusing one removes itself.
class Exchanged : public AskingMesh {
public:
    explicit Exchanged(Stepper stepper) : AskingMesh(stepper) {}

    void control() override {
        AskingMesh::control();
        if (frameNumber() % 5 != 0) return;
        dGeomTriMeshSetCallback(m_mesh, frameNumber() % 10 == 0 ? &refuseOnce : nullptr);
        dGeomTriMeshSetArrayCallback(m_mesh, frameNumber() % 15 == 0 ? &see : nullptr);
        note("has a callback", dGeomTriMeshGetCallback(m_mesh) != nullptr);
    }

private:
    static int refuseOnce(dGeomID mesh, dGeomID other, int triangle) {
        asked(mesh, other, triangle);
        if (sum().count() % 100 == 0) dGeomTriMeshSetCallback(mesh, nullptr);
        return 0;
    }

    static void see(dGeomID, dGeomID other, const int *, int count) { asked(nullptr, other, count); }
};

}  // namespace

void addMeshCallbacks(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Scenario::Make make) {
        catalogue.push_back(collisionScenario(name, meaning, 40, std::move(make)));
    };
    add("mesh_callbacks/triangles", "a mesh's owner refuses some triangles", make<Triangles>());
    add("mesh_callbacks/arrays", "a mesh's owner sees all triangles of a pair", make<Arrays>());
    add("mesh_callbacks/rays", "a mesh's owner lets rays through some triangles", make<Rays>());
    add("mesh_callbacks/merges", "a mesh's owner chooses the triangles of merged contacts", make<Merges>());
    add("mesh_callbacks/exchanged", "callbacks of a mesh are set and removed, also in a callback", make<Exchanged>());
}

}  // namespace exactness
