// The objects of the process: made at their first use, once, and told when the library is closed or unloaded, the latest one first.
#include "threading/process/dxProcess.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "threading/process/dxObjectPool.h"

namespace {

std::string g_told;

template <char name>
struct Told {
    void atClose() { g_told += std::string{name, 'c', ' '}; }
    void atUnload() { g_told += std::string{name, 'u', ' '}; }
};

struct ToldOfUnloading {
    void atUnload() { g_told += "Zu "; }
};

struct NotTold {};

dxProcessObject<Told<'A'>> a;
dxProcessObject<Told<'B'>> b;
dxProcessObject<Told<'N'>> never;
dxProcessObject<ToldOfUnloading> unloading;
dxProcessObject<NotTold> notTold;

TEST(Process, TellsObjectsThatWereMadeTheLatestFirst) {
    *b, *notTold, *a, *unloading, *b;
    g_told.clear();
    dxProcess::close();
    EXPECT_EQ(g_told, "Ac Bc ");
    g_told.clear();
    dxProcess::unload();
    EXPECT_EQ(g_told, "Zu Au Bu ");
}

struct Counted {
    Counted() { ++living; }
    ~Counted() { --living; }
    static std::atomic<int> living;
};
std::atomic<int> Counted::living{0};

dxProcessObject<dxObjectPool<Counted>> pool;

TEST(Process, ClearsPools) {
    {
        const dxPooledObject<Counted> first(*pool), second(*pool);
        {
            const dxPooledObject<Counted> third(*pool);
            EXPECT_EQ(Counted::living, 3);
        }
        dxProcess::close();
        EXPECT_EQ(Counted::living, 2) << "those in use stay";
    }
    EXPECT_EQ(Counted::living, 2);
    dxProcess::unload();
    EXPECT_EQ(Counted::living, 0);
}

// The one given back last is taken first, in whatever order they were taken.
TEST(Process, APoolGivesTheObjectUsedLast) {
    Counted *outer = nullptr, *inner = nullptr;
    for (int i = 0; i < 3; ++i) {
        const dxPooledObject<Counted> first(*pool);
        const dxPooledObject<Counted> second(*pool);
        if (i == 0) outer = &*first, inner = &*second;
        EXPECT_EQ(&*first, outer);
        EXPECT_EQ(&*second, inner);
    }
    dxProcess::close();
}

struct Shared {
    Shared() { ++made; }
    static std::atomic<int> made;
};
std::atomic<int> Shared::made{0};
dxProcessObject<Shared> shared;

TEST(Process, ThreadsThatComeFirstMakeOneObject) {
    std::vector<std::thread> threads;
    std::atomic<int> ready{0};
    std::vector<Shared *> seen(4);
    for (Shared *&one : seen)
        threads.emplace_back([&one, &ready] {
            for (++ready; ready < 4;) std::this_thread::yield();
            one = &*shared;
        });
    for (std::thread &thread : threads) thread.join();
    EXPECT_EQ(Shared::made, 1);
    for (const Shared *one : seen) EXPECT_EQ(one, &*shared);
}

// Threads take and give back at once: nobody has an object that another one has, and none is lost.
TEST(Process, APoolServesManyThreads) {
    struct Owned {
        std::atomic<bool> isTaken{false};
    };
    static dxProcessObject<dxObjectPool<Owned>> owned;
    std::atomic<int> wrong{0};
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&wrong] {
            for (int round = 0; round < 20000; ++round) {
                const dxPooledObject<Owned> one(*owned);
                wrong += one->isTaken.exchange(true);
                one->isTaken = false;
            }
        });
    for (std::thread &thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
    dxProcess::close();
}

}  // namespace
