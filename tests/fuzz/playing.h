// Whoever plays scripts on one of the two libraries.
#pragma once

#include "protocol.h"

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

class Playing {
public:
    virtual ~Playing() = default;

    // Begins to play. To be followed by answer(), which waits for the end.
    virtual void ask(RequestHeader request, const std::vector<std::uint8_t> &script) = 0;
    virtual Outcome answer() = 0;
};

}  // namespace fuzz
