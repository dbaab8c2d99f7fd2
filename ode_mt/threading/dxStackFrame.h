// Tells whether a call of ours is still in progress on this thread, for state that its callbacks use: user code may have
// left the call by longjmp, which runs no destructor.
//
// A call stores its frame. Functions that it calls have frames beyond that on the stack. Code that runs after the call was left
// has not, until the stack has grown as deep again. So a call in progress is never taken for one that was left. One
// that was left may be taken for one in progress, once, by a caller much deeper on the stack: that may cost speed, and
// must cost nothing else.
//
// Requires that callbacks run on the stack of the call. (For a callback that switches to another stack and calls the library from there, the answer
// depends on the addresses of the two stacks.)
//
// Threading: a frame belongs to one thread.
#pragma once

#include <cstdint>

class dxStackFrame {
public:
    constexpr dxStackFrame() = default;

    // Returns the frame of the calling function, or of one that it is inlined into.
    [[gnu::always_inline]] static dxStackFrame ofCaller() { return dxStackFrame(__builtin_frame_address(0)); }

    // Returns whether `current`, of this thread, is a call made by this one.
    bool called(dxStackFrame current) const { return current.m_address < m_address; }

private:
    explicit dxStackFrame(const void *address) : m_address(reinterpret_cast<std::uintptr_t>(address)) {}

    std::uintptr_t m_address = 0;  // stacks grow to lower ones
};
