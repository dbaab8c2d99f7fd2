// Files of results, each of which is whole at every moment: the old text or the new one, never a part of one.
//
// A new text is written into a temporary file beside the old one and then takes its name (rename), so that an
// interrupt, a kill or a full disk leaves the old text. What is no regular file (a pipe, /dev/null) has no
// name to take and is written to directly.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace bench {

// Makes the folder of `file` if there is none, and tries to write there without touching the file itself.
// Throws std::runtime_error with the file and the reason if that is not possible.
void checkWritable(const std::string &file);

// Throws std::runtime_error with the file and the reason; then the old text is still there.
void writeResultFile(const std::string &file, const std::string &text);

// A result that grows line by line: a recording. It takes its name when it is finished; one that is not, because the
// program was killed, stays beside it under a name that begins with it, and one that failed is removed.
class ResultStream {
public:
    // Throws std::runtime_error with the file and the reason, as the other functions do.
    explicit ResultStream(const std::string &file);
    ~ResultStream();
    ResultStream(const ResultStream &) = delete;
    ResultStream &operator=(const ResultStream &) = delete;

    void append(const std::string &text);
    void finish();

private:
    class Target;

    const std::string m_file;
    std::unique_ptr<Target> m_target;
};

// Checks files of results and of their inputs. Requires files whose folders exist. Throws std::invalid_argument if two of them, however
// they are spelled (relative, through a symbolic link), are one file.
void checkDistinct(const std::vector<std::string> &files);

// Where the timeline of one engine in one world is written (--trace).
//
// The file itself if there is one run; otherwise world and engine stand before its ending: trace-create-ours-2.json. Of them, what is no
// letter or digit becomes a hyphen.
std::string traceFileOf(const std::string &file, const std::string &world, const std::string &engine, std::size_t runs);

}  // namespace bench
