// What rendering needs of vectors.
#pragma once

#include "record/recording.h"

#include <cmath>

namespace render {

using record::Vector;

inline Vector operator+(const Vector &a, const Vector &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator-(const Vector &a, const Vector &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator*(double s, const Vector &a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector &a, const Vector &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

inline Vector cross(const Vector &a, const Vector &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The zero vector stays what it is.
inline Vector normalised(const Vector &a) {
    const double length = std::sqrt(dot(a, a));
    return length > 0 ? (1 / length) * a : a;
}

// v turned by the pose, not moved.
inline Vector rotate(const record::Pose &pose, const Vector &v) {
    const auto &[w, x, y, z] = pose.quaternion;
    const Vector axis = {x, y, z};
    const Vector t = 2 * cross(axis, v);
    return v + w * t + cross(axis, t);
}

inline Vector toWorld(const record::Pose &pose, const Vector &v) { return pose.position + rotate(pose, v); }

}  // namespace render
