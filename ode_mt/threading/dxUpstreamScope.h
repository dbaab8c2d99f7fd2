// The scope of work that a thread does on behalf of a call (an island that it steps, a pair that it collides before the callback), and how upstream's
// code leaves it.
//
// Upstream's code would shuffle rows, tell a collision space that a geom moved, or report a message or a failed assertion. Our functions in its place
// (dxSorOrder.h, dxBodyMotion.h, ode_mt/api/error.cpp) ask the scope of the current thread:
//
//   dxDeferredScope        an island or a world is stepped on behalf of the thread that called the step
//   dxReservedDraws        islands are stepped in order on that thread, with random numbers taken in advance
//   dxIslandSurvey         joints are asked for their rows beforehand
//   dxInterruptingScope    contacts are computed before the near-callbacks, or bounding boxes on workers
//   dxHeldMessage          Dantzig's algorithm is tried, and its message kept back (dxDantzigTrial.h)
//   KeptMessages           a remote worker solves a problem (dxPackedSolver.cpp)
//
// Invariant: a thread without a scope behaves exactly as upstream.
#pragma once

#include <ode/error.h>

#include <cstdarg>
#include <cstdint>

// Returns whether user code hears of errors, assertions or messages: it may look at the world in the middle of a step, or leave it.
inline bool dxHasUserHandlers() {
    return dGetErrorHandler() != nullptr || dGetDebugHandler() != nullptr || dGetMessageHandler() != nullptr;
}

// Thrown through upstream's code to leave work that was begun early or on another thread. The call does it again in order.
struct dxUpstreamInterrupted {};

enum class dxReport { Message, Debug, Error };

class dxUpstreamScope {
public:
    dxUpstreamScope(const dxUpstreamScope &) = delete;
    dxUpstreamScope &operator=(const dxUpstreamScope &) = delete;

    // Returns the scope of this thread, or null. Islands do not nest: a callback that steps another world does
    // so without a scope or under a new one, and finds the old one again afterwards.
    static dxUpstreamScope *current();

    // Takes the next `draws` numbers of the random sequence. Returns the seed before the first of them.
    virtual std::uint32_t takeBlock(std::uint64_t draws) = 0;

    // Whether moved-notifications of bodies are deferred.
    virtual bool defersMoved() const = 0;

    // Handles a call of dMessage, dDebug or dError. Returns false if upstream should handle it.
    virtual bool takeOver(dxReport kind, int number, const char *format, va_list arguments) = 0;

protected:
    dxUpstreamScope();
    ~dxUpstreamScope() { leave(); }

    // Ends the scope before its destructor does: a handler of the user may leave with longjmp, which
    // runs no destructor.
    void leave();

private:
    dxUpstreamScope *m_outer;
    bool m_entered = true;
};

// The scope of work that a worker does before a call needs it. Whatever upstream's code would report, or draw from the random sequence, interrupts
// the work.
class dxInterruptingScope final : public dxUpstreamScope {
public:
    std::uint32_t takeBlock(std::uint64_t) override { throw dxUpstreamInterrupted(); }
    bool defersMoved() const override { return false; }
    bool takeOver(dxReport, int, const char *, va_list) override { throw dxUpstreamInterrupted(); }
};
