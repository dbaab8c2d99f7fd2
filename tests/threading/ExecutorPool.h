// Threads of a program with a queue of what they are to call: an executor as dODE_MT_SetExecutor takes it.
#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

class ExecutorPool {
public:
    using Work = void (*)(void *data);

    explicit ExecutorPool(unsigned threads) {
        for (unsigned i = 0; i < threads; ++i) m_threads.emplace_back([this] { serve(); });
    }
    // What waits is called before.
    ~ExecutorPool() {
        {
            const std::lock_guard<std::mutex> hold(m_mutex);
            m_isEnding = true;
        }
        m_changed.notify_all();
        for (std::thread &thread : m_threads) thread.join();
    }

    static void post(void *pool, Work work, void *data) {
        ExecutorPool &own = *static_cast<ExecutorPool *>(pool);
        {
            const std::lock_guard<std::mutex> hold(own.m_mutex);
            own.m_queue.push_back({work, data});
            if (own.m_queue.size() > own.m_longestQueue) own.m_longestQueue = own.m_queue.size();
            ++own.m_posted;
        }
        own.m_changed.notify_one();
    }

    unsigned posted() {
        const std::lock_guard<std::mutex> hold(m_mutex);
        return m_posted;
    }
    std::size_t longestQueue() {
        const std::lock_guard<std::mutex> hold(m_mutex);
        return m_longestQueue;
    }
    unsigned mostAtOnce() {
        const std::lock_guard<std::mutex> hold(m_mutex);
        return m_mostAtOnce;
    }

    static bool isOne() { return isOneOfThem(); }  // the calling thread

private:
    struct Call {
        Work work;
        void *data;
    };

    static bool &isOneOfThem() {
        static thread_local bool is = false;
        return is;
    }

    void serve() {
        isOneOfThem() = true;
        std::unique_lock<std::mutex> hold(m_mutex);
        for (;;) {
            m_changed.wait(hold, [this] { return m_isEnding || !m_queue.empty(); });
            if (m_queue.empty()) return;
            const Call call = m_queue.front();
            m_queue.pop_front();
            if (++m_atOnce > m_mostAtOnce) m_mostAtOnce = m_atOnce;
            hold.unlock();
            call.work(call.data);
            hold.lock();
            --m_atOnce;
        }
    }

    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<Call> m_queue;
    std::size_t m_longestQueue = 0;
    unsigned m_posted = 0, m_atOnce = 0, m_mostAtOnce = 0;
    bool m_isEnding = false;
    std::vector<std::thread> m_threads;
};
