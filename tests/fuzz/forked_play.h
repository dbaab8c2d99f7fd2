// Plays each script in a fork of this process, on the ODE that this process has.
//
// Threads: none may run in this process when ask() is called.
#pragma once

#include "playing.h"

#include <sys/types.h>

#include <functional>

#include "support/process.h"

namespace fuzz {

class ForkedPlay final : public Playing {
public:
    using AtBirth = std::function<void(const RequestHeader &request)>;
    using AfterDeath = std::function<void()>;

    // `atBirth` is called in the child before anything else, `afterDeath` in this process when the child has ended.
    // Throws std::runtime_error if there is no memory for what a child leaves behind.
    explicit ForkedPlay(AtBirth atBirth = {}, AfterDeath afterDeath = {});
    ~ForkedPlay() override;
    ForkedPlay(const ForkedPlay &) = delete;
    ForkedPlay &operator=(const ForkedPlay &) = delete;

    void ask(RequestHeader request, const std::vector<std::uint8_t> &script) override;
    Outcome answer() override;

private:
    struct Remains;

    std::string errors() const;

    const AtBirth m_atBirth;
    const AfterDeath m_afterDeath;
    Remains *m_remains;                  // memory shared with the children
    const support::MemoryFile m_errors;  // their standard output and standard error
    pid_t m_child = -1;
};

}  // namespace fuzz
