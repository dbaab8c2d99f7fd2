// What code meets where it would leave the work that it does on behalf of a call: an island that it steps, a
// pair that it collides ahead of its callback.
//
// Where it shuffles rows, tells a collision space that a geom moved, or reports a message, our functions in the place
// of upstream's (dxSorOrder.h, dxBodyMotion.h, ode_mt/api/error.cpp) ask the scope of the current thread:
//
//   dxDeferredScope    an island or a world is stepped on behalf of the thread that called the step
//   dxReservedDraws    islands are stepped in order on that thread, with random numbers taken in advance
//   dxIslandSurvey     joints are asked for their rows beforehand
//   dxNarrowphasePrefetch    contacts are computed ahead of the near-callbacks
//
// Invariant: a thread without a scope behaves exactly as upstream.
#pragma once

#include <cstdarg>
#include <cstdint>

enum class dxReport { Message, Debug, Error };

class dxUpstreamScope {
public:
    dxUpstreamScope(const dxUpstreamScope &) = delete;
    dxUpstreamScope &operator=(const dxUpstreamScope &) = delete;

    // The scope of this thread, or null. Islands do not nest: a callback that steps another world does
    // so without a scope or under a new one, and finds the old one again afterwards.
    static dxUpstreamScope *current();

    // Takes the next `draws` numbers of the random sequence. Returns the seed before the first of them.
    virtual std::uint32_t takeBlock(std::uint64_t draws) = 0;

    // Whether moved-notifications of bodies are put off.
    virtual bool defersMoved() const = 0;

    // A call of dMessage, dDebug or dError. True: taken over; false: to be handled as upstream does.
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
