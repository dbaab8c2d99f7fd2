#include "loader/read/shape_mass.h"

#include "loader/read/element_rules.h"

namespace worlds {

namespace {

// Of a solid shape of density 1, in its own frame.
struct Solid {
    double volume = 0;  // m³
    Vector3 center;
    Matrix3 inertia;    // m⁵ about the centre
};

Matrix3 diagonal(double x, double y, double z) { return {{{x, 0, 0}, {0, y, 0}, {0, 0, z}}}; }

Matrix3 operator+(const Matrix3 &a, const Matrix3 &b) {
    Matrix3 sum;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) sum(i, j) = a(i, j) + b(i, j);
    return sum;
}
Matrix3 operator*(double s, const Matrix3 &a) {
    Matrix3 scaled;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) scaled(i, j) = s * a(i, j);
    return scaled;
}

// The inertia of a mass of 1 at a point (Huygens and Steiner).
Matrix3 inertiaAt(const Vector3 &p) {
    return {{{p.y * p.y + p.z * p.z, -p.x * p.y, -p.x * p.z},
             {-p.x * p.y, p.x * p.x + p.z * p.z, -p.y * p.z},
             {-p.x * p.z, -p.y * p.z, p.x * p.x + p.y * p.y}}};
}

Solid solid(const Box &box) {
    const double volume = box.size.x * box.size.y * box.size.z, part = volume / 12;
    const Vector3 square{box.size.x * box.size.x, box.size.y * box.size.y, box.size.z * box.size.z};
    return {volume, {}, diagonal(part * (square.y + square.z), part * (square.x + square.z), part * (square.x + square.y))};
}

Solid solid(const Sphere &sphere) {
    const double square = sphere.radius * sphere.radius, volume = 4. / 3 * kPi * square * sphere.radius, moment = 2. / 5 * volume * square;
    return {volume, {}, diagonal(moment, moment, moment)};
}

Solid solid(const Cylinder &cylinder) {
    const double square = cylinder.radius * cylinder.radius, volume = kPi * square * cylinder.length;
    const double across = volume * (3 * square + cylinder.length * cylinder.length) / 12;
    return {volume, {}, diagonal(across, across, volume * square / 2)};
}

// A cylinder, and two half balls whose centres of mass are 3/8 of the radius beyond its ends.
Solid solid(const Capsule &capsule) {
    const Solid middle = solid(Cylinder{capsule.radius, capsule.length}), ball = solid(Sphere{capsule.radius});
    const double aside = ball.volume * capsule.length * (capsule.length / 4 + 3. / 8 * capsule.radius);
    return {middle.volume + ball.volume, {}, middle.inertia + ball.inertia + diagonal(aside, aside, 0)};
}

Solid solid(const Plane &) { return {}; }
Solid solid(const HeightField &) { return {}; }

// The sum of tetrahedra between the triangles and one of the corners, negative where a triangle faces it. Closed surfaces have areas that cancel out.
Solid solid(const TriangleMesh &mesh) {
    constexpr double kOpen = 1e-6, kFlat = 1e-9;
    const auto corner = [&](std::uint32_t number) {
        const float *const at = &mesh.vertices[3 * std::size_t(number)];
        return Vector3{at[0], at[1], at[2]};
    };
    if (mesh.triangles.empty()) return {};
    const Vector3 apex = corner(mesh.triangles.front());
    Solid sum;
    Vector3 firstMoment, areas;
    double area = 0, volumes = 0;
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const Vector3 a = corner(mesh.triangles[i]) - apex, b = corner(mesh.triangles[i + 1]) - apex, c = corner(mesh.triangles[i + 2]) - apex;
        const Vector3 twiceArea = (b - a).cross(c - a);
        const double volume = a.dot(b.cross(c)) / 6;
        areas += twiceArea;
        area += twiceArea.length();
        volumes += std::abs(volume);
        sum.volume += volume;
        firstMoment += volume / 4 * (a + b + c);
        sum.inertia = sum.inertia + volume / 20 * (inertiaAt(a) + inertiaAt(b) + inertiaAt(c) + inertiaAt(a + b + c));
    }
    if (!(std::abs(sum.volume) > kFlat * volumes) || areas.length() > kOpen * area) return {};
    const Vector3 center = firstMoment / sum.volume;
    sum.inertia = sum.inertia + -sum.volume * inertiaAt(center);
    sum.center = apex + center;
    if (sum.volume < 0) return {-sum.volume, sum.center, -1 * sum.inertia};  // all triangles face inwards
    return sum;
}

}  // namespace

void ShapeMass::add(const Collision &collision, double density) {
    const Solid one = std::visit([](const auto &shape) { return solid(shape); }, collision.shape);
    const double mass = density * one.volume;
    const Vector3 center = collision.pose.position + collision.pose.rotation * one.center;
    const Matrix3 turn = Matrix3::rotation(collision.pose.rotation);
    m_mass += mass;
    m_firstMoment += mass * center;
    m_inertia = m_inertia + density * (turn * one.inertia * turn.transposed()) + mass * inertiaAt(center);
}

std::optional<Mass> ShapeMass::total() const {
    if (!(m_mass >= smallestPositive && m_mass <= largestNumber)) return std::nullopt;
    Mass total;
    total.mass = m_mass;
    total.center = m_firstMoment / m_mass;
    total.inertia = m_inertia + -m_mass * inertiaAt(total.center);
    if (!total.center.isFinite() || !isPositiveDefinite(total.inertia)) return std::nullopt;
    return total;
}

Mass scaledTo(double mass, const Mass &source) { return {mass, source.center, mass / source.mass * source.inertia}; }

}  // namespace worlds
