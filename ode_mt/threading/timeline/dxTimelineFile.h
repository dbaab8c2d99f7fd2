// A file of trace events in JSON, as Chrome's and Perfetto's viewers read it ("Trace Event Format", Google, 2016). It is written from
// beginning to end.
//
// Numbers are whole ones, so that no locale has a say. Errors are kept: the first one is the result.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "threading/timeline/dxTimelineRing.h"

class dxTimelineFile {
public:
    // Time 0 is that of the scale. Throws std::bad_alloc.
    dxTimelineFile(const char *path, const dxTimelineScale &scale);
    ~dxTimelineFile();
    dxTimelineFile(const dxTimelineFile &) = delete;
    dxTimelineFile &operator=(const dxTimelineFile &) = delete;

    // "%p" is replaced by the number of the process. Absolute, since the process may go to another folder before the file is written.
    static std::string absolute(const char *path);

    // Records from before the start are left out. `dropped`: number of older ones that are not there any more.
    void writeThread(std::uint32_t thread, const std::string &name, const std::vector<dxTimelineRecord> &records, std::uint64_t dropped);

    // The end of the file. `unrecorded`: number of threads without a ring. Returns 0 or the first error.
    int finish(std::uint64_t dropped, unsigned unrecorded);

private:
    void writeRecord(std::uint32_t thread, const dxTimelineRecord &record);
    void writeCounters(std::uint32_t thread, const dxTimelineRecord &record);
    void writeName(const char *kind, std::uint32_t thread, const std::string &name);
    void beginEvent();
    void append(const char *format, ...) __attribute__((format(printf, 2, 3)));
    void flush();

    const dxTimelineScale m_scale;
    const long m_process;
    std::string m_buffer;
    int m_file = -1;
    std::uint64_t m_left = 0;  // bytes that may be written
    int m_error = 0;
    bool m_isFirst = true;
};
