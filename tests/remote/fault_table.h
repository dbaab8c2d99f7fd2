// What a program that harms its workers and the workers know of each other: a file that all map.
#pragma once

#include <sys/mman.h>
#include <unistd.h>

#include <atomic>

struct FaultTable {
    static constexpr unsigned kMaxWorkers = 4096;  // of one run, one after the other
    static constexpr const char *kVariable = "ODEMT_FAULT_TABLE";  // names the file

    struct Worker {
        std::atomic<int> process;
        std::atomic<unsigned> sent;      // messages
        std::atomic<unsigned> wantFlip;  // one bit of the next message is to be flipped, the one of this number; 0: none
        std::atomic<unsigned> flipped;   // messages
    };

    // Of a file that is open, and closed here. Null: it cannot be mapped.
    static FaultTable *map(int file) {
        void *const table = mmap(nullptr, sizeof(FaultTable), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
        close(file);
        return table == MAP_FAILED ? nullptr : static_cast<FaultTable *>(table);
    }

    std::atomic<unsigned> count;
    Worker workers[kMaxWorkers];
};
