#include "shapes.h"

#include "contact_half_way.h"

#include <cmath>
#include <cstddef>

namespace fuzz {

std::function<void(ShapeCallback)> shapeCallback;

namespace {

void reached(ShapeCallback which) {
    if (shapeCallback) shapeCallback(which);
}

// --- meshes ------------------------------------------------------------------------------------------------

constexpr int kTerrainCells = 6;

void addOctahedron(std::vector<double> &vertices, std::vector<dTriIndex> &indices) {
    for (int i = 0; i < 6; ++i)
        for (int axis = 0; axis < 3; ++axis) vertices.push_back(axis != i / 2 ? 0 : i % 2 == 0 ? 0.5 : -0.5);
    indices = {0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5};
}

void addTerrain(std::vector<double> &vertices, std::vector<dTriIndex> &indices) {
    constexpr int points = kTerrainCells + 1;
    for (int y = 0; y < points; ++y)
        for (int x = 0; x < points; ++x) {
            vertices.push_back(x - kTerrainCells / 2.0);
            vertices.push_back(y - kTerrainCells / 2.0);
            vertices.push_back((x * 5 + y * 3) % 7 * 0.0625 - 0.25);
        }
    for (int y = 0; y < kTerrainCells; ++y)
        for (int x = 0; x < kTerrainCells; ++x) {
            const auto corner = static_cast<dTriIndex>(y * points + x);
            const auto above = static_cast<dTriIndex>(corner + points);
            for (const dTriIndex i : {corner, corner + 1, above, above, corner + 1, above + 1}) indices.push_back(static_cast<dTriIndex>(i));
        }
}

void addBox(std::vector<double> &vertices, std::vector<dTriIndex> &indices) {
    for (int i = 0; i < 8; ++i)
        for (int axis = 0; axis < 3; ++axis) vertices.push_back((i >> axis & 1) != 0 ? 0.5 : -0.5);
    indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
}

void addTriangle(std::vector<double> &vertices, std::vector<dTriIndex> &indices) {
    vertices = {-0.5, -0.5, 0, 0.5, -0.5, 0, 0, 0.5, 0};
    indices = {0, 1, 2};
}

// --- convex geoms ------------------------------------------------------------------------------------------

struct Convex {
    std::vector<dReal> planes, points;
    std::vector<unsigned> polygons;
};

Convex boxOf(dReal x, dReal y, dReal z) {
    Convex made;
    made.planes = {1, 0, 0, x, -1, 0, 0, x, 0, 1, 0, y, 0, -1, 0, y, 0, 0, 1, z, 0, 0, -1, z};
    for (int i = 0; i < 8; ++i)
        for (const auto &[bit, half] : {std::pair<int, dReal>{1, x}, {2, y}, {4, z}}) made.points.push_back((i & bit) != 0 ? half : -half);
    made.polygons = {4, 1, 3, 7, 5, 4, 0, 4, 6, 2, 4, 2, 6, 7, 3, 4, 0, 1, 5, 4, 4, 4, 5, 7, 6, 4, 0, 2, 3, 1};
    return made;
}

Convex tetrahedron() {
    Convex made;
    const dReal h = 0.25, n = 1 / std::sqrt(dReal(3));
    made.points = {h, h, h, h, -h, -h, -h, h, -h, -h, -h, h};
    made.planes = {n, n, -n, h * n, n, -n, n, h * n, -n, n, n, h * n, -n, -n, -n, h * n};
    made.polygons = {3, 0, 1, 2, 3, 0, 3, 1, 3, 0, 2, 3, 3, 1, 3, 2};
    return made;
}

Convex &convexOf(int shape) {
    static Convex all[] = {boxOf(0.25, 0.25, 0.25), boxOf(0.5, 0.25, 0.125), tetrahedron()};
    return all[static_cast<unsigned>(shape) % 3];
}

// --- balls of the program's class -----------------------------------------------------------------------------

struct Ball {
    dReal radius;
};

dReal radiusOf(dGeomID geom) { return static_cast<Ball *>(dGeomGetClassData(geom))->radius; }

int collideBall(dGeomID o1, dGeomID o2, int, dContactGeom *contact, int) {
    reached(ShapeCallback::collider);
    const dReal *a = dGeomGetPosition(o1), *b = dGeomGetPosition(o2);
    const dReal away[] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    const dReal distance = std::sqrt(away[0] * away[0] + away[1] * away[1] + away[2] * away[2]);
    const dReal depth = radiusOf(o1) + 0.25 - distance;
    if (!(depth >= 0) || distance == 0) return 0;
    const dVector3 normal = {away[0] / distance, away[1] / distance, away[2] / distance};
    return contactHalfWay(o1, o2, normal, depth, *contact);
}

dColliderFn *colliderFor(int other) {
    return other == dSphereClass || other == dBoxClass || other == dCapsuleClass || other >= dFirstUserClass ? collideBall : nullptr;
}

void boxOfBall(dGeomID geom, dReal aabb[6]) {
    reached(ShapeCallback::box);
    const dReal *place = dGeomGetPosition(geom);
    for (int i = 0; i < 3; ++i) {
        aabb[2 * i] = place[i] - radiusOf(geom);
        aabb[2 * i + 1] = place[i] + radiusOf(geom);
    }
}

int haveEvenBits(dGeomID a, dGeomID b, dReal *) { return ((dGeomGetCategoryBits(a) ^ dGeomGetCategoryBits(b)) & 2) == 0; }

int classOfBalls(bool tested) {
    const auto make = [](dAABBTestFn *test) {
        dGeomClass functions{};
        functions.bytes = sizeof(Ball);
        functions.collider = colliderFor;
        functions.aabb = boxOfBall;
        functions.aabb_test = test;
        return dCreateGeomClass(&functions);
    };
    static const int plain = make(nullptr), testing = make(haveEvenBits);
    return tested ? testing : plain;
}

double slope(void *, int x, int z) {
    reached(ShapeCallback::height);
    return 0.125 * ((x * 3 + z * 2) % 5);
}

constexpr int kSamples = 6;  // of a height field on each side

}  // namespace

dTriMeshDataID Shapes::makeMesh(Builder builder, int shape, double size) {
    auto made = std::make_unique<Mesh>();
    constexpr decltype(&addBox) adders[] = {addOctahedron, addTerrain, addBox, addTriangle};
    adders[static_cast<unsigned>(shape) % 4](made->vertices, made->indices);
    // A mesh without extent has a box that upstream does not compute.
    const double scale = size >= 1e-3 && size <= 1e3 ? size : 1;
    for (double &value : made->vertices) value *= scale;
    made->singles.assign(made->vertices.begin(), made->vertices.end());
    // ODE's own type of vertices has a fourth number.
    for (std::size_t i = 0; i < made->vertices.size(); i += 3)
        for (std::size_t axis = 0; axis < 4; ++axis) made->padded.push_back(axis < 3 ? made->vertices[i + axis] : 0);
    const std::size_t triangles = made->indices.size() / 3;
    made->normals.assign(3 * triangles, 0);
    for (std::size_t i = 0; i < triangles; ++i) made->normals[3 * i + 2] = 1;
    made->singleNormals.assign(made->normals.begin(), made->normals.end());

    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    const auto vertices = static_cast<int>(made->vertices.size() / 3), indices = static_cast<int>(made->indices.size());
    constexpr int kDoubles = 3 * sizeof(double), kSingles = 3 * sizeof(float), kIndices = 3 * sizeof(dTriIndex);
    switch (builder) {
        case Builder::simple:
            dGeomTriMeshDataBuildSimple(data, made->padded.data(), vertices, made->indices.data(), indices);
            break;
        case Builder::simple1:
            dGeomTriMeshDataBuildSimple1(data, made->padded.data(), vertices, made->indices.data(), indices,
                                         reinterpret_cast<const int *>(made->normals.data()));
            break;
        case Builder::single:
            dGeomTriMeshDataBuildSingle(data, made->singles.data(), kSingles, vertices, made->indices.data(), indices, kIndices);
            break;
        case Builder::single1:
            dGeomTriMeshDataBuildSingle1(data, made->singles.data(), kSingles, vertices, made->indices.data(), indices, kIndices,
                                         made->singleNormals.data());
            break;
        case Builder::doubles:
            dGeomTriMeshDataBuildDouble(data, made->vertices.data(), kDoubles, vertices, made->indices.data(), indices, kIndices);
            break;
        case Builder::doubles1:
            dGeomTriMeshDataBuildDouble1(data, made->vertices.data(), kDoubles, vertices, made->indices.data(), indices, kIndices,
                                         made->normals.data());
            break;
    }
    preprocess(data, 1u << dTRIDATAPREPROCESS_BUILD_FACE_ANGLES);
    m_meshes[data] = std::move(made);
    return data;
}

void Shapes::writeVertex(dTriMeshDataID data, int vertex, int axis, double value) const {
    const auto found = m_meshes.find(data);
    if (found == m_meshes.end()) return;
    Mesh &mesh = *found->second;
    const std::size_t which = static_cast<unsigned>(vertex) % (mesh.vertices.size() / 3), along = static_cast<unsigned>(axis) % 3;
    mesh.singles[3 * which + along] = static_cast<float>(value);
    mesh.vertices[3 * which + along] = mesh.padded[4 * which + along] = value;
}

void Shapes::preprocess(dTriMeshDataID data, unsigned flags) const { dGeomTriMeshDataPreprocess2(data, flags & 3, nullptr); }

dHeightfieldDataID Shapes::makeField() {
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    auto made = std::make_unique<Heights>();
    for (int i = 0; i < kSamples * kSamples; ++i) {
        const int height = i * 7 % 5;
        made->doubles.push_back(0.125 * height);
        made->floats.push_back(0.125f * static_cast<float>(height));
        made->shorts.push_back(static_cast<short>(height));
        made->bytes.push_back(static_cast<unsigned char>(height));
    }
    m_fields[data] = std::move(made);
    return data;
}

void Shapes::buildField(dHeightfieldDataID data, Samples samples, const Field &field) {
    const auto found = m_fields.find(data);
    if (found == m_fields.end()) return;
    const Heights &heights = *found->second;
    constexpr dReal kWidth = 4;
    const auto build = [&](auto function, auto *array, double unit) {
        function(data, array, field.isCopied ? 1 : 0, kWidth, kWidth, kSamples, kSamples, unit * field.scale, field.offset,
                 field.thickness, field.isWrapped ? 1 : 0);
    };
    switch (samples) {
        case Samples::bytes:
            return build(dGeomHeightfieldDataBuildByte, heights.bytes.data(), 0.125);
        case Samples::shorts:
            return build(dGeomHeightfieldDataBuildShort, heights.shorts.data(), 0.125);
        case Samples::floats:
            return build(dGeomHeightfieldDataBuildSingle, heights.floats.data(), 1);
        case Samples::doubles:
            return build(dGeomHeightfieldDataBuildDouble, heights.doubles.data(), 1);
        case Samples::callback:
            dGeomHeightfieldDataBuildCallback(data, nullptr, slope, kWidth, kWidth, kSamples, kSamples, field.scale, field.offset,
                                              field.thickness, field.isWrapped ? 1 : 0);
    }
}

void Shapes::writeHeight(dHeightfieldDataID data, int sample, double value) const {
    const auto found = m_fields.find(data);
    if (found == m_fields.end()) return;
    Heights &heights = *found->second;
    const std::size_t place = static_cast<unsigned>(sample) % heights.doubles.size();
    heights.doubles[place] = value;
    heights.floats[place] = static_cast<float>(value);
    if (!(std::fabs(value) < 16)) return;
    heights.shorts[place] = static_cast<short>(value * 8);
    heights.bytes[place] = static_cast<unsigned char>(std::fabs(value) * 8);
}

dGeomID Shapes::makeConvex(dSpaceID space, int shape) {
    const Convex &convex = convexOf(shape);
    return dCreateConvex(space, convex.planes.data(), static_cast<unsigned>(convex.planes.size() / 4), convex.points.data(),
                         static_cast<unsigned>(convex.points.size() / 3), convex.polygons.data());
}

void Shapes::setConvex(dGeomID geom, int shape) const {
    const Convex &convex = convexOf(shape);
    dGeomSetConvex(geom, convex.planes.data(), static_cast<unsigned>(convex.planes.size() / 4), convex.points.data(),
                   static_cast<unsigned>(convex.points.size() / 3), convex.polygons.data());
}

void Shapes::writeConvexPoint(int shape, int point, int axis, double value) const {
    std::vector<dReal> &points = convexOf(shape).points;
    points[static_cast<unsigned>(point) % (points.size() / 3) * 3 + static_cast<unsigned>(axis) % 3] = static_cast<dReal>(value);
}

dGeomID Shapes::makeBall(dSpaceID space, double radius, bool tested) {
    const dGeomID geom = dCreateGeom(classOfBalls(tested));
    static_cast<Ball *>(dGeomGetClassData(geom))->radius = static_cast<dReal>(radius);
    if (space != nullptr) dSpaceAdd(space, geom);
    return geom;
}

int keepsEvenTriangles(dGeomID, dGeomID, int triangle) {
    reached(ShapeCallback::triangle);
    return triangle % 2 == 0;
}
void seesTriangles(dGeomID, dGeomID, const int *, int) { reached(ShapeCallback::triangle); }
int stopsRaysAtOddTriangles(dGeomID, dGeomID, int triangle, dReal, dReal) {
    reached(ShapeCallback::triangle);
    return triangle % 2;
}
int mergesToTheFirst(dGeomID, int first, int) {
    reached(ShapeCallback::triangle);
    return first;
}

}  // namespace fuzz
