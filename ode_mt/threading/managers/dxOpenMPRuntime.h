// The OpenMP runtime of the compiler that built this library: GNU's libgomp, or LLVM's libomp. It is loaded when the program asks for its threads, so
// that the library works without it: a runtime reads the environment when it is loaded, and may bind the thread that loads it (docs/limits.md). A
// program that uses the same runtime shares it.
//
// Once loaded it stays until the process ends, since idle threads of it may sleep in its code.
//
// Functions are called by name: a directive (#pragma omp) would link the runtime. GOMP_parallel is what g++ compiles a parallel region to, and part
// of the interface of both.
//
// libgomp (gcc). Idle threads: after a region a thread spins for 300,000 pauses (about 7 ms at 2.6 GHz), then sleeps; with more threads than
// processors it spins for 1000. Only the environment, read when the runtime is loaded, changes that (OMP_WAIT_POLICY=passive). Fork: the child
// inherits a pool whose threads do not exist, and hangs in its next region. Without a pool at the time of the fork the child makes one of its own.
//
// libomp (clang). Idle threads: a thread spins for 200 ms after a region unless the blocktime is 0. End of threads: omp_pause_resource_all ends them,
// but the next region then aborts (libomp 14: "Thread identifier invalid"), so they stay, asleep, until the process ends. Fork: libomp has handlers
// of its own.
//
// Threading: any thread.
#pragma once

#include <optional>

class dxOpenMPRuntime {
public:
    // Returns none where the dynamic loader does not find it.
    static std::optional<dxOpenMPRuntime> load();

    // Returns the file name that the dynamic loader looks for.
    static const char *fileName();

    // Calls body(data) on `threads` threads, the calling one included, and waits for all of them. Requires prepareRegions().
    void parallel(void (*body)(void *), void *data, unsigned threads) const { m_parallel(body, data, threads, 0); }

    // Returns the number of the calling thread in its region, from 0 on.
    unsigned threadNumber() const { return static_cast<unsigned>(m_threadNumber()); }

    // Called by the thread that is about to open a parallel region.
    void prepareRegions() const;

    // Ends the idle threads of the calling thread's pool. Returns false if the runtime cannot, as inside a region.
    bool endThreads() const;

    // Called in the parent before fork. Returns false if a parallel region in the child could hang.
    bool prepareFork() const;

private:
    dxOpenMPRuntime() = default;

    void (*m_parallel)(void (*body)(void *), void *data, unsigned threads, unsigned flags) = nullptr;
    int (*m_threadNumber)() = nullptr;
    int (*m_inParallel)() = nullptr;
    int (*m_pauseAll)(int kind) = nullptr;
    void (*m_setBlockTime)(int milliseconds) = nullptr;  // libomp's own; null: libgomp
};
