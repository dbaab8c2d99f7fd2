#include "result_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "support/text_file.h"

namespace bench {

namespace {

namespace fs = std::filesystem;

// The name of a temporary file may be no longer than that of its file.
constexpr std::size_t kMaxStem = 200;

[[noreturn]] void fail(const std::string &file, const std::string &reason) {
    throw std::runtime_error("cannot write '" + file + "': " + reason);
}

bool isSpecial(const fs::path &path) {
    struct stat status {};
    return stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

// A pipe may have no reader, and opening it would block.
bool isNamedPipe(const fs::path &path) {
    struct stat status {};
    std::error_code none;
    return stat(path.c_str(), &status) == 0 && S_ISFIFO(status.st_mode) && fs::exists(fs::canonical(path, none), none);
}

// The file that a chain of symbolic links ends at, so that a link stays a link.
fs::path target(const std::string &file) {
    std::error_code error;
    if (isSpecial(file)) return file;  // what /dev/stdout leads to may have no name of its own
    const fs::path absolute = fs::absolute(file, error);
    const fs::path path = error ? fs::path() : fs::weakly_canonical(absolute, error);
    if (error) fail(file, error.message());
    // A link that leads nowhere yet is not followed by weakly_canonical.
    if (fs::is_symlink(fs::symlink_status(path, error))) {
        const fs::path next = fs::read_symlink(path, error);
        return fs::weakly_canonical(next.is_absolute() ? next : path.parent_path() / next, error);
    }
    return path;
}

// A file that is removed unless it has taken its final name.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path &target)
        : m_name((target.parent_path() / target.filename().string().substr(0, kMaxStem)).string() + ".XXXXXX") {
        m_file = mkostemp(m_name.data(), O_CLOEXEC);
    }
    ~TemporaryFile() {
        if (m_file >= 0) close(m_file);
        if (!m_renamed && m_file != kNone) unlink(m_name.c_str());
    }
    TemporaryFile(const TemporaryFile &) = delete;
    TemporaryFile &operator=(const TemporaryFile &) = delete;

    bool isOpen() const { return m_file >= 0; }
    int descriptor() const { return m_file; }
    bool rename(const fs::path &target) {
        struct stat old {};
        const mode_t mask = umask(0);
        umask(mask);
        const mode_t mode = stat(target.c_str(), &old) == 0 ? old.st_mode & 07777 : 0666 & ~mask;
        m_renamed = fchmod(m_file, mode) == 0 && fsync(m_file) == 0 &&
                    std::rename(m_name.c_str(), target.c_str()) == 0;
        return m_renamed;
    }

private:
    static constexpr int kNone = -1;
    std::string m_name;
    int m_file = kNone;
    bool m_renamed = false;
};

// What has no name to take.
class SpecialFile {
public:
    explicit SpecialFile(const fs::path &path) : m_file(open(path.c_str(), O_WRONLY | O_CLOEXEC)) {}
    ~SpecialFile() {
        if (m_file >= 0) close(m_file);
    }
    SpecialFile(const SpecialFile &) = delete;
    SpecialFile &operator=(const SpecialFile &) = delete;

    int descriptor() const { return m_file; }
    bool finish() { return close(std::exchange(m_file, -1)) == 0; }

private:
    int m_file;
};

}  // namespace

class ResultStream::Target {
public:
    explicit Target(const fs::path &path) : m_path(path) {
        if (isSpecial(path))
            m_special.emplace(path);
        else
            m_fresh.emplace(path);
    }

    int descriptor() const { return m_fresh ? m_fresh->descriptor() : m_special->descriptor(); }
    bool finish() { return m_fresh ? m_fresh->rename(m_path) : m_special->finish(); }

private:
    const fs::path m_path;
    std::optional<TemporaryFile> m_fresh;
    std::optional<SpecialFile> m_special;
};

ResultStream::ResultStream(const std::string &file)
    : m_file(file), m_target(std::make_unique<Target>(target(file))) {
    if (m_target->descriptor() < 0) fail(m_file, std::strerror(errno));
}

ResultStream::~ResultStream() = default;

void ResultStream::append(const std::string &text) {
    if (!support::writeAll(m_target->descriptor(), text)) fail(m_file, std::strerror(errno));
}

void ResultStream::finish() {
    if (!m_target->finish()) fail(m_file, std::strerror(errno));
}

void checkWritable(const std::string &file) {
    if (file.empty()) throw std::runtime_error("a file of results has no name");
    const fs::path path = target(file);
    std::error_code error;
    if (fs::is_directory(path, error)) fail(file, "it is a folder");
    if (isSpecial(path)) {
        if (isNamedPipe(path)) fail(file, "it is a named pipe");
        if (access(path.c_str(), W_OK) != 0) fail(file, std::strerror(errno));
        return;
    }
    fs::create_directories(path.parent_path(), error);
    if (error) fail(file, error.message());
    if (access(path.c_str(), F_OK) == 0 && access(path.c_str(), W_OK) != 0) fail(file, std::strerror(errno));
    const TemporaryFile trial(path);
    if (!trial.isOpen()) fail(file, std::strerror(errno));
    if (!support::writeAll(trial.descriptor(), "\n")) fail(file, std::strerror(errno));
}

void writeResultFile(const std::string &file, const std::string &text) {
    ResultStream stream(file);
    stream.append(text);
    stream.finish();
}

void checkDistinct(const std::vector<std::string> &files) {
    for (const std::string &file : files)
        if (file.empty()) throw std::invalid_argument("a file of results has no name");
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            const fs::path one = target(files[j]), other = target(files[i]);
            std::error_code ignored;  // neither may exist yet
            const bool same = one == other || fs::equivalent(one, other, ignored);
            if (same && !isSpecial(one))
                throw std::invalid_argument("'" + files[j] + "' and '" + files[i] +
                                            "' are one file, of which something would be lost");
        }
    }
}

namespace {

std::string plain(std::string name) {
    for (char &c : name) {
        const bool isPlain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (!isPlain) c = '-';
    }
    return name;
}

}  // namespace

std::string traceFileOf(const std::string &file, const std::string &world, const std::string &engine, std::size_t runs) {
    if (file.empty() || runs < 2) return file;
    const std::filesystem::path path(file), name = std::filesystem::path(world).stem();
    std::filesystem::path result = path.parent_path() / path.stem();
    result += "-" + plain(name.string()) + "-" + plain(engine) + path.extension().string();
    return result.string();
}

}  // namespace bench
