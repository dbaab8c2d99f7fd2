// The mass of a link that is made of its collision shapes: <inertial auto="true">.
#pragma once

#include "loader/description/world_description.h"

#include <optional>

namespace worlds {

// Solid shapes, each of one density; where two overlap, both count. Those without a volume weigh nothing: planes, height fields and meshes that are
// not closed.
class ShapeMass {
public:
    // `density` in kg/m³.
    void add(const Collision &collision, double density);

    // Of all together. None without a volume, or if it is too small or large to be computed with.
    std::optional<Mass> total() const;

private:
    double m_mass = 0;      // kg
    Vector3 m_firstMoment;  // kg·m in the link's frame
    Matrix3 m_inertia;      // kg·m² about the link's origin
};

// The same with another mass, in kg.
Mass scaledTo(double mass, const Mass &source);

}  // namespace worlds
