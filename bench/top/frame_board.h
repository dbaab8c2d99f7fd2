// The file through which programs tell how their frames go (ode_mt/settings/dxStatisticsFile.h), from the reader's side.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <ode/ode_MT.h>

struct dxStatisticsFile;

namespace top {

struct WorldFrames {
    unsigned slot;
    std::uint32_t process;
    bool hasEnded;  // it is destroyed, or its process has ended
    dODE_MT_WorldStatistics statistics;
};

class FrameBoard {
public:
    // In memory, if the system has a place for that (/dev/shm), else in `folder`: on a disk, a program might have to wait for it.
    // Throws std::runtime_error.
    explicit FrameBoard(const std::string &folder);
    ~FrameBoard();
    FrameBoard(const FrameBoard &) = delete;
    FrameBoard &operator=(const FrameBoard &) = delete;

    const std::string &path() const { return m_path; }

    // Of all worlds with a frame, by slot.
    std::vector<WorldFrames> read() const;

    // Number of worlds for which there was no slot.
    std::uint64_t refused() const;

private:
    std::string m_path;
    dxStatisticsFile *m_file = nullptr;
};

}  // namespace top
