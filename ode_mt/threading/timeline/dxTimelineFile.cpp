#include "threading/timeline/dxTimelineFile.h"

#include <fcntl.h>
#include <ode/ode_MT.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cinttypes>
#include <cstdarg>
#include <cstddef>
#include <cstdio>

namespace {

constexpr std::size_t kBufferSize = 1 << 16, kMaxAppended = 512;

// Names of threads may be anything: what is no plain ASCII is replaced.
std::string quoted(const std::string &text) {
    std::string result = "\"";
    for (const char c : text) {
        const bool isPlain = c >= 0x20 && c < 0x7f;
        if (c == '"' || c == '\\') result += '\\';
        result += isPlain ? c : '?';
    }
    return result + '"';
}

// A time in 1/64 us, rounded down. Viewers add times and lengths up as floating-point numbers: fractions of a power of two have exact sums,
// so what ends when something else begins or ends does so in the viewer, too, and no event reaches out of the one that it is within.
constexpr unsigned kTicksPerMicrosecond = 64;

std::uint64_t ticksOf(std::uint64_t ns) { return ns / 1000 * kTicksPerMicrosecond + ns % 1000 * kTicksPerMicrosecond / 1000; }

// Of a time or a length in microseconds; its six digits behind the point are all there are.
struct Microseconds {
    explicit Microseconds(std::uint64_t ticks)
        : whole(ticks / kTicksPerMicrosecond), millionths(static_cast<unsigned>(ticks % kTicksPerMicrosecond) * (1000000 / kTicksPerMicrosecond)) {}
    const std::uint64_t whole;
    const unsigned millionths;
};

// Bytes that the process may write to a new file: a further one would end it (SIGXFSZ).
std::uint64_t spaceFor(int file) {
    struct stat status;
    rlimit limit;
    const bool isLimited =
        fstat(file, &status) == 0 && S_ISREG(status.st_mode) && getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return isLimited ? limit.rlim_cur : UINT64_MAX;
}

}  // namespace

dxTimelineFile::dxTimelineFile(const char *path, const dxTimelineScale &scale) : m_scale(scale), m_process(getpid()) {
    m_buffer.reserve(kBufferSize + kMaxAppended);
    m_file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOCTTY | O_NONBLOCK, 0666);
    if (m_file < 0) m_error = errno;
    m_left = spaceFor(m_file);
    append("{\"displayTimeUnit\":\"ns\",\"traceEvents\":[");
}

dxTimelineFile::~dxTimelineFile() {
    if (m_file >= 0) close(m_file);
}

std::string dxTimelineFile::absolute(const char *path) {
    std::string file;
    for (const char *c = path; *c != '\0'; ++c) {
        if (c[0] == '%' && c[1] == 'p') {
            file += std::to_string(getpid());
            ++c;
        } else {
            file += *c;
        }
    }
    char folder[PATH_MAX];
    if (file.empty() || file.front() == '/' || getcwd(folder, sizeof folder) == nullptr) return file;
    return std::string(folder) + "/" + file;
}

void dxTimelineFile::writeThread(std::uint32_t thread, const std::string &name, const std::vector<dxTimelineRecord> &records,
                                 std::uint64_t dropped) {
    writeName("thread_name", thread, name);
    if (dropped > 0 && !records.empty()) {
        const Microseconds time(ticksOf(m_scale.timeOf(records.front().end)));
        beginEvent();
        append("{\"name\":\"older events dropped\",\"cat\":\"timeline\",\"ph\":\"i\",\"s\":\"t\",\"pid\":%ld,\"tid\":%u,\"ts\":%" PRIu64
               ".%06u,\"args\":{\"dropped\":%" PRIu64 "}}",
               m_process, thread, time.whole, time.millionths, dropped);
    }
    for (const dxTimelineRecord &record : records) {
        if (m_scale.isBefore(record.begin)) continue;
        if (record.event->kind == dxTimelineEvent::Kind::Counter)
            writeCounters(thread, record);
        else
            writeRecord(thread, record);
    }
}

void dxTimelineFile::writeRecord(std::uint32_t thread, const dxTimelineRecord &record) {
    // Counters of two processors may differ a little.
    const std::uint64_t begin = ticksOf(m_scale.timeOf(record.begin)), end = std::max(begin, ticksOf(m_scale.timeOf(record.end)));
    const Microseconds time(begin), length(end - begin);
    beginEvent();
    append("{\"name\":\"%s\",\"cat\":\"%s\",\"ph\":\"X\",\"pid\":%ld,\"tid\":%u,\"ts\":%" PRIu64 ".%06u,\"dur\":%" PRIu64
           ".%06u,\"args\":{",
           record.event->name, record.event->category, m_process, thread, time.whole, time.millionths, length.whole,
           length.millionths);
    if (record.event->kind == dxTimelineEvent::Kind::Span) append("\"frame\":%u,\"caller\":%u", record.frame, record.caller);
    for (std::size_t i = 0; i < record.arguments.size() && record.event->arguments[i] != nullptr; ++i)
        append(",\"%s\":%" PRIu64, record.event->arguments[i], record.arguments[i]);
    append("}}");
}

// Viewers draw a curve for each name and id.
void dxTimelineFile::writeCounters(std::uint32_t thread, const dxTimelineRecord &record) {
    const Microseconds time(ticksOf(m_scale.timeOf(record.begin)));
    for (std::size_t i = 0; i < record.arguments.size() && record.event->arguments[i] != nullptr; ++i) {
        const char *const name = record.event->arguments[i];
        beginEvent();
        append("{\"name\":\"%s\",\"cat\":\"%s\",\"ph\":\"C\",\"pid\":%ld,\"tid\":%u,\"id\":%u,\"ts\":%" PRIu64
               ".%06u,\"args\":{\"%s\":%" PRIu64 "}}",
               name, record.event->category, m_process, thread, thread, time.whole, time.millionths, name, record.arguments[i]);
    }
}

void dxTimelineFile::writeName(const char *kind, std::uint32_t thread, const std::string &name) {
    beginEvent();
    append("{\"name\":\"%s\",\"ph\":\"M\",\"pid\":%ld,\"tid\":%u,\"args\":{\"name\":%s}}", kind, m_process, thread, quoted(name).c_str());
}

int dxTimelineFile::finish(std::uint64_t dropped, unsigned unrecorded) {
    writeName("process_name", static_cast<std::uint32_t>(m_process), "ODE_MT");
    append("\n],\"otherData\":{\"writer\":\"ODE_MT %s\",\"eventsDropped\":%" PRIu64 ",\"threadsNotRecorded\":%u}}\n", dODE_MT_VERSION,
           dropped, unrecorded);
    flush();
    if (m_file >= 0 && close(m_file) != 0 && m_error == 0) m_error = errno;
    m_file = -1;
    return m_error;
}

void dxTimelineFile::beginEvent() {
    append(m_isFirst ? "\n" : ",\n");
    m_isFirst = false;
}

void dxTimelineFile::append(const char *format, ...) {
    char text[kMaxAppended];
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    m_buffer += text;
    if (m_buffer.size() >= kBufferSize) flush();
}

void dxTimelineFile::flush() {
    std::size_t done = 0;
    while (m_error == 0 && done < m_buffer.size()) {
        if (m_left == 0) {
            m_error = EFBIG;
            break;
        }
        const ssize_t written = write(m_file, m_buffer.data() + done, std::min<std::uint64_t>(m_buffer.size() - done, m_left));
        if (written >= 0) {
            done += static_cast<std::size_t>(written);
            m_left -= static_cast<std::uint64_t>(written);
        } else if (errno != EINTR) {
            m_error = errno;
        }
    }
    m_buffer.clear();
}
