// Calls of the functions that list_functions.py found: upstream's, or those of ode_MT.h.
#include "bad_calls.h"

#include <ode/cooperative.h>
#include <ode/matrix_coop.h>

#include "listed_functions.h"

namespace bad_input {

std::vector<BadCall> badCalls() {
    std::vector<BadCall> calls;
#define ADD(name, function) addCalls(calls, name, function);
    BAD_INPUT_FUNCTIONS(ADD)
#undef ADD
    return calls;
}

}  // namespace bad_input
