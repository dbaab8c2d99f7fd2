#pragma once

#include <ode/ode.h>

namespace scenes {

struct Vector3 {
    dReal x = 0, y = 0, z = 0;
};

inline Vector3 operator+(const Vector3 &a, const Vector3 &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3 &a, const Vector3 &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator*(dReal s, const Vector3 &a) { return {s * a.x, s * a.y, s * a.z}; }

constexpr dReal kPi = REAL(3.141592653589793);
constexpr Vector3 kAxisX{1, 0, 0}, kAxisY{0, 1, 0}, kAxisZ{0, 0, 1};

}  // namespace scenes
