#include "remote/worker/dxWorkRecord.h"

#include <fcntl.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

#include "remote/islands/dxPackedProblem.h"
#include "remote/coordinator/dxRemoteProblem.h"

namespace {

double processorNs() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e9 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec);
}

}  // namespace

std::unique_ptr<dxWorkRecord> dxWorkRecord::open(const std::string &file, dxRemoteTransport &below, std::string &reason) {
    constexpr mode_t kReadableByAll = 0644;
    const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, kReadableByAll);
    if (opened >= 0) return std::unique_ptr<dxWorkRecord>(new dxWorkRecord(opened, below));
    reason = file + ": " + std::strerror(errno);
    return nullptr;
}

dxWorkRecord::~dxWorkRecord() { ::close(m_file); }

dxRemoteServer::Solve dxWorkRecord::timed(dxRemoteServer::Solve solve) {
    return [this, solve = std::move(solve)](const std::byte *problem, std::size_t bytes, dxRemoteBytes &result) {
        const double begin = processorNs();
        solve(problem, bytes, result);
        Solved solved{0, 0, 0, bytes, result.size(), processorNs() - begin};
        if (dxPackedProblem packed; packed.read(problem, bytes)) {
            solved.bodies = packed.counts.bodies;
            solved.joints = packed.counts.joints;
            solved.rows = packed.counts.rows;
        }
        m_solved.push_back(solved);
    };
}

bool dxWorkRecord::send(unsigned link, const void *message, std::size_t bytes) {
    if (!m_solved.empty()) {
        const auto *const from = static_cast<const std::byte *>(message);
        const dxRemoteBytes copy(from, from + bytes);
        if (dxReadHeader(copy).kind == static_cast<std::uint16_t>(dxRemoteKind::Results)) note(copy);
    }
    return m_below.send(link, message, bytes);
}

// Whole lines by one call: those of other workers come before or after them. A file that is full ends the record, not the worker.
void dxWorkRecord::note(const dxRemoteBytes &results) {
    std::string text;
    std::size_t index = 0;
    for (dxRemoteItems item(results); index < m_solved.size() && item.next(); ++index) {
        const Solved &one = m_solved[index];
        char line[200];
        std::snprintf(line, sizeof line, "%llu %u %u %u %u %zu %.0f %zu\n", static_cast<unsigned long long>(dxRemoteBatchOf(item.number())),
                      dxRemoteIndexOf(item.number()), one.bodies, one.joints, one.rows, one.bytes, one.ns, one.resultBytes);
        text += line;
    }
    m_solved.clear();
    if (write(m_file, text.data(), text.size()) < 0) return;
}
