// The program that is looked at: started with our library and the file of its frames, and asked to end.
//
// It leads a process group of its own, so that a Ctrl-C is passed on once. What it prints goes to a file or to standard error, never through
// this process, whose end it does not notice.
#pragma once

#include <sys/types.h>

#include <string>

#include "run_folder.h"
#include "top/frame_board.h"
#include "top/top_options.h"

namespace top {

class Program {
public:
    // Throws std::runtime_error if it cannot be started.
    Program(const TopOptions &options, const bench::RunFolder &folder, const FrameBoard &board);

    // What it prints is in it; empty: it went to standard error.
    const std::string &output() const { return m_output; }

    bool hasEnded();
    int exitCode() const;  // of a shell; has ended

    // First by the signal; whoever asks twice is obeyed at once.
    void askToEnd(int signal);

private:
    int openOutput(const TopOptions &options);

    std::string m_output;
    pid_t m_child = -1;
    int m_status = 0;
    bool m_hasEnded = false, m_isAsked = false;
};

}  // namespace top
