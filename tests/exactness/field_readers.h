// Makes field readers of ODE's getters.
#pragma once

#include "fields.h"

namespace exactness {

template <class Handle, dReal (*get)(Handle)>
void readReal(Handle handle, const Names &, Reading &reading) {
    reading.real(get(handle));
}

template <class Handle, int (*get)(Handle)>
void readInteger(Handle handle, const Names &, Reading &reading) {
    reading.integer(get(handle));
}

// Getters that return a pointer to `count` reals.
template <class Handle, const dReal *(*get)(Handle), std::size_t count>
void readReals(Handle handle, const Names &, Reading &reading) {
    reading.reals(get(handle), count);
}

// A rotation matrix without its fourth column, which upstream leaves unset in places.
inline void readMatrix(const dReal *rotation, Reading &reading) {
    for (int row = 0; row < 3; ++row) reading.reals(rotation + 4 * row, 3);
}

// Getters that fill `count` reals.
template <class Handle, void (*get)(Handle, dReal *), std::size_t count = 3>
void copyReals(Handle handle, const Names &, Reading &reading) {
    dReal values[count + 1] = {};  // dVector3 is four reals long
    get(handle, values);
    reading.reals(values, count);
}

}  // namespace exactness
