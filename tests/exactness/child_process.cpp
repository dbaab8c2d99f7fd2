#include "child_process.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace exactness {

namespace {

std::string contents(const std::string &path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

// To be written to, each line behind those of whoever else writes.
class OutputFile {
public:
    explicit OutputFile(const std::string &path) : m_file(open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600)) {}
    ~OutputFile() { close(m_file); }
    OutputFile(const OutputFile &) = delete;
    OutputFile &operator=(const OutputFile &) = delete;

    int descriptor() const { return m_file; }

private:
    const int m_file;
};

}  // namespace

ChildResult runChild(const std::vector<std::string> &command,
                     const process::Environment &variables) {
    const TemporaryFolder folder;
    const std::string output = folder.file("out"), errors = folder.file("err");
    int status = 0;
    {
        const OutputFile outputFile(output), errorFile(errors);
        const pid_t child = process::spawn(command, variables, {-1, outputFile.descriptor(), errorFile.descriptor()});
        while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
        }
    }
    return {WIFEXITED(status) && WEXITSTATUS(status) == 0, process::endingOf(status), contents(output),
            contents(errors)};
}

TemporaryFolder::TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "odemt_exactness_XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + pattern);
    m_path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(m_path, ignored);
}

}  // namespace exactness
