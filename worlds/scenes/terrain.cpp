#include "scenes/terrain.h"

#include <cmath>
#include <vector>

namespace scenes {

namespace {

#ifdef dDOUBLE
constexpr auto *kBuildMesh = &dGeomTriMeshDataBuildDouble;
constexpr auto *kBuildHeightField = &dGeomHeightfieldDataBuildDouble;
#else
constexpr auto *kBuildMesh = &dGeomTriMeshDataBuildSingle;
constexpr auto *kBuildHeightField = &dGeomHeightfieldDataBuildSingle;
#endif

// ODE reads vertices and indices from these arrays as long as the mesh lives.
struct Mesh {
    ~Mesh() { dGeomTriMeshDataDestroy(data); }

    dTriMeshDataID data = dGeomTriMeshDataCreate();
    std::vector<Vector3> vertices;
    std::vector<dTriIndex> indices;
};

void buildData(Mesh &mesh) {
    kBuildMesh(mesh.data, mesh.vertices.data(), sizeof(Vector3), static_cast<int>(mesh.vertices.size()),
               mesh.indices.data(), static_cast<int>(mesh.indices.size()), 3 * sizeof(dTriIndex));
}

}  // namespace

Terrain::Terrain(dReal width, dReal pitch)
    : m_pitch(pitch), m_cells(static_cast<int>(std::ceil(width / pitch))) {}

dReal Terrain::height(dReal x, dReal y) {
    const double hills = 0.5 * std::sin(0.5 * x) * std::cos(0.4 * y),
                 bumps = 0.1 * std::sin(1.3 * x + 0.9 * y);
    return static_cast<dReal>(hills + bumps);
}

dGeomID Terrain::addMesh(WorldScene &scene) const {
    const auto mesh = std::make_shared<Mesh>();
    const int samples = m_cells + 1;
    for (int row = 0; row < samples; ++row)
        for (int column = 0; column < samples; ++column) {
            const dReal x = m_pitch * column, y = m_pitch * row;
            mesh->vertices.push_back({x, y, height(x, y)});
        }
    for (int row = 0; row < m_cells; ++row)
        for (int column = 0; column < m_cells; ++column) {
            const dTriIndex corner = row * samples + column, above = corner + samples;
            mesh->indices.insert(mesh->indices.end(), {corner, corner + 1, above + 1, corner, above + 1,
                                                       above});  // from above: left
        }
    buildData(*mesh);
    scene.keep(mesh);
    return scene.add(dCreateTriMesh(scene.space(), mesh->data, nullptr, nullptr, nullptr));
}

// A height field has its heights along its own y axis and its middle at its origin. Turned by 90°
// about x its y axis is the world's z axis, and its z axis the world's -y axis.
dGeomID Terrain::addHeightField(WorldScene &scene) const {
    const int samples = m_cells + 1;
    std::vector<dReal> heights;
    for (int row = 0; row < samples; ++row)
        for (int column = 0; column < samples; ++column)
            heights.push_back(height(m_pitch * column, width() - m_pitch * row));

    const std::shared_ptr<dxHeightfieldData> data(dGeomHeightfieldDataCreate(), dGeomHeightfieldDataDestroy);
    const dReal scale = 1, offset = 0, thickness = 1;
    const int copyHeights = 1, wrap = 0;
    kBuildHeightField(data.get(), heights.data(), copyHeights, width(), width(), samples, samples, scale, offset,
                      thickness, wrap);
    scene.keep(data);
    const dGeomID geom = scene.add(dCreateHeightfield(scene.space(), data.get(), 1));
    dMatrix3 rotation;
    dRFromAxisAndAngle(rotation, 1, 0, 0, REAL(1.5707963267948966));
    dGeomSetRotation(geom, rotation);
    dGeomSetPosition(geom, width() / 2, width() / 2, 0);
    return geom;
}

}  // namespace scenes
