// The OpenMP runtime of the compiler that built this library: GNU's libgomp, or LLVM's libomp. It is loaded when somebody asks
// for its threads, so that the library does without it: a runtime reads the environment when it is loaded, and may bind the thread
// that loads it (docs/limits.md). A program that uses the same runtime shares it.
//
// Once loaded it stays until the process ends, since idle threads of it may sleep in its code.
//
// Functions are called by name: a directive (#pragma omp) would link the runtime. GOMP_parallel is what g++ compiles a parallel
// region to, and part of the interface of both.
#pragma once

#include <optional>

class dxOpenMPRuntime {
public:
    // Empty where the dynamic loader does not find it.
    static std::optional<dxOpenMPRuntime> load();

    // The file name that the dynamic loader looks for.
    static const char *fileName();

    // Calls body(data) on `threads` threads, the calling one included, and waits for all of them. Requires prepareRegions().
    void parallel(void (*body)(void *), void *data, unsigned threads) const { m_parallel(body, data, threads, 0); }

    // Number of the calling thread in its region, from 0 on.
    unsigned threadNumber() const { return static_cast<unsigned>(m_threadNumber()); }

    // What the runtimes do differently follows. CMake compiles the file for the runtime in use.

    // Called by the thread that is about to open a parallel region.
    void prepareRegions() const;

    // Ends the idle threads of the calling thread's pool; false if the runtime cannot, as inside a region.
    bool endThreads() const;

    // Called in the parent before fork; false if a parallel region in the child could hang.
    bool prepareFork() const;

private:
    dxOpenMPRuntime() = default;

    void (*m_parallel)(void (*body)(void *), void *data, unsigned threads, unsigned flags) = nullptr;
    int (*m_threadNumber)() = nullptr;
    int (*m_inParallel)() = nullptr;
    int (*m_pauseAll)(int kind) = nullptr;
    void (*m_setBlockTime)(int milliseconds) = nullptr;  // libomp's own; null: libgomp
};
