// Of the functions of ode_MT.h.
#include "bad_calls.h"

#include "own_functions.h"

namespace bad_input {

std::vector<BadCall> badCalls() {
    std::vector<BadCall> calls;
#define ADD(name, function) addCalls(calls, name, function);
    BAD_INPUT_FUNCTIONS(ADD)
#undef ADD
    return calls;
}

}  // namespace bad_input
