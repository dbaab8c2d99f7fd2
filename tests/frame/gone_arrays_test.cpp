// A program may free what a geom is made of while the geom is in a space, if it does not collide it any more: upstream then does
// not read it, and neither do workers.
//
// Covers dxConvexArrays.cpp, dxHeightField.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <sys/mman.h>

#include <cstring>
#include <vector>

#include "support/child_run.h"
#include "HeapWorld.h"
#include "OdeSession.h"

namespace {

// Memory of the program's that no process can read any more once it has gone.
class Page {
public:
    Page() : m_place(mmap(nullptr, kSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0)) {}
    ~Page() { munmap(m_place, kSize); }
    Page(const Page &) = delete;
    Page &operator=(const Page &) = delete;

    template <class Number>
    const Number *put(const std::vector<Number> &numbers) {
        char *const place = static_cast<char *>(m_place) + m_used;
        std::memcpy(place, numbers.data(), numbers.size() * sizeof(Number));
        m_used += (numbers.size() * sizeof(Number) + 15) / 16 * 16;
        return reinterpret_cast<const Number *>(place);
    }
    void goAway() const { mprotect(m_place, kSize, PROT_NONE); }

private:
    static constexpr std::size_t kSize = 1 << 16;
    void *const m_place;
    std::size_t m_used = 0;
};

// Something wide that lies in the heap, so that many pairs have it, and is there until it goes.
class Fading {
public:
    virtual ~Fading() = default;
    virtual dGeomID create(dSpaceID space) = 0;
    virtual void goAway() = 0;
};

class FadingConvex : public Fading {
public:
    dGeomID create(dSpaceID space) override {
        const dReal *const planes = m_page.put<dReal>({1, 0, 0, 3, -1, 0, 0, 3, 0, 1, 0, 3, 0, -1, 0, 3, 0, 0, 1, .05, 0, 0, -1, .05});
        const dReal *const points = m_page.put<dReal>(
            {-3, -3, -.05, 3, -3, -.05, 3, 3, -.05, -3, 3, -.05, -3, -3, .05, 3, -3, .05, 3, 3, .05, -3, 3, .05});
        const unsigned *const polygons = m_page.put<unsigned>(
            {4, 1, 2, 6, 5, 4, 0, 4, 7, 3, 4, 3, 7, 6, 2, 4, 0, 1, 5, 4, 4, 4, 5, 6, 7, 4, 0, 3, 2, 1});
        return dCreateConvex(space, planes, 6, points, 8, polygons);
    }
    void goAway() override { m_page.goAway(); }

private:
    Page m_page;
};

// The data of height fields and meshes is freed; AddressSanitizer sees who reads it.
class FadingHeights : public Fading {
public:
    FadingHeights() : m_data(dGeomHeightfieldDataCreate()) {
        const std::vector<float> samples(100, 0.02f);
        dGeomHeightfieldDataBuildSingle(m_data, samples.data(), 1, 6, 6, 10, 10, 1, 0, 1, 0);
    }
    dGeomID create(dSpaceID space) override {
        const dGeomID field = dCreateHeightfield(space, m_data, 1);
        dMatrix3 upright;
        dRFromAxisAndAngle(upright, 1, 0, 0, M_PI / 2);
        dGeomSetRotation(field, upright);
        return field;
    }
    void goAway() override { dGeomHeightfieldDataDestroy(m_data); }

private:
    const dHeightfieldDataID m_data;
};

class FadingMesh : public Fading {
public:
    FadingMesh() : m_data(dGeomTriMeshDataCreate()) {
        const double *const vertices = m_page.put<double>({-3, -3, .02, 3, -3, .02, 0, 3, .02});
        const dTriIndex *const indices = m_page.put<dTriIndex>({0, 1, 2});
        dGeomTriMeshDataBuildDouble(m_data, vertices, 3 * sizeof(double), 3, indices, 3, 3 * sizeof(dTriIndex));
    }
    dGeomID create(dSpaceID space) override { return dCreateTriMesh(space, m_data, nullptr, nullptr, nullptr); }
    void goAway() override {
        dGeomTriMeshDataDestroy(m_data);
        m_page.goAway();
    }

private:
    Page m_page;
    const dTriMeshDataID m_data;
};

struct Case {
    const char *name;
    Fading *(*make)();
    const char *policy;
};

dGeomID g_fading;
Fading *g_goesInCallback;
int g_pairs;

// From a certain pair on no callback collides it.
void collideUntilGone(HeapWorld &world, dGeomID o1, dGeomID o2) {
    constexpr int kLastPair = 40;
    const bool isFading = o1 == g_fading || o2 == g_fading;
    if (isFading && g_goesInCallback != nullptr && ++g_pairs == kLastPair) {
        g_goesInCallback->goAway();
        g_fading = nullptr;  // as if it never came again
        return;
    }
    world.makeContacts(o1, o2);
}
void leaveOut(HeapWorld &world, dGeomID o1, dGeomID o2) {
    if (dGeomGetData(o1) == nullptr && dGeomGetData(o2) == nullptr) world.makeContacts(o1, o2);
}

class GoneArrays : public testing::TestWithParam<Case> {
protected:
    static void collideAndStep(HeapWorld &world, int frames) {
        for (int i = 0; i < frames; ++i) {
            world.collide();
            world.step();
        }
    }
};

TEST_P(GoneArrays, BetweenFrames) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        dODE_MT_SetCallbackPolicy(GetParam().policy);
        Fading *const fading = GetParam().make();
        const dSpaceID space = dHashSpaceCreate(nullptr);
        const dGeomID geom = fading->create(space);
        HeapWorld world(space);
        collideAndStep(world, 5);
        const unsigned ahead = dODE_MT_GetContactsAhead();
        fading->goAway();
        int some;
        dGeomSetData(geom, &some);
        world.setCallback(leaveOut);
        collideAndStep(world, 5);
        return dODE_MT_GetContactsAhead() > ahead || std::strcmp(GetParam().policy, "serial") != 0;
    }));
}

INSTANTIATE_TEST_SUITE_P(All, GoneArrays,
                         testing::Values(Case{"convex", []() -> Fading * { return new FadingConvex; }, "serial"},
                                         Case{"heights", []() -> Fading * { return new FadingHeights; }, "serial"},
                                         Case{"heightsIfConcurrent", []() -> Fading * { return new FadingHeights; }, "concurrent"},
                                         Case{"meshIfConcurrent", []() -> Fading * { return new FadingMesh; }, "concurrent"}),
                         [](const auto &info) { return std::string(info.param.name); });

// In the midst of a call, after some of its pairs.
TEST(GoneArraysInCallbacks, PointsOfAConvexGeom) {
    EXPECT_TRUE(support::trueInChild([] {
        const OdeSession session(3, "lcp");
        FadingConvex fading;
        const dSpaceID space = dHashSpaceCreate(nullptr);
        g_fading = fading.create(space);
        const dGeomID geom = g_fading;
        HeapWorld world(space);
        for (int i = 0; i < 5; ++i) {
            world.collide();
            world.step();
        }
        g_goesInCallback = &fading;
        static dGeomID s_geom;
        s_geom = geom;
        world.setCallback([](HeapWorld &heap, dGeomID o1, dGeomID o2) {
            const bool isOfIt = o1 == s_geom || o2 == s_geom;
            if (g_fading != nullptr)
                collideUntilGone(heap, o1, o2);
            else if (!isOfIt)
                heap.makeContacts(o1, o2);
        });
        for (int i = 0; i < 5; ++i) {
            world.collide();
            world.step();
        }
        return g_fading == nullptr;
    }));
}

}  // namespace
