// Vectors, rotations and poses. Plain structs, so that the many files that describe, build and drive worlds
// compile fast.
#pragma once

#include <algorithm>
#include <cmath>

namespace worlds {

constexpr double kPi = 3.14159265358979323846, kTurn = 2 * kPi;  // rad

struct Vector3 {
    double x = 0, y = 0, z = 0;

    double dot(const Vector3 &b) const { return x * b.x + y * b.y + z * b.z; }
    Vector3 cross(const Vector3 &b) const {
        return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
    }
    double squaredLength() const { return dot(*this); }
    double length() const { return std::sqrt(squaredLength()); }
    // Requires a length above 0.
    Vector3 normalized() const { return {x / length(), y / length(), z / length()}; }
    bool isFinite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
};

inline Vector3 operator+(const Vector3 &a, const Vector3 &b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vector3 operator-(const Vector3 &a, const Vector3 &b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vector3 operator-(const Vector3 &a) { return {-a.x, -a.y, -a.z}; }
inline Vector3 operator*(double s, const Vector3 &a) { return {s * a.x, s * a.y, s * a.z}; }
inline Vector3 operator*(const Vector3 &a, double s) { return s * a; }
inline Vector3 operator/(const Vector3 &a, double s) { return {a.x / s, a.y / s, a.z / s}; }
inline Vector3 &operator+=(Vector3 &a, const Vector3 &b) { return a = a + b; }
inline bool operator==(const Vector3 &a, const Vector3 &b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
inline bool operator!=(const Vector3 &a, const Vector3 &b) { return !(a == b); }

// The lesser and the greater of each coordinate.
inline Vector3 minOf(const Vector3 &a, const Vector3 &b) {
    return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
inline Vector3 maxOf(const Vector3 &a, const Vector3 &b) {
    return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

// A rotation, of length 1 where it is not a product in between.
struct Quaternion {
    double w = 1, x = 0, y = 0, z = 0;

    // Rotates about the fixed axes x, then y, then z, by angles in rad: SDF's roll, pitch and yaw.
    static Quaternion fromRollPitchYaw(double roll, double pitch, double yaw);

    Quaternion normalized() const;
    Quaternion inverse() const;
};

inline Quaternion operator*(const Quaternion &a, const Quaternion &b) {
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}
inline bool operator==(const Quaternion &a, const Quaternion &b) {
    return a.w == b.w && a.x == b.x && a.y == b.y && a.z == b.z;
}

// Returns the rotated vector.
inline Vector3 operator*(const Quaternion &q, const Vector3 &v) {
    const Vector3 axis{q.x, q.y, q.z}, first = axis.cross(v), second = axis.cross(first);
    return v + 2 * q.w * first + 2 * second;
}

inline Quaternion Quaternion::normalized() const {
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {w / length, x / length, y / length, z / length};
}

inline Quaternion Quaternion::inverse() const {
    const double square = w * w + x * x + y * y + z * z;
    return {w / square, -x / square, -y / square, -z / square};
}

inline Quaternion Quaternion::fromRollPitchYaw(double roll, double pitch, double yaw) {
    const double cr = std::cos(roll / 2), sr = std::sin(roll / 2), cp = std::cos(pitch / 2),
                 sp = std::sin(pitch / 2), cy = std::cos(yaw / 2), sy = std::sin(yaw / 2);
    return Quaternion{cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
                      cr * cp * sy - sr * sp * cy}
        .normalized();
}

// A frame as it is seen from another one.
struct Pose {
    Vector3 position;
    Quaternion rotation;

    Pose inverse() const {
        const Quaternion back = rotation.inverse();
        return {back * -position, back};
    }
};

// Returns the pose of c in a, of the poses of b in a and of c in b.
inline Pose operator*(const Pose &ab, const Pose &bc) {
    return {ab.position + ab.rotation * bc.position, ab.rotation * bc.rotation};
}

struct Matrix3 {
    double entries[3][3] = {};

    double &operator()(int row, int column) { return entries[row][column]; }
    double operator()(int row, int column) const { return entries[row][column]; }

    static Matrix3 rotation(const Quaternion &rotation) {
        const Quaternion q = rotation.normalized();
        return {{{1 - 2 * q.y * q.y - 2 * q.z * q.z, 2 * q.x * q.y - 2 * q.z * q.w,
                  2 * q.x * q.z + 2 * q.y * q.w},
                 {2 * q.x * q.y + 2 * q.z * q.w, 1 - 2 * q.x * q.x - 2 * q.z * q.z,
                  2 * q.y * q.z - 2 * q.x * q.w},
                 {2 * q.x * q.z - 2 * q.y * q.w, 2 * q.y * q.z + 2 * q.x * q.w,
                  1 - 2 * q.x * q.x - 2 * q.y * q.y}}};
    }
    Matrix3 transposed() const {
        Matrix3 t;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) t(i, j) = entries[j][i];
        return t;
    }
};

inline Matrix3 operator*(const Matrix3 &a, const Matrix3 &b) {
    Matrix3 c;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) c(i, j) = a(i, 0) * b(0, j) + a(i, 1) * b(1, j) + a(i, 2) * b(2, j);
    return c;
}
inline Vector3 operator*(const Matrix3 &a, const Vector3 &v) {
    const auto row = [&](int i) { return a(i, 0) * v.x + a(i, 1) * v.y + a(i, 2) * v.z; };
    return {row(0), row(1), row(2)};
}

// Of a symmetric matrix. All leading minors are above 0 (Sylvester).
inline bool isPositiveDefinite(const Matrix3 &a) {
    const double second = a(0, 0) * a(1, 1) - a(0, 1) * a(0, 1);
    const double determinant = a(0, 0) * (a(1, 1) * a(2, 2) - a(1, 2) * a(1, 2)) -
                               a(0, 1) * (a(0, 1) * a(2, 2) - a(1, 2) * a(0, 2)) +
                               a(0, 2) * (a(0, 1) * a(1, 2) - a(1, 1) * a(0, 2));
    return a(0, 0) > 0 && second > 0 && determinant > 0;
}

}  // namespace worlds
