// What the process has written to standard error, as far as that is a file: ODE's default message
// handler prints there.
#pragma once

#include <string>

namespace exactness {

class StandardError {
public:
    StandardError();
    ~StandardError();
    StandardError(const StandardError &) = delete;
    StandardError &operator=(const StandardError &) = delete;

    // What was written since the last call; empty if standard error is not a file.
    std::string takeNew();

private:
    int m_file;       // -1: none
    long m_read = 0;  // bytes
};

}  // namespace exactness
