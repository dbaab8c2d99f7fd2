// Calls of ODE's that are left in the middle: a function or a handler of the program's throws an int, or jumps to `beforeTheCall`.
#pragma once

#include <csetjmp>

namespace exactness {

inline std::jmp_buf beforeTheCall;

// Makes the call, and returns whether an int was thrown.
template <class Call>
bool throwsAnInt(const Call &call) {
    if (setjmp(beforeTheCall) != 0) return false;
    try {
        call();
        return false;
    } catch (int) {
        return true;
    }
}

}  // namespace exactness
