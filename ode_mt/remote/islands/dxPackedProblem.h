// An island's problem as bytes: what dxMakeConstraintMatrix and dxSolveDantzig read, and nothing of bodies, joints or worlds. And its
// result as bytes: x, the messages that the solver reported, the floating-point exceptions that it raised.
//
// Invariants: whatever the bytes are, reading them touches nothing outside of them; a problem that was read has numbers of bodies and rows
// in range. Bytes are those of one machine's numbers; that they are the receiver's, too, is for dxRemoteFrame to know.
#pragma once

#include <ode/common.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "dynamics/world_step/kernels/dxConstraintMatrix.h"

struct dxWorldStepProblem;

struct dxPackedCounts {
    std::uint32_t floatMode;  // dxFloatMode
    std::uint32_t bodies, joints, rows;
    std::uint32_t bilateralJoints;
    std::uint32_t padding;
};

// What follows in the bytes begins on eight.
constexpr std::size_t dxPackedRoom(std::size_t bytes) { return (bytes + 7) / 8 * 8; }

// Where the arrays of a problem begin, in their order, and what all of it takes. In 64 bits: counts of 32 cannot overflow them.
struct dxPackedLayout {
    explicit dxPackedLayout(const dxPackedCounts &counts);

    std::size_t joints, jacobian, inverseInertia, motions, pairsBX, pairsLoHi, normalOf, total;
};

// A problem in its bytes.
struct dxPackedProblem {
    dxPackedCounts counts;
    const std::byte *joints;          // dxConstraintJoint
    const std::byte *jacobian;        // 2 kRowElements a row
    const std::byte *inverseInertia;  // 12 a body
    const std::byte *motions;         // kRowElements a body
    const std::byte *pairsBX;         // 2 a row: c/h, cfm/h
    const std::byte *pairsLoHi;       // 2 a row
    const std::byte *normalOf;        // int, one a row

    static constexpr unsigned kInertiaElements = 12;

    // False: the bytes are none.
    bool read(const std::byte *bytes, std::size_t size);
};

// Requires rows, read, and no solver since. The result is written over `bytes`.
void dxPackProblem(const dxWorldStepProblem &problem, dReal stepSize, std::vector<std::byte> &bytes);

struct dxPackedResult {
    enum class Outcome : std::uint32_t { Solved, GivenBack };
    struct Head {
        Outcome outcome;
        std::uint32_t rows;
        std::uint32_t exceptions;  // as std::fetestexcept has them
        std::uint32_t messages;
    };
    struct Message {
        std::int32_t number;
        std::uint32_t length;  // the text follows, without an end
    };
};

// Writes x into the problem and raises exceptions. GivenBack: the worker could not solve it (no bytes say so, too); Wrong: the bytes are no
// result of this problem; then nothing is changed.
enum class dxPackedAnswer { Solved, GivenBack, Wrong };
dxPackedAnswer dxReadPackedResult(const std::vector<std::byte> &bytes, const dxWorldStepProblem &problem);

// Reports what the solver reported (dMessage), of a result that was read. May not return.
void dxReportPackedMessages(const std::vector<std::byte> &bytes);
