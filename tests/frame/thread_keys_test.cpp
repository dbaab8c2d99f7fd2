// A program that has taken all keys for thread data that a process can have: meshes are collided all the same, by several
// threads, and no memory is allocated for every pair.
//
// Covers dxThreadTrimeshCache.cpp.
#include <gtest/gtest.h>
#include <ode/ode.h>
#include <pthread.h>

#include <atomic>
#include <thread>
#include <vector>

#include "support/child_run.h"
#include "OdeSession.h"
#include "sanitizers.h"

namespace {

class MeshAndBall {
public:
    MeshAndBall() {
        static const float vertices[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0};
        static const dTriIndex indices[] = {0, 1, 2};
        m_data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSingle(m_data, vertices, 3 * sizeof(float), 3, indices, 3, 3 * sizeof(dTriIndex));
        m_mesh = dCreateTriMesh(nullptr, m_data, nullptr, nullptr, nullptr);
        m_ball = dCreateSphere(nullptr, 0.5);
    }
    ~MeshAndBall() {
        dGeomDestroy(m_ball);
        dGeomDestroy(m_mesh);
        dGeomTriMeshDataDestroy(m_data);
    }
    bool touch() const {
        dContactGeom contacts[4];
        return dCollide(m_mesh, m_ball, 4, contacts, sizeof contacts[0]) > 0;
    }

private:
    dTriMeshDataID m_data;
    dGeomID m_mesh, m_ball;
};

void takeAllKeys() {
    pthread_key_t key;
    while (pthread_key_create(&key, nullptr) == 0) continue;
}

TEST(ThreadKeys, AllTakenByTheProgram) {
    if (kThreadSanitizer) GTEST_SKIP() << "ThreadSanitizer needs a key itself to follow threads";
    EXPECT_TRUE(support::trueInChild([] {
        takeAllKeys();
        const OdeSession session;
        std::atomic<bool> good{true};
        std::vector<std::thread> threads;
        for (int i = 0; i < 4; ++i) {
            threads.emplace_back([&good] {
                const MeshAndBall pair;
                for (int k = 0; k < 1000; ++k)
                    if (!pair.touch()) good = false;
            });
        }
        for (std::thread &thread : threads) thread.join();
        return good.load();
    }));
}

// Closing gives the library's key back; it may be gone when it is wanted again.
TEST(ThreadKeys, TakenBetweenTwoUses) {
    EXPECT_TRUE(support::trueInChild([] {
        bool good;
        {
            const OdeSession session;
            good = MeshAndBall().touch();
        }
        takeAllKeys();
        for (int i = 0; i < 3; ++i) {
            const OdeSession session;
            good = good && MeshAndBall().touch();
        }
        return good;
    }));
}

}  // namespace
