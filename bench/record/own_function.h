// Functions of ode_MT.h by name: the programs are linked to what Debian's library exports.
#pragma once

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace record {

// Throws std::runtime_error if the library has none.
template <class Function>
void findOwn(const char *name, Function &function) {
    function = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
    if (!function) throw std::runtime_error(std::string("this libode.so.8 has no ") + name + ": it is not ODE_MT");
}

}  // namespace record
