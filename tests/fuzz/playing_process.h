// A process that plays scripts on one of the two libraries.
#pragma once

#include "playing.h"

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

namespace fuzz {

class PlayingProcess final : public Playing {
public:
    // Variables and their values, beside those of this process.
    using Environment = std::vector<std::pair<std::string, std::string>>;

    // Throws std::runtime_error if it cannot be started.
    PlayingProcess(const std::string &program, const std::string &libraryFolder, const Environment &environment);
    ~PlayingProcess() override;
    PlayingProcess(const PlayingProcess &) = delete;
    PlayingProcess &operator=(const PlayingProcess &) = delete;

    void ask(RequestHeader request, const std::vector<std::uint8_t> &script) override;
    Outcome answer() override;

private:
    pid_t m_child = -1;
    int m_requests = -1, m_answers = -1;
};

}  // namespace fuzz
