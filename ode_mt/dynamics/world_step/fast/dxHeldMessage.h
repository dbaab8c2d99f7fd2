// The message of an algorithm that is asked for help, held back until nothing is held that the user's handler could strand with longjmp
// (pooled solvers, arenas), or until it is known that the algorithm's answer is not used.
//
// Threading: one thread, which does nothing else that draws random numbers or moves bodies meanwhile.
#pragma once

#include "threading/dxUpstreamScope.h"

class dxHeldMessage final : public dxUpstreamScope {
public:
    // Messages are held; errors end the scope, and are handled as without it.
    bool takeOver(dxReport kind, int number, const char *format, va_list arguments) override;
    std::uint32_t takeBlock(std::uint64_t draws) override;
    bool defersMoved() const override;

    bool isHeld() const { return m_isHeld; }

    // Ends the scope. Tells the first message, if there was one.
    void deliver();

private:
    static constexpr unsigned kMaxLength = 256;  // upstream's solver has none half as long

    bool m_isHeld = false;
    int m_number = 0;
    char m_text[kMaxLength];
};
