// Spheres of four clusters in a box, accelerated at random.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "clusters/heuristics/dxCheckFrequencyHeuristic.h"

struct SwarmSetting {
    double speed, acceleration, step;  // at the start; at most
    unsigned members;
};

// Moved as ODE does it, in numbers of type Real.
template <class Real>
class Swarm {
public:
    Swarm(SwarmSetting setting, unsigned seed)
        : m_setting(setting), m_random(seed), m_members(setting.members) {
        for (Member &member : m_members) {
            for (int axis = 0; axis < 3; ++axis)
                member.position[axis] = static_cast<Real>(kHalfBox * uniform());
            member.velocity = direction(setting.speed);
        }
    }

    dxMotionBound motion() const {
        double fastest = 0;
        for (const Member &member : m_members) fastest = std::max(fastest, length(member.velocity));
        return {fastest, m_setting.acceleration, m_setting.step,
                4 * kHalfBox * std::numeric_limits<Real>::epsilon()};
    }

    // Returns the smallest distance of surfaces of different clusters; not positive: some overlap.
    double gap() const {
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < m_members.size(); ++i) {
            for (std::size_t k = i + 1; k < m_members.size(); ++k) {
                if (i % kClusters != k % kClusters)
                    smallest = std::min(smallest, distance(i, k) - 2 * kRadius);
            }
        }
        return smallest;
    }

    void step() {
        for (Member &member : m_members) {
            const auto change = direction(m_setting.acceleration * m_setting.step * std::abs(uniform()));
            for (int axis = 0; axis < 3; ++axis) {
                member.velocity[axis] += change[axis];
                member.position[axis] += static_cast<Real>(member.velocity[axis] * m_setting.step);
                if (std::abs(member.position[axis]) > kHalfBox) turnBack(member, axis);
            }
        }
    }

private:
    static constexpr double kHalfBox = 6, kRadius = 0.3;
    static constexpr std::size_t kClusters = 4;

    struct Member {
        std::array<Real, 3> position;
        std::array<double, 3> velocity;
    };

    double uniform() { return std::uniform_real_distribution<double>(-1, 1)(m_random); }

    static double length(const std::array<double, 3> &v) { return std::hypot(v[0], v[1], v[2]); }

    double distance(std::size_t i, std::size_t k) const {
        const auto &a = m_members[i].position, &b = m_members[k].position;
        return std::hypot(double(a[0]) - b[0], double(a[1]) - b[1], double(a[2]) - b[2]);
    }

    // A little less than `size`, so that it is a bound also after rounding.
    std::array<double, 3> direction(double size) {
        std::array<double, 3> v = {uniform(), uniform(), uniform()};
        const double scale = size * (1 - 1e-9) / std::max(length(v), 1e-9);
        for (double &component : v) component *= scale;
        return v;
    }

    // Reverses a member from the next step on; its speed is unchanged.
    static void turnBack(Member &member, int axis) {
        const double inwards = member.position[axis] > 0 ? -1 : 1;
        member.velocity[axis] = inwards * std::abs(member.velocity[axis]);
    }

    SwarmSetting m_setting;
    std::mt19937 m_random;
    std::vector<Member> m_members;
};
