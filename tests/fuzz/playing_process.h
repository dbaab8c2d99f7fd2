// A process that plays scripts on one of the two libraries.
#pragma once

#include "playing.h"

#include <string>
#include <vector>

#include "support/process.h"

namespace fuzz {

class PlayingProcess final : public Playing {
public:
    // Throws std::runtime_error if it cannot be started.
    PlayingProcess(const std::vector<std::string> &command, const std::string &libraryFolder, support::Environment environment);
    ~PlayingProcess() override;  // waits for its end

    void ask(RequestHeader request, const std::vector<std::uint8_t> &script) override;
    Outcome answer() override;

private:
    support::PipedProcess m_process;
};

}  // namespace fuzz
