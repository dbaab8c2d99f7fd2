#include "joint_lattice.h"

namespace exactness {

void JointLattice::build() {
    int number = 0;
    for (int y = 0; y < m_side; ++y) {
        for (int x = 0; x < m_side; ++x) {
            const Vector3 place{kPitch * x, kPitch * y, kHeight};
            m_knots.push_back(addBody(place, world()));
            if (x > 0) join(number++, knot(x - 1, y), knot(x, y), place + Vector3{-kPitch / 2, 0, 0});
            if (y > 0) join(number++, knot(x, y - 1), knot(x, y), place + Vector3{0, -kPitch / 2, 0});
        }
    }
    addBall(m_knots.front(), nullptr, {0, 0, kHeight});
    addBall(m_knots.back(), nullptr, {kPitch * (m_side - 1), kPitch * (m_side - 1), kHeight});
}

}  // namespace exactness
