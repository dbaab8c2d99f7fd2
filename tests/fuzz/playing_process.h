// A process that plays scripts on one of the two libraries.
#pragma once

#include "protocol.h"

#include <sys/types.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fuzz {

struct Outcome {
    AnswerHeader header{};
    std::string errors, text;

    std::string ending() const;  // "exit status 0", "signal 6"
    bool endedInTime() const;
    bool crashed() const;  // by a fault, not by an assertion
};

class PlayingProcess {
public:
    // Throws std::runtime_error if it cannot be started. `pattern`: MALLOC_PERTURB_, or empty.
    PlayingProcess(const std::string &program, const std::string &libraryFolder, const std::string &pattern);
    ~PlayingProcess();
    PlayingProcess(const PlayingProcess &) = delete;
    PlayingProcess &operator=(const PlayingProcess &) = delete;

    void ask(RequestHeader request, const std::vector<std::uint8_t> &script);
    Outcome answer();

private:
    pid_t m_child = -1;
    int m_requests = -1, m_answers = -1;
};

}  // namespace fuzz
