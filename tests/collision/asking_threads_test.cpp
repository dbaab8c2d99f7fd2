// Rays of several threads of the program ask one space at rest, as planners and lidars do: all get the answers that a
// single thread gets, from every kind of space, from the first question on.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <ostream>
#include <string>
#include <thread>
#include <vector>

#include "OdeSession.h"
#include "sanitizers.h"

namespace {

struct Kind {
    const char *name;
    dSpaceID (*create)(dSpaceID);
};

void PrintTo(const Kind &kind, std::ostream *out) { *out << kind.name; }

dSpaceID createSweep(dSpaceID parent) { return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_XYZ); }
dSpaceID createQuadTree(dSpaceID parent) {
    const dVector3 centre = {0, 0, 0}, extents = {40, 40, 10};
    return dQuadTreeSpaceCreate(parent, centre, extents, 5);
}

constexpr int kPerSide = 24;
constexpr int kRays = kThreadSanitizer ? 60 : 400;
constexpr int kThreads = 4;

// A field of shapes of all sorts around the origin; every fourth is in a space of its own kind within the space.
class Field {
public:
    explicit Field(const Kind &kind) : m_space(kind.create(nullptr)), m_inner(kind.create(m_space)) {
        for (int y = 0; y < kPerSide; ++y)
            for (int x = 0; x < kPerSide; ++x) {
                const int i = y * kPerSide + x;
                const dGeomID geom = create(i, i % 4 == 1 ? m_inner : m_space);
                dGeomSetPosition(geom, dReal(2.5) * (x - kPerSide / 2), dReal(2.5) * (y - kPerSide / 2),
                                 dReal(0.1) * (i % 7));
            }
        dSpaceClean(m_space);
    }
    ~Field() {
        dSpaceDestroy(m_space);
        dGeomTriMeshDataDestroy(m_meshData);
    }
    Field(const Field &) = delete;
    Field &operator=(const Field &) = delete;

    dGeomID geom() const { return reinterpret_cast<dGeomID>(m_space); }

private:
    dGeomID create(int i, dSpaceID space) {
        switch (i % 6) {
        case 0: return dCreateSphere(space, dReal(0.9));
        case 1: return dCreateBox(space, 1, 2, 1);
        case 2: return dCreateCapsule(space, dReal(0.5), 1);
        case 3: return dCreateCylinder(space, dReal(0.7), 2);
        case 4: return dCreateTriMesh(space, m_meshData, nullptr, nullptr, nullptr);
        default: return dCreateConvex(space, kPlanes.data(), 4, kPoints.data(), 4, kPolygons.data());
        }
    }

    static dTriMeshDataID createMeshData() {
        const dTriMeshDataID data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(data, kPoints.data(), 3 * sizeof(dReal), 4, kTriangles.data(), 12,
                                    3 * sizeof(dTriIndex));
        return data;
    }

    static constexpr dReal kSlope = dReal(0.57735026918962576);
    static constexpr std::array<dReal, 12> kPoints{1, 1, 1, -1, -1, 1, -1, 1, -1, 1, -1, -1};
    static constexpr std::array<dReal, 16> kPlanes{-kSlope, kSlope, kSlope, kSlope, kSlope, -kSlope, kSlope, kSlope,
                                                   kSlope, kSlope, -kSlope, kSlope, -kSlope, -kSlope, -kSlope, kSlope};
    static constexpr std::array<unsigned, 16> kPolygons{3, 0, 2, 1, 3, 0, 1, 3, 3, 0, 3, 2, 3, 1, 2, 3};
    static constexpr std::array<dTriIndex, 12> kTriangles{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

    dTriMeshDataID m_meshData = createMeshData();
    dSpaceID m_space, m_inner;
};

// What a ray meets, in order: the geom and the distance.
struct Hit {
    dGeomID geom;
    dReal distance;
    bool operator==(const Hit &other) const { return geom == other.geom && distance == other.distance; }
};
using Hits = std::vector<Hit>;

void onNear(void *data, dGeomID a, dGeomID b) {
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, data, onNear);
    dContactGeom contacts[4];
    const int count = dCollide(a, b, 4, contacts, sizeof *contacts);
    for (int i = 0; i < count; ++i)
        static_cast<Hits *>(data)->push_back({dGeomGetClass(a) == dRayClass ? b : a, contacts[i].depth});
}

// What the rays of a thread see, each turned a little further than the one before.
std::vector<Hits> look(dGeomID field) {
    std::vector<Hits> seen(kRays);
    const dGeomID ray = dCreateRay(nullptr, 60);
    for (int i = 0; i < kRays; ++i) {
        const dReal angle = dReal(0.37) * i;
        dGeomRaySet(ray, dReal(0.01) * i, 0, dReal(0.3), std::cos(angle), std::sin(angle), 0);
        dSpaceCollide2(ray, field, &seen[i], onNear);
    }
    dGeomDestroy(ray);
    return seen;
}

class AskingThreads : public testing::TestWithParam<Kind> {
protected:
    OdeSession session;
};

TEST_P(AskingThreads, SeeWhatOneThreadSees) {
    const std::vector<Hits> wanted = [] {
        const Field field(GetParam());
        return look(field.geom());
    }();
    std::size_t hits = 0;
    for (const Hits &ofRay : wanted) hits += ofRay.size();
    ASSERT_GT(hits, 3u * kRays);

    for (int round = 0; round < 5; ++round) {
        const Field field(GetParam());  // never asked before
        std::vector<std::vector<Hits>> seen(kThreads);
        std::atomic<int> ready{0};
        std::vector<std::thread> askers;
        for (std::vector<Hits> &ofThread : seen)
            askers.emplace_back([&] {
                dAllocateODEDataForThread(dAllocateMaskAll);
                ++ready;
                while (ready < kThreads) std::this_thread::yield();
                ofThread = look(field.geom());
                dCleanupODEAllDataForThread();
            });
        for (std::thread &asker : askers) asker.join();
        for (const std::vector<Hits> &ofThread : seen)
            for (int i = 0; i < kRays; ++i) {
                ASSERT_EQ(ofThread[i].size(), wanted[i].size()) << "ray " << i;
                for (std::size_t hit = 0; hit < wanted[i].size(); ++hit)
                    ASSERT_EQ(ofThread[i][hit].distance, wanted[i][hit].distance) << "ray " << i << ", hit " << hit;
            }
        const std::vector<Hits> again = look(field.geom());
        for (const std::vector<Hits> &ofThread : seen) EXPECT_EQ(ofThread, again);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, AskingThreads,
                         testing::Values(Kind{"simple", dSimpleSpaceCreate}, Kind{"hash", dHashSpaceCreate},
                                         Kind{"sweep", createSweep}, Kind{"quadtree", createQuadTree}),
                         [](const auto &info) { return std::string(info.param.name); });

}  // namespace
