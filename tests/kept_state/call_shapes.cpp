#include "call_shapes.h"

#include "user_code.h"

#include "contact_half_way.h"

#include <cmath>
#include <cstring>

namespace kept_state {

namespace {

constexpr dReal kHalf = 0.2;
const dReal kPlanes[2][24] = {
    {1, 0, 0, kHalf, -1, 0, 0, kHalf, 0, 1, 0, kHalf, 0, -1, 0, kHalf, 0, 0, 1, kHalf, 0, 0, -1, kHalf},
    {1, 0,  0, 2 * kHalf, -1, 0, 0, 2 * kHalf, 0, 1, 0,  kHalf,
     0, -1, 0, kHalf,     0,  0, 1, kHalf,     0, 0, -1, kHalf}};
const unsigned kPolygons[] = {4, 1, 3, 7, 5, 4, 0, 4, 6, 2, 4, 2, 6, 7, 3,
                              4, 0, 1, 5, 4, 4, 4, 5, 7, 6, 4, 0, 2, 3, 1};

// Corner i of a box: bit 0 is x, bit 1 y, bit 2 z.
const dReal *corners(int version) {
    static dReal points[2][24];
    for (int v = 0; v < 2; ++v)
        for (int i = 0; i < 8; ++i) {
            points[v][3 * i] = ((i & 1) != 0 ? 1 : -1) * kHalf * (v + 1);
            points[v][3 * i + 1] = ((i & 2) != 0 ? 1 : -1) * kHalf;
            points[v][3 * i + 2] = ((i & 4) != 0 ? 1 : -1) * kHalf;
        }
    return points[version];
}

const dTriIndex kIndices[] = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};

struct Custom {
    dReal radius;
};

dReal radiusOf(dGeomID geom) { return static_cast<Custom *>(dGeomGetClassData(geom))->radius; }

int collideCustom(dGeomID o1, dGeomID o2, int, dContactGeom *contact, int) {
    reached(UserCode::collider);
    const dReal *a = dGeomGetPosition(o1), *b = dGeomGetPosition(o2);
    const dReal dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
    const dReal distance = std::sqrt(dx * dx + dy * dy + dz * dz);
    const dReal depth = radiusOf(o1) + 0.2 - distance;
    if (depth < 0 || distance == 0) return 0;
    const dVector3 normal = {dx / distance, dy / distance, dz / distance};
    return contactHalfWay(o1, o2, normal, depth, *contact);
}

dColliderFn *colliderFor(int other) {
    reached(UserCode::colliderGetter);
    return other == dSphereClass || other == dBoxClass || other == dCapsuleClass ? collideCustom : nullptr;
}

void boxOfCustom(dGeomID geom, dReal aabb[6]) {
    reached(UserCode::boxFunction);
    const dReal *place = dGeomGetPosition(geom);
    for (int i = 0; i < 3; ++i) {
        aabb[2 * i] = place[i] - radiusOf(geom);
        aabb[2 * i + 1] = place[i] + radiusOf(geom);
    }
}

int testBox(dGeomID, dGeomID, dReal *) {
    reached(UserCode::boxTest);
    return 1;
}

void destroyCustom(dGeomID) { reached(UserCode::destructor); }

int classOf(const dGeomClass &functions) { return dCreateGeomClass(&functions); }

}  // namespace

ConvexArrays convexArrays(int version) { return {kPlanes[version], 6, corners(version), 8, kPolygons}; }

dReal *meshVertices(int version) {
    static dReal vertices[2][24];
    const dReal size = version == 0 ? 0.25 : 0.45;
    std::memset(vertices[version], 0, sizeof vertices[version]);
    for (int i = 0; i < 6; ++i) vertices[version][4 * i + i / 2] = i % 2 == 0 ? size : -size;
    return vertices[version];
}

const dTriIndex *meshIndices() { return kIndices; }

const float *meshVerticesSingle() {
    static float vertices[18];
    const dReal *doubles = meshVertices(1);
    for (int i = 0; i < 18; ++i) vertices[i] = static_cast<float>(doubles[i / 3 * 4 + i % 3]);
    return vertices;
}

dTriMeshDataID createMeshData(int version) {
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, meshVertices(version), 6, kIndices, 24);
    dGeomTriMeshDataPreprocess2(data, 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES, nullptr);
    return data;
}

double *heightSamples(int version) {
    static double samples[2][25];
    for (int i = 0; i < 25; ++i) samples[version][i] = 0.1 * (i * 7 % 5) * (version + 1);
    return samples[version];
}

dHeightfieldDataID createHeights(int version) {
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(data, heightSamples(version), 0, 3, 3, 5, 5, 1, 0, 0.2, 0);
    dGeomHeightfieldDataSetBounds(data, -0.5, 1.5);
    return data;
}

dGeomClass customClassFunctions() {
    dGeomClass functions{};
    functions.bytes = sizeof(Custom);
    functions.collider = colliderFor;
    functions.aabb = boxOfCustom;
    functions.dtor = destroyCustom;
    return functions;
}

int customClass() {
    static const int number = classOf(customClassFunctions());
    return number;
}

int testedClass() {
    static const int number = [] {
        dGeomClass functions = customClassFunctions();
        functions.aabb_test = testBox;
        return classOf(functions);
    }();
    return number;
}

dGeomID createCustom(dSpaceID space, dReal radius, int geomClass) {
    const dGeomID geom = dCreateGeom(geomClass);
    static_cast<Custom *>(dGeomGetClassData(geom))->radius = radius;
    if (space != nullptr) dSpaceAdd(space, geom);
    return geom;
}

}  // namespace kept_state
