// The file by which a process shares statistics of its frames: odemt_top makes it, and ODE_MT_STATISTICS names it. Both processes map it into
// memory, so that neither waits for the other, and the contents remain after either has ended. bench/top includes this header, too.
//
// The file has a header and slots of fixed size: one for each world that is stepped, of any process that has the file, until all are taken. A process
// claims a slot by its number. A slot is consistent while its sequence is even (a seqlock; H.-J. Boehm, "Can seqlocks get along with programming
// language memory models?", 2012).
//
// Threading: a slot is written by one thread at a time and read by any process.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <ode/ode_MT.h>

struct dxStatisticsSlot {
    static constexpr std::size_t kWords = sizeof(dODE_MT_WorldStatistics) / sizeof(std::uint64_t);
    static_assert(sizeof(dODE_MT_WorldStatistics) % sizeof(std::uint64_t) == 0, "whole words");

    std::atomic<std::uint32_t> owner;    // number of the process; 0: free
    std::atomic<std::uint32_t> hasEnded;  // the world is destroyed; the slot may be claimed again
    std::atomic<std::uint64_t> sequence;
    std::array<std::atomic<std::uint64_t>, kWords> words;

    // The owner, one thread at a time.
    void write(const dODE_MT_WorldStatistics &statistics) {
        std::uint64_t values[kWords];
        std::memcpy(values, &statistics, sizeof values);
        const std::uint64_t now = sequence.load(std::memory_order_relaxed) | 1;  // odd also where an owner has died while it wrote
        sequence.store(now, std::memory_order_relaxed);
        std::atomic_thread_fence(std::memory_order_release);
        for (std::size_t i = 0; i < kWords; ++i) words[i].store(values[i], std::memory_order_relaxed);
        sequence.store(now + 1, std::memory_order_release);
    }

    // Returns false if the slot is being written.
    bool read(dODE_MT_WorldStatistics &statistics) const {
        std::uint64_t values[kWords];
        const std::uint64_t before = sequence.load(std::memory_order_acquire);
        for (std::size_t i = 0; i < kWords; ++i) values[i] = words[i].load(std::memory_order_relaxed);
        std::atomic_thread_fence(std::memory_order_acquire);
        if (before % 2 != 0 || sequence.load(std::memory_order_relaxed) != before) return false;
        std::memcpy(&statistics, values, sizeof values);
        return true;
    }
};

struct dxStatisticsFile {
    static constexpr std::uint64_t kMagic = 0x6f64656d74746f70;  // "odemttop"
    static constexpr std::uint32_t kSlots = 256;

    std::uint64_t magic;
    std::uint32_t slotBytes;  // tells versions apart
    std::uint32_t slotCount;
    std::atomic<std::uint64_t> refused;  // worlds without a slot
    dxStatisticsSlot slots[kSlots];

    bool isOfThisVersion() const { return magic == kMagic && slotBytes == sizeof(dxStatisticsSlot) && slotCount == kSlots; }
};
static_assert(std::atomic<std::uint64_t>::is_always_lock_free, "shared by processes");

// This process's slots of the file that ODE_MT_STATISTICS names. Threading: under the lock of dxWorldStatistics.
class dxStatisticsSharing {
public:
    // Returns a slot for a new world; null: there is no file, or no free slot in it.
    dxStatisticsSlot *claim();

    static void giveBack(dxStatisticsSlot *slot);

    // Returns, once, why the file cannot be used; empty: it can, or the reason was returned before.
    const char *takeComplaint();

    void close();

private:
    void open();

    dxStatisticsFile *m_file = nullptr;
    bool m_isOpened = false;  // or was tried to
    char m_complaint[400] = "";
    bool m_hasComplaint = false;
};
