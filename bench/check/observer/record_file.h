// The record of this process: a file that is mapped into memory, so that what is written is there after a crash, and no file
// descriptor stays open that the program might close.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "ode_library.h"
#include "record_format.h"

namespace observer {

class RecordFile {
public:
    // Does nothing if it is open. Without a folder, or rights or room in it, nothing is recorded.
    void open(const OdeLibrary &library);
    void setHasOneMaker(bool hasOneMaker);
    void write(const check::Step &step);
    void writeStates(const std::vector<unsigned char> &states);
    void addTimes(std::chrono::nanoseconds step, std::chrono::nanoseconds observer);

    // In the child of a fork: the next open() makes a file of this process's own.
    void leaveToParent();

private:
    void mapNext();

    bool m_isOpen = false;
    std::uint32_t m_number = check::kNoProcess, m_parent = check::kNoProcess;
    std::string m_path;
    check::ProcessHeader *m_header = nullptr;
    check::Step *m_chunk = nullptr;
    std::uint64_t m_chunks = 0, m_left = 0;  // chunks that were mapped, steps that the last one has room for
};

// Leaves the sign that the observer was loaded.
void markLoaded();

// Adds the objects of this process, its program first, to the list.
void listObjects();

}  // namespace observer
