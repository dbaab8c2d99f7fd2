// All rings of the process, and the file of its trace. dxTimeline decides when something is recorded.
//
// Rings of threads that have ended keep their events until kKeptRings threads have come; then they are given to new ones, the oldest first.
//
// Threading: any thread; one lock is held for all that is done here, also while the file is written. It is held across fork.
#pragma once

#include <pthread.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "threading/process/dxFork.h"
#include "threading/timeline/dxTimelineRing.h"

class dxTimelineRings : private dxForkListener {
public:
    dxTimelineRings() { listenToForks(); }

    // These return 0 or an error number of the system. What was recorded before is forgotten, but not by flush().
    int start(const char *path);
    int flush();
    void stop();

    // Threads get rings from here on, whether there is a file or not.
    void startCounting();

    // Null: nothing is recorded, no memory, or too many threads.
    dxTimelineRing *give();

    // From here on nothing of the library is called when a thread ends. Rings stay whose threads may be in the middle of an event.
    void unload();

    void copyPath(char *text, std::size_t size);

    // The thread with this ring, the calling one, ends.
    void end(const dxTimelineRing *ring);

private:
    static constexpr std::size_t kKeptRings = 64;

    // Threads beyond are not recorded: where the program has taken all keys, nothing tells that a thread has ended.
    static constexpr std::size_t kMaxRings = 2048;

    struct Owned {
        dxTimelineRing *ring;
        std::string name;      // of its thread
        std::uint64_t number;  // of the thread, in the order of their first events
        bool hasEnded;
    };

    class Hold;

    void forget();
    void createKey();
    Owned *findEnded();
    Owned *add();
    int write();
    static void threadEnds(void *ring);
    void inForkedChild() override;

    dxForkSafeMutex m_mutex;
    std::vector<Owned> m_rings;
    std::vector<dxTimelineRecord> m_records;  // of one thread, while the file is written
    std::string m_path;                       // empty: there is no trace
    bool m_isCounting = false;
    dxTimelineScale m_scale;
    std::uint64_t m_given = 0;
    std::uint64_t m_lost = 0;  // events of threads whose rings others have got
    unsigned m_refused = 0;    // threads without a ring
    std::optional<pthread_key_t> m_key;
};
