// What a program that harms its workers and the workers know of each other: a file that all map.
#pragma once

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

    std::atomic<unsigned> count;
    Worker workers[kMaxWorkers];
};
