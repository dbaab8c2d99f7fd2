#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"

#include <cmath>

namespace exactness {

namespace {

constexpr int samples = 33;  // along each side of a terrain
constexpr dReal side = 90;   // m
constexpr dReal cell = side / (samples - 1);

dReal heightAt(int x, int z) {
    return 0.9 + std::sin(0.9 * x) * 0.5 + std::cos(1.3 * z) * 0.4;
}  // 0 to 1.8 m

enum class Source { Callback, Bytes, Shorts, Floats, Doubles };

// Shapes that fall on a height field whose y axis is turned up.
class HeightField : public ManyParts {
public:
    HeightField(Stepper stepper, Source source) : ManyParts(stepper), m_data(dGeomHeightfieldDataCreate()) {
        buildData(source);
        const dGeomID terrain = dCreateHeightfield(space(), m_data, 1);
        dMatrix3 up;
        dRFromAxisAndAngle(up, 1, 0, 0, M_PI / 2);
        dGeomSetRotation(terrain, up);
        dGeomSetPosition(terrain, 30, 30, 0);
        add(terrain);
        addParts([this](int part, Vector3 origin) {
            int number = 0;
            for (Shape shape : allShapes)
                drop(shape, origin + Vector3{dReal(0.9) * number++, dReal(0.1) * part, 2.2});
        });
    }

    ~HeightField() override { keepUntilGeomsAreGone(m_data); }

private:
    void drop(Shape shape, Vector3 place) {
        const dBodyID body = addBody(place, world());
        const dGeomID geom = createShape(space(), shape);
        dGeomSetBody(geom, body);
        add(geom);
    }

    void keepUntilGeomsAreGone(dHeightfieldDataID data) {
        keep(std::shared_ptr<void>(
            data, [](void *p) { dGeomHeightfieldDataDestroy(static_cast<dHeightfieldDataID>(p)); }));
    }

    static dReal callback(void *scene, int x, int z) {
        static_cast<HeightField *>(scene)->m_calls++;
        return heightAt(x, z);
    }

    template <class Number>
    std::vector<Number> heights(dReal scale) const {
        std::vector<Number> values;
        for (int z = 0; z < samples; ++z) {
            for (int x = 0; x < samples; ++x) values.push_back(static_cast<Number>(heightAt(x, z) * scale));
        }
        return values;
    }

    void buildData(Source source) {
        const dReal thickness = 2;
        constexpr int copy = 1, wrap = 0;
        switch (source) {
            case Source::Callback:
                dGeomHeightfieldDataBuildCallback(m_data, this, &callback, side, side, samples, samples, 1, 0,
                                                  thickness, wrap);
                dGeomHeightfieldDataSetBounds(m_data, 0, 2);
                break;
            case Source::Bytes:
                dGeomHeightfieldDataBuildByte(m_data, heights<unsigned char>(100).data(), copy, side, side,
                                              samples, samples, 0.01, 0, thickness, wrap);
                break;
            case Source::Shorts:
                dGeomHeightfieldDataBuildShort(m_data, heights<short>(1000).data(), copy, side, side, samples,
                                               samples, 0.001, 0, thickness, wrap);
                break;
            case Source::Floats:
                dGeomHeightfieldDataBuildSingle(m_data, heights<float>(1).data(), copy, side, side, samples,
                                                samples, 1, 0.1, thickness, wrap);
                break;
            case Source::Doubles:
                dGeomHeightfieldDataBuildDouble(m_data, heights<double>(1).data(), copy, side, side, samples,
                                                samples, 1, 0, thickness, 1);
                break;
        }
    }

    dHeightfieldDataID m_data;
    long m_calls = 0;
};

// Shapes and wheels on a hilly mesh, with callbacks for its triangles, and with temporal coherence.
class MeshTerrain : public ManyParts {
public:
    explicit MeshTerrain(Stepper stepper, bool coherent) : ManyParts(stepper) {
        buildMesh();
        const dGeomID terrain = dCreateTriMesh(space(), m_data, &acceptTriangle, nullptr, &acceptRay);
        dGeomSetPosition(terrain, -15, -15, 0);
        if (coherent) {
            for (int geomClass : {dSphereClass, dBoxClass, dCapsuleClass})
                dGeomTriMeshEnableTC(terrain, geomClass, 1);
        }
        add(terrain);
        addParts([this](int part, Vector3 origin) {
            int number = 0;
            for (Shape shape : allShapes)
                drop(shape, origin + Vector3{dReal(0.9) * number++, dReal(0.1) * part, 2.2});
        });
    }

    void control() override { note("triangles asked about", static_cast<double>(m_asked)); }

private:
    void buildMesh() {
        for (int z = 0; z < samples; ++z) {
            for (int x = 0; x < samples; ++x) {
                m_corners.insert(m_corners.end(), {x * cell, z * cell, heightAt(x, z)});
            }
        }
        for (int z = 0; z + 1 < samples; ++z) {
            for (int x = 0; x + 1 < samples; ++x) addSquare(z * samples + x);
        }
        m_data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(m_data, m_corners.data(), 3 * sizeof(dReal),
                                    static_cast<int>(m_corners.size() / 3), m_faces.data(),
                                    static_cast<int>(m_faces.size()), 3 * sizeof(dTriIndex));
        prepareForConvex(m_data);
        keep(std::shared_ptr<void>(m_data,
                                   [](void *p) { dGeomTriMeshDataDestroy(static_cast<dTriMeshDataID>(p)); }));
    }

    void addSquare(dTriIndex corner) {
        const dTriIndex right = corner + 1, below = corner + samples, opposite = below + 1;
        m_faces.insert(m_faces.end(), {corner, right, opposite, corner, opposite, below});
    }

    void drop(Shape shape, Vector3 place) {
        const dBodyID body = addBody(place, world());
        const dGeomID geom = createShape(space(), shape);
        dGeomSetBody(geom, body);
        add(geom);
    }

    static int acceptTriangle(dGeomID, dGeomID, int triangle) {
        static_cast<MeshTerrain &>(living()).m_asked += triangle % 7;
        return 1;
    }

    static int acceptRay(dGeomID, dGeomID, int, dReal, dReal) { return 1; }

    std::vector<dReal> m_corners;
    std::vector<dTriIndex> m_faces;
    dTriMeshDataID m_data;
    long m_asked = 0;
};

}  // namespace

void addTerrain(Catalogue &catalogue) {
    catalogue.push_back({"terrain/heights_callback", "shapes on a height field from a callback", 60,
                         make<HeightField>(Source::Callback)});
    catalogue.push_back(
        {"terrain/heights_bytes", "shapes on a height field of bytes", 60, make<HeightField>(Source::Bytes)});
    catalogue.push_back({"terrain/heights_shorts", "shapes on a height field of shorts", 60,
                         make<HeightField>(Source::Shorts)});
    catalogue.push_back({"terrain/heights_floats", "shapes on a height field of floats", 60,
                         make<HeightField>(Source::Floats)});
    catalogue.push_back({"terrain/heights_doubles", "shapes on an infinite height field of doubles", 60,
                         make<HeightField>(Source::Doubles)});
    catalogue.push_back(
        {"terrain/mesh", "shapes on a mesh, with triangle callbacks", 60, make<MeshTerrain>(false)});
    catalogue.push_back(
        {"terrain/coherent_mesh", "shapes on a mesh with temporal coherence", 60, make<MeshTerrain>(true)});
}

}  // namespace exactness
