#include "additions.h"
#include "ground_grid.h"
#include "prism.h"
#include "scenario_scene.h"

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

namespace exactness {

namespace {

enum class Piece { Box, Capsule, Cylinder, Sphere, Prism, Sheet };
enum class Below { Mesh, Heights };

// The resolution of the ground is much finer than the geoms on it.
constexpr int samples = 33;
constexpr dReal pitch = 0.06;  // m

dReal ripples(int x, int y) { return 0.02 * ((x * 7 + y * 3) % 5); }

// Curved, so that each corner of a prism's base is below the plane of few triangles: upstream's height fields
// test ten corners for a plane.
dReal bowl(int x, int y) {
    const dReal dx = pitch * (x - samples / 2), dy = pitch * (y - samples / 2);
    return 0.3 * (dx * dx + dy * dy);
}

// One large piece on each of many patches of fine ground: a hundred and more contacts for a pair.
class LargeOnFine : public ManyParts {
public:
    LargeOnFine(Stepper stepper, Piece piece, Below below, int minContacts)
        : ManyParts(stepper), m_leastContacts(minContacts) {
        m_contactLimit = 250;
        const Ground ground{samples, pitch, piece == Piece::Prism ? bowl : ripples};
        const auto mesh = std::make_shared<GridMesh>(ground);
        const auto heights = std::make_shared<HeightGrid>(ground, HeightOptions{});
        m_sheet = std::make_shared<GridMesh>(Ground{28, 0.045, ripples});
        m_prism = std::make_shared<Prism>(120, dReal(0.9), dReal(0.2));
        keep(mesh);
        keep(heights);
        keep(m_sheet);
        keep(m_prism);
        addParts(
            [&](int part, Vector3 origin) {
                const dGeomID patch = below == Below::Mesh
                                          ? dCreateTriMesh(space(), mesh->data(), nullptr, nullptr, nullptr)
                                          : heights->createGeom(space());
                dGeomSetPosition(patch, origin.x, origin.y, 0);
                add(patch);
                drop(create(piece), origin, part, piece);
            },
            8);
    }

    void collide() override {
        ManyParts::collide();
        // The scenario is about many contacts: without them it would show nothing.
        if (frameNumber() == lastFrame && m_most < m_leastContacts)
            throw std::logic_error("at most " + std::to_string(m_most) + " contacts for a pair");
    }

    static constexpr int lastFrame = 8;

protected:
    void onNearPair(dGeomID o1, dGeomID o2) override {
        const std::size_t before = m_contacts;
        ManyParts::onNearPair(o1, o2);
        m_most = std::max(m_most, static_cast<int>(m_contacts - before));
    }

private:
    dGeomID create(Piece piece) const {
        switch (piece) {
            case Piece::Box:
                return dCreateBox(space(), 1.2, 1, 0.2);
            case Piece::Capsule:
                return dCreateCapsule(space(), 0.3, 1);
            case Piece::Cylinder:
                return dCreateCylinder(space(), 0.6, 0.2);
            case Piece::Sphere:
                return dCreateSphere(space(), 0.6);
            case Piece::Prism:
                return m_prism->createGeom(space());
            case Piece::Sheet:
                break;
        }
        return dCreateTriMesh(space(), m_sheet->data(), nullptr, nullptr, nullptr);
    }

    // So low that the piece begins within the ground's ripples.
    static dReal heightOf(Piece piece) {
        switch (piece) {
            case Piece::Capsule:
                return 0.27;
            case Piece::Sphere:
                return 0.5;
            case Piece::Prism:
                return 0.335;
            case Piece::Sheet:
                return 0.01;
            default:
                return 0.1;
        }
    }

    void drop(dGeomID geom, Vector3 origin, int part, Piece piece) {
        const dReal height = heightOf(piece);
        const dBodyID body = carry(geom, origin + Vector3{0, 0, height});
        dBodySetAngularVel(body, 0, 0, 0.3 * part);
        if (piece != Piece::Capsule) return;
        dQuaternion lying;
        dQFromAxisAndAngle(lying, 1, 0, 0, M_PI / 2 + 0.01 * part);
        dBodySetQuaternion(body, lying);
    }

    std::shared_ptr<GridMesh> m_sheet;
    std::shared_ptr<Prism> m_prism;
    int m_leastContacts, m_most = 0;
};

}  // namespace

void addManyContacts(Catalogue &catalogue) {
    const auto add = [&](const char *name, const char *meaning, Piece piece, Below below, int minContacts) {
        catalogue.push_back(collisionScenario(name, meaning, LargeOnFine::lastFrame,
                                              make<LargeOnFine>(piece, below, minContacts)));
    };
    add("many_contacts/box_on_mesh", "100 and more contacts of a box with a mesh", Piece::Box, Below::Mesh,
        100);
    add("many_contacts/capsule_on_mesh", "many contacts of a capsule with a mesh", Piece::Capsule,
        Below::Mesh, 100);
    add("many_contacts/cylinder_on_mesh", "many contacts of a cylinder with a mesh", Piece::Cylinder,
        Below::Mesh, 100);
    add("many_contacts/sphere_on_mesh", "many contacts of a sphere with a mesh", Piece::Sphere, Below::Mesh,
        100);
    add("many_contacts/convex_on_mesh", "many contacts of a convex geom with a mesh", Piece::Prism,
        Below::Mesh, 100);
    add("many_contacts/mesh_on_mesh", "many contacts of two meshes", Piece::Sheet, Below::Mesh, 100);
    add("many_contacts/box_on_heights", "many contacts of a box with a height field", Piece::Box,
        Below::Heights, 100);
    add("many_contacts/convex_on_heights", "many contacts of a convex geom with a height field", Piece::Prism,
        Below::Heights, 100);
    add("many_contacts/mesh_on_heights", "many contacts of a mesh with a height field", Piece::Sheet,
        Below::Heights, 100);
}

}  // namespace exactness
