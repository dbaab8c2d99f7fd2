// Meshes collided by several threads of the user at once: each thread has scratch data of its own.
//
// Covers dxThreadTrimeshCache.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cmath>
#include <memory>
#include <thread>
#include <vector>

#include "OdeSession.h"

namespace {

constexpr unsigned kSide = 12;  // vertices along an edge of the terrain, 1 m apart

// A wavy sheet of triangles.
class Sheet {
public:
    Sheet() : m_data(dGeomTriMeshDataCreate()) {
        for (unsigned y = 0; y < kSide; ++y) {
            for (unsigned x = 0; x < kSide; ++x) {
                for (const double value : {x - 5.5, y - 5.5, 0.3 * std::sin(1.3 * x) * std::cos(0.9 * y)}) {
                    m_vertices.push_back(static_cast<float>(value));
                }
                m_vertices.push_back(0);
            }
        }
        for (unsigned y = 0; y + 1 < kSide; ++y) {
            for (unsigned x = 0; x + 1 < kSide; ++x) {
                const dTriIndex a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
                m_indices.insert(m_indices.end(), {a, b, d, a, d, c});
            }
        }
        dGeomTriMeshDataBuildSingle(m_data, m_vertices.data(), 4 * sizeof(float), kSide * kSide,
                                    m_indices.data(), m_indices.size(), 3 * sizeof(dTriIndex));
    }
    ~Sheet() { dGeomTriMeshDataDestroy(m_data); }
    Sheet(const Sheet &) = delete;
    Sheet &operator=(const Sheet &) = delete;

    dTriMeshDataID data() const { return m_data; }

private:
    dTriMeshDataID m_data;
    std::vector<float> m_vertices;
    std::vector<dTriIndex> m_indices;
};

// One geom of every kind that meets the sheet.
class Visitors {
public:
    explicit Visitors(const Sheet &sheet)
        : m_sheet(dCreateTriMesh(nullptr, sheet.data(), nullptr, nullptr, nullptr)),
          m_geoms{dCreateBox(nullptr, 1, 2, 1),
                  dCreateSphere(nullptr, 1),
                  dCreateCapsule(nullptr, 0.4, 2),
                  dCreateCylinder(nullptr, 0.4, 2),
                  dCreatePlane(nullptr, 0, 0, 1, 0.1),
                  dCreateRay(nullptr, 3),
                  dCreateTriMesh(nullptr, sheet.data(), nullptr, nullptr, nullptr)} {}
    ~Visitors() {
        for (const dGeomID geom : m_geoms) dGeomDestroy(geom);
        dGeomDestroy(m_sheet);
    }
    Visitors(const Visitors &) = delete;
    Visitors &operator=(const Visitors &) = delete;

    // Contact points, normals and depths of all of them in ten poses.
    std::vector<dReal> collide() const {
        std::vector<dReal> numbers;
        for (unsigned pose = 0; pose < 10; ++pose) {
            for (const dGeomID geom : m_geoms) {
                place(geom, pose);
                meet(geom, numbers);
            }
        }
        return numbers;
    }

private:
    static void place(dGeomID geom, unsigned pose) {
        if (dGeomGetClass(geom) == dPlaneClass) return;
        if (dGeomGetClass(geom) == dRayClass) {
            dGeomRaySet(geom, 0.4 * pose - 2, 0.3, 1, 0, 0.1, -1);
            return;
        }
        dMatrix3 rotation;
        dRFromEulerAngles(rotation, 0.3 * pose, 0.1 * pose, 0.2);
        dGeomSetPosition(geom, 0.5 * pose - 2, 0.3 * pose - 1, 0.1);
        dGeomSetRotation(geom, rotation);
    }

    void meet(dGeomID geom, std::vector<dReal> &numbers) const {
        dContactGeom contacts[32];
        const int count = dCollide(m_sheet, geom, 32, contacts, sizeof contacts[0]);
        numbers.push_back(count);
        for (int i = 0; i < count; ++i) {
            numbers.insert(numbers.end(), contacts[i].pos, contacts[i].pos + 3);
            numbers.insert(numbers.end(), contacts[i].normal, contacts[i].normal + 3);
            numbers.push_back(contacts[i].depth);
        }
    }

    dGeomID m_sheet;
    std::vector<dGeomID> m_geoms;
};

TEST(TrimeshThreads, ContactsAreThoseOfOneThread) {
    constexpr unsigned kThreads = 6, kRepetitions = 20;
    const OdeSession session;
    const Sheet sheet;
    const std::vector<dReal> alone = Visitors(sheet).collide();
    ASSERT_GT(alone.size(), 1000u) << "hardly a contact";
    std::vector<std::unique_ptr<Visitors>> visitors;
    for (unsigned t = 0; t < kThreads; ++t) visitors.push_back(std::make_unique<Visitors>(sheet));
    bool same[kThreads] = {};
    std::vector<std::thread> threads;
    for (unsigned t = 0; t < kThreads; ++t) {
        threads.emplace_back([&own = *visitors[t], &result = same[t], &alone] {
            dAllocateODEDataForThread(dAllocateMaskAll);
            result = true;
            for (unsigned i = 0; i < kRepetitions; ++i) result = result && own.collide() == alone;
            dCleanupODEAllDataForThread();
        });
    }
    for (std::thread &thread : threads) thread.join();
    for (const bool result : same) EXPECT_TRUE(result);
}

TEST(TrimeshThreads, CollideAgainAfterClosing) {
    std::vector<dReal> before;
    for (int i = 0; i < 3; ++i) {
        const OdeSession session;
        const Sheet sheet;
        const std::vector<dReal> numbers = Visitors(sheet).collide();
        if (i > 0) {
            EXPECT_EQ(numbers, before);
        }
        before = numbers;
    }
}

}  // namespace
