// Forward progress: a condition that others make true has to come true in time.
#pragma once

#include <chrono>
#include <thread>

template <class Condition>
bool comesTrue(Condition condition, std::chrono::seconds limit = std::chrono::seconds(10)) {
    const auto end = std::chrono::steady_clock::now() + limit;
    while (!condition()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::yield();
    }
    return true;
}
