// Whether a call of ours is still in progress on this thread, for state that its callbacks find again: user code may have
// left the call by longjmp, which runs no destructor.
//
// A call notes its frame. What it calls has frames beyond that on the stack; whatever runs after the call was left does
// not, until the stack has grown as deep again. So a call that is in progress is never taken for one that was left; one
// that was left may be taken for one in progress, once, by a caller much deeper on the stack: that may cost speed, and
// must cost nothing else.
//
// Requires: callbacks run on the stack of the call. (One that switches to another stack and calls the library from there
// is taken to have left the call or not, by where that stack lies.)
#pragma once

#include <cstdint>

class dxStackFrame {
public:
    constexpr dxStackFrame() = default;

    // That of the calling function, or of one that it is inlined into.
    [[gnu::always_inline]] static dxStackFrame ofCaller() { return dxStackFrame(__builtin_frame_address(0)); }

    // Whether `current`, of this thread, is a call made by this one.
    bool called(dxStackFrame current) const { return current.m_address < m_address; }

private:
    explicit dxStackFrame(const void *address) : m_address(reinterpret_cast<std::uintptr_t>(address)) {}

    std::uintptr_t m_address = 0;  // stacks grow to lower ones
};
