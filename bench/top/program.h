// The program that is looked at, and the end of what it printed.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>
#include <vector>

#include "library_folders.h"
#include "top/frame_board.h"
#include "top/top_options.h"
#include "support/temporary_folder.h"

namespace top {

// The program that is looked at: started with our library and the file of its frames, and asked to end.
//
// It leads a process group of its own, so that a Ctrl-C is passed on once. What it prints goes to a file or to standard error, never through
// this process, whose end it does not notice. Processes that it starts are ended with it where it was asked to end: a script's background jobs
// ignore SIGINT. Those of a program that ends by itself are its own affair.
class Program {
public:
    // Throws std::runtime_error if it cannot be started. Requires that this process has no other children, and has adopted orphans (orphans.h).
    Program(const TopOptions &options, const support::TemporaryFolder &folder, const FrameBoard &board);

    // What it prints is in it; empty: it went to standard error.
    const std::string &output() const { return m_output; }

    // Ends it if it has not ended.
    ~Program();
    Program(const Program &) = delete;
    Program &operator=(const Program &) = delete;

    bool hasEnded();
    int exitCode() const;  // of a shell; has ended

    // First by the signal; whoever asks twice is obeyed at once.
    void askToEnd(int signal);

    // What is left of it, after its end, if it was asked to end: by SIGTERM, a second later by SIGKILL. Returns false if some are left.
    bool endRest();

private:
    int openOutput(const TopOptions &options);

    std::string m_output;
    pid_t m_child = -1;
    int m_status = 0;
    bool m_hasEnded = false, m_isAsked = false;
};

// The last lines of what a program has printed into a file.

// Of the file's last few KiB, at most `count` lines, none longer than `width`; characters that a terminal would obey are '?'.
std::vector<std::string> tailOf(const std::string &file, std::size_t count, std::size_t width);

}  // namespace top
