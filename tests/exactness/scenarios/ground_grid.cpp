#include "ground_grid.h"

#include "shapes.h"

#include <cmath>
#include <utility>

namespace exactness {

dReal waves(int x, int y) { return 0.5 + 0.3 * std::sin(0.9 * x) + 0.2 * std::cos(1.3 * y); }

GridMesh::GridMesh(Ground ground) : m_ground(std::move(ground)), m_data(dGeomTriMeshDataCreate()) {
    const int samples = m_ground.samples;
    const dReal corner = -m_ground.side() / 2;
    for (int y = 0; y < samples; ++y) {
        for (int x = 0; x < samples; ++x)
            m_corners.insert(m_corners.end(), {corner + x * m_ground.pitch, corner + y * m_ground.pitch,
                                               m_ground.height(x, y)});
    }
    for (int y = 0; y + 1 < samples; ++y) {
        for (int x = 0; x + 1 < samples; ++x) addSquare(y * samples + x);
    }
    dGeomTriMeshDataBuildDouble(m_data, m_corners.data(), 3 * sizeof(dReal),
                                static_cast<int>(m_corners.size() / 3), m_faces.data(),
                                static_cast<int>(m_faces.size()), 3 * sizeof(dTriIndex));
    prepareForConvex(m_data);
}

void GridMesh::addSquare(dTriIndex corner) {
    const dTriIndex right = corner + 1, below = corner + m_ground.samples, opposite = below + 1;
    m_faces.insert(m_faces.end(), {corner, right, opposite, corner, opposite, below});
}

void GridMesh::reshape(const std::function<dReal(int x, int y)> &height) {
    for (int i = 0; i < m_ground.samples * m_ground.samples; ++i)
        m_corners[3 * i + 2] = height(i % m_ground.samples, i / m_ground.samples);
    dGeomTriMeshDataUpdate(m_data);
}

HeightGrid::HeightGrid(Ground ground, const HeightOptions &options)
    : m_ground(std::move(ground)), m_options(options), m_data(dGeomHeightfieldDataCreate()) {
    fill();
    build();
}

dGeomID HeightGrid::createGeom(dSpaceID space) const {
    const dGeomID geom = dCreateHeightfield(space, m_data, 1);
    dMatrix3 up;
    dRFromAxisAndAngle(up, 1, 0, 0, M_PI / 2);
    dGeomSetRotation(geom, up);
    return geom;
}

void HeightGrid::reshape(const std::function<dReal(int x, int y)> &height) {
    m_ground.height = height;
    fill();
}

void HeightGrid::rebuild(const std::function<dReal(int x, int y)> &height) {
    reshape(height);
    build();
}

dReal HeightGrid::callback(void *grid, int x, int z) {
    auto *self = static_cast<HeightGrid *>(grid);
    self->m_asked.add(1000 * x + z);
    return self->m_ground.height(x, z);
}

// The numbers keep their places: the library may point to them.
void HeightGrid::fill() {
    const std::size_t count = static_cast<std::size_t>(m_ground.samples) * m_ground.samples;
    m_bytes.resize(count);
    m_shorts.resize(count);
    m_floats.resize(count);
    m_doubles.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const int x = static_cast<int>(i) % m_ground.samples, z = static_cast<int>(i) / m_ground.samples;
        const dReal number = (m_ground.height(x, z) - m_options.offset) / m_options.scale;
        if (m_options.source == HeightSource::Bytes) m_bytes[i] = static_cast<unsigned char>(number);
        if (m_options.source == HeightSource::Shorts) m_shorts[i] = static_cast<short>(number);
        m_floats[i] = static_cast<float>(number);
        m_doubles[i] = number;
    }
}

void HeightGrid::build() {
    const dReal side = m_ground.side();
    const int samples = m_ground.samples, copies = m_options.isCopied ? 1 : 0,
              wraps = m_options.repeats ? 1 : 0;
    const auto buildFrom = [&](auto build, const auto *heights) {
        build(m_data, heights, copies, side, side, samples, samples, m_options.scale, m_options.offset,
              m_options.thickness, wraps);
    };
    switch (m_options.source) {
        case HeightSource::Callback:
            dGeomHeightfieldDataBuildCallback(m_data, this, &callback, side, side, samples, samples, 1, 0,
                                              m_options.thickness, wraps);
            break;
        case HeightSource::Bytes:
            buildFrom(&dGeomHeightfieldDataBuildByte, m_bytes.data());
            break;
        case HeightSource::Shorts:
            buildFrom(&dGeomHeightfieldDataBuildShort, m_shorts.data());
            break;
        case HeightSource::Floats:
            buildFrom(&dGeomHeightfieldDataBuildSingle, m_floats.data());
            break;
        case HeightSource::Doubles:
            buildFrom(&dGeomHeightfieldDataBuildDouble, m_doubles.data());
            break;
    }
    const bool staysInBounds = m_options.isCopied && m_options.source != HeightSource::Callback;
    if (!staysInBounds) dGeomHeightfieldDataSetBounds(m_data, -3, 4);
}

}  // namespace exactness
