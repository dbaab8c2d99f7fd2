#include "collision/narrowphase/dxConcurrentColliders.h"

#include <initializer_list>
#include <new>

#include "collision/narrowphase/dxColliderTable.h"
#include "collision/narrowphase/dxHeightField.h"

#include <ode/memory.h>

#include "collision_trimesh_internal.h"
#include "collision_std.h"
#include "collision_util.h"
#include "seams/upstream.h"

namespace {

bool hasNoPlace(const dxGeom &geom) { return geom.type == dPlaneClass; }
bool isMesh(const dxGeom &geom) { return geom.type == dTriMeshClass; }

// Colliding a height field takes memory, which a function of the user's may provide.
bool callsUser(const dxHeightfieldData *heights) {
    return heights == nullptr || heights->m_nGetHeightMode == 0 || dGetAllocHandler() != nullptr;
}

bool callsUserOrRemembers(const dxGeom &mesh) {
    const dGeomID geom = const_cast<dxGeom *>(&mesh);
    return dGeomTriMeshGetCallback(geom) != nullptr || dGeomTriMeshGetArrayCallback(geom) != nullptr ||
           dGeomTriMeshGetRayCallback(geom) != nullptr || dGeomTriMeshGetTriMergeCallback(geom) != nullptr ||
           dGeomTriMeshIsTCEnabled(geom, dSphereClass) || dGeomTriMeshIsTCEnabled(geom, dBoxClass) ||
           dGeomTriMeshIsTCEnabled(geom, dCapsuleClass);
}

bool isPure(const dxGeom &geom) {
    switch (geom.type) {
        case dSphereClass:
        case dBoxClass:
        case dCapsuleClass:
        case dCylinderClass:
        case dPlaneClass:
        case dRayClass:
        case dConvexClass:
            return true;
        case dTriMeshClass:
            return !callsUserOrRemembers(geom);
        case dHeightfieldClass:
            return !callsUser(dxHeightsOf(geom));
        default:
            return false;
    }
}

// A copy of a geom of a built-in class with a pose of its own, which may be transformed. The copied geom is never destroyed: its
// pointers are the original's.
class MovableCopy {
public:
    // `arrays`: those that a convex geom gets instead of its own, or NULL.
    dxGeom *of(const dxGeom &geom, const dxConvexArrays::Copy *arrays) {
        switch (geom.type) {
            case dSphereClass:
                return copy<dxSphere>(geom);
            case dBoxClass:
                return copy<dxBox>(geom);
            case dCapsuleClass:
                return copy<dxCapsule>(geom);
            case dCylinderClass:
                return copy<dxCylinder>(geom);
            case dRayClass:
                return copy<dxRay>(geom);
            case dConvexClass:
                return copyOfConvex(geom, arrays);
            default:
                return nullptr;
        }
    }

private:
    template <class Geom>
    dxGeom *copy(const dxGeom &geom) {
        static_assert(sizeof(Geom) <= sizeof m_memory && alignof(Geom) <= 16, "room for every class");
        Geom *const made = ::new (static_cast<void *>(m_memory)) Geom(static_cast<const Geom &>(geom));
        m_place = *geom.final_posr;
        made->final_posr = &m_place;
        return made;
    }
    dxGeom *copyOfConvex(const dxGeom &geom, const dxConvexArrays::Copy *arrays) {
        dxGeom *const made = copy<dxConvex>(geom);
        if (arrays != nullptr) arrays->giveTo(static_cast<dxConvex &>(*made));
        return made;
    }

    alignas(16) unsigned char m_memory[512];
    dxPosR m_place;
};

struct Copied {
    const dxGeom *copy, *original;
};

// Replaces copies in contacts by their originals.
void giveToOriginals(dContactGeom *contacts, int count, int skip, std::initializer_list<Copied> geoms) {
    for (int i = 0; i < count; ++i) {
        dContactGeom &contact = *CONTACT(contacts, i * skip);
        for (const Copied &copied : geoms)
            for (dGeomID *const geom : {&contact.g1, &contact.g2})
                if (*geom == copied.copy) *geom = const_cast<dxGeom *>(copied.original);
    }
}

}  // namespace

bool dxMayCollideConcurrently(const dxGeom &a, const dxGeom &b) {
    if (!isPure(a) || !isPure(b) || dxColliderOverrides::has(a.type, b.type)) return false;
    // Copies of meshes are not made.
    return !(dxIsHeightField(a) || dxIsHeightField(b)) || !(isMesh(a) || isMesh(b));
}

bool dxKnowsArrays(const dxGeom &a, const dxGeom &b) {
    const auto knows = [](const dxGeom &geom) {
        return !isMesh(geom) && (!dxIsHeightField(geom) || dxHeightsOf(geom)->m_bCopyHeightData != 0);
    };
    return knows(a) && knows(b);
}

bool dxHasDataOfProgram(const dxGeom &geom) { return isMesh(geom) || dxIsHeightField(geom); }

std::uint64_t dxColliderState(const dxGeom &geom) {
    constexpr std::uint64_t kImpure = 1;  // no pointer, and no flag of a ray
    if (geom.type == dRayClass) return geom.gflags & (RAY_FIRSTCONTACT | RAY_BACKFACECULL | RAY_CLOSEST_HIT);
    if (!isMesh(geom) && !dxIsHeightField(geom)) return 0;
    if (!isPure(geom)) return kImpure;
    if (dxIsHeightField(geom)) return reinterpret_cast<std::uintptr_t>(dxHeightsOf(geom));
    const auto &mesh = static_cast<const dxTriMesh &>(geom);
    return reinterpret_cast<std::uintptr_t>(mesh.retrieveMeshData()) ^
           static_cast<std::uint64_t>(mesh.m_SphereContactsMergeOption) << 48;
}

// A height field with buffers and data of its own. It takes over everything from each original except the buffers,
// which it keeps.
class dxColliderCopies::Terrain {
public:
    Terrain() : m_field(nullptr, nullptr, 0) {}
    ~Terrain() { m_heights.m_bCopyHeightData = 0; }  // the samples are the original's

    int collide(const dxHeightfield &terrain, const dxGeom &other, const dxConvexArrays::Copy *arraysOfOther, bool terrainFirst,
                int flags, dContactGeom *contacts, int skip) {
        const Borrowed borrowed(m_field);
        takeOver(terrain);
        dxGeom *const moved = m_other.of(other, arraysOfOther);
        const int count = terrainFirst ? dxUpstreamCollide(&m_field, moved, flags, contacts, skip)
                                       : dxUpstreamCollide(moved, &m_field, flags, contacts, skip);
        giveToOriginals(contacts, count, skip, {{&m_field, &terrain}, {moved, &other}});
        return count;
    }

private:
    // Drops the original's data, also when a message of the collider's is thrown.
    class Borrowed {
    public:
        explicit Borrowed(dxHeightfield &field) : m_field(field) {}
        ~Borrowed() {
            m_field.gflags = 0;
            m_field.final_posr = nullptr;
            m_field.body = nullptr;
        }
        Borrowed(const Borrowed &) = delete;
        Borrowed &operator=(const Borrowed &) = delete;

    private:
        dxHeightfield &m_field;
    };

    void takeOver(const dxHeightfield &terrain) {
        m_heights = *terrain.m_p_data;
        m_field.m_p_data = &m_heights;
        m_field.gflags = terrain.gflags;
        m_field.final_posr = terrain.final_posr;
        m_field.body = terrain.body;
        for (int i = 0; i < 6; ++i) m_field.aabb[i] = terrain.aabb[i];
    }

    dxHeightfield m_field;
    dxHeightfieldData m_heights;
    MovableCopy m_other;
};

dxColliderCopies::dxColliderCopies() = default;
dxColliderCopies::~dxColliderCopies() = default;
dxColliderCopies::dxColliderCopies(dxColliderCopies &&) noexcept = default;

int dxColliderCopies::collide(dxGeom &a, dxGeom &b, const Arrays &arrays, int flags, dContactGeom *contacts, int skip) {
    a.recomputePosr();
    b.recomputePosr();
    const bool isOnTerrain = dxIsHeightField(a) != dxIsHeightField(b) && !hasNoPlace(a) && !hasNoPlace(b);  // it transforms the other one
    if (isOnTerrain) return collideWithTerrain(a, b, arrays, flags, contacts, skip);
    MovableCopy copyOfA, copyOfB;
    dxGeom *const readA = arrays.a != nullptr ? copyOfA.of(a, arrays.a) : &a;
    dxGeom *const readB = arrays.b != nullptr ? copyOfB.of(b, arrays.b) : &b;
    const int count = dxUpstreamCollide(readA, readB, flags, contacts, skip);
    giveToOriginals(contacts, count, skip, {{readA, &a}, {readB, &b}});
    return count;
}

int dxColliderCopies::collideWithTerrain(dxGeom &a, dxGeom &b, const Arrays &arrays, int flags, dContactGeom *contacts, int skip) {
    if (m_terrain == nullptr) m_terrain = std::make_unique<Terrain>();
    const bool aIsTerrain = dxIsHeightField(a);
    const auto &terrain = static_cast<const dxHeightfield &>(aIsTerrain ? a : b);
    try {
        return m_terrain->collide(terrain, aIsTerrain ? b : a, aIsTerrain ? arrays.b : arrays.a, aIsTerrain, flags, contacts, skip);
    } catch (const std::bad_alloc &) {
        // Upstream frees a buffer before it allocates a larger one, and would free it again.
        static_cast<void>(m_terrain.release());
        throw;
    }
}
