// What the driver asks of a playing process, which runs on one of the two libraries, and what that answers.
//
// A request is a header and a script, as bytes to draw from or as text; each is played in a fork of the process. The answer
// is a header and texts.
#pragma once

#include <cstdint>

namespace fuzz {

struct RequestHeader {
    std::uint32_t length;  // of the script
    std::uint8_t isText;
    std::uint8_t tells;    // write what is seen, too
    std::uint8_t jumps, messages;
    std::uint8_t fillsStack;  // with this byte, before each call: a result that changes depends on unwritten memory; 0: off
    // The settings of ODE_MT; Debian's library has none of them.
    std::uint16_t threads;
    std::uint8_t manager, algorithm, instructionSet, cells;
    std::uint8_t disturbs;  // the schedule: workers pause at pseudo-random points
    std::uint16_t maxCalls;
    std::uint16_t seconds;      // of processor time that it may take, of all its threads
    std::uint16_t wallSeconds;  // limit of wall-clock time, for calls that never return
};

struct AnswerHeader {
    std::int32_t ending;  // as waitpid's status
    std::uint32_t calls;
    std::uint64_t hash;
    std::uint32_t workers;      // most that took part in a step or a collision
    std::uint32_t directIslands;  // that the solver fast was asked to solve
    std::uint32_t errorLength;  // standard error; the place of an assertion in the source is removed
    std::uint32_t textLength;   // the script as it was played
};

// The text of a script that ends so is not compared.
constexpr const char *kMemoryIsOver = "# memory is over";

constexpr const char *kManagers[] = {"pthread", "openmp"};
constexpr const char *kAlgorithms[] = {"auto", "lcp", "serial", "original", "static", "static-unmerged", "duplication", "decluster"};

}  // namespace fuzz
