// Ends a process whose output nobody reads any more, while it is at work that writes nothing.
#pragma once

namespace bench {

// While it lives: five times a second a timer's signal looks whether standard output is a pipe whose other end is closed, as that of a
// program that was killed, and then ends the process. No thread is started: allocation and locks stay as fast as in a process that has
// one thread.
class ReaderWatch {
public:
    ReaderWatch();
    ~ReaderWatch();
    ReaderWatch(const ReaderWatch &) = delete;
    ReaderWatch &operator=(const ReaderWatch &) = delete;
};

}  // namespace bench
