// Contract F3, closed loop: after seconds of frames nothing has become worse with the solver fast than with libode8, at the same number
// of iterations: drift, depth, energy at rest, sliding, gaps of joints, and what else odemt_quality measures.
//
// What collapses or bounces comes out otherwise after the smallest change. How much, libode8 shows itself with one or two iterations
// more or less: fast may have the worst of these values, and what no user notices more (Quantity::slack).
#include "engine_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace {

using namespace quality;
using nlohmann::json;

json measure(const Engine &engine, const std::string &experiment, std::vector<std::string> options) {
    options.insert(options.begin(), {"measure", experiment});
    return answerOf(engine, options)["experiments"][experiment];
}

json measure(const Engine &engine, const std::string &experiment, int iterations) {
    return measure(engine, experiment, {"--iterations", std::to_string(iterations)});
}

std::vector<std::string> experimentNames() {
    std::vector<std::string> names;
    const json answer = answerOf(Engine::debian(), {"list"});
    for (const auto &[name, meaning] : answer["experiments"].items()) names.push_back(name);
    return names;
}

class ClosedLoop : public testing::TestWithParam<std::string> {
protected:
    ClosedLoop() {
        for (const int iterations : {18, 19, 20, 21, 22}) m_debian.push_back(measure(Engine::debian(), GetParam(), iterations));
        const bool hasReference = std::any_of(m_debian[0].begin(), m_debian[0].end(), [](const json &quantity) { return bool(quantity["reference"]); });
        if (hasReference) m_reference = measure(Engine::debian(), GetParam(), std::vector<std::string>{"--world"});
    }

    // How far the quantity is from what is right.
    double error(const json &measured, const std::string &quantity) const {
        const json &entry = measured[quantity];
        const double value = entry["value"].is_number() ? double(entry["value"]) : std::numeric_limits<double>::infinity();  // NaN
        return entry["reference"] ? std::fabs(value - double(m_reference[quantity]["value"])) : value;
    }

    // Names what is worse.
    std::string worse(const json &measured) const {
        std::string names;
        for (const auto &[quantity, entry] : measured.items()) {
            double most = 0;
            for (const json &debian : m_debian) most = std::max(most, error(debian, quantity));
            if (error(measured, quantity) <= most + double(entry["slack"])) continue;
            names += quantity + ' ' + std::to_string(error(measured, quantity)) + " instead of " + std::to_string(most) + ' ' +
                     std::string(entry["unit"]) + '\n';
        }
        return names;
    }

private:
    std::vector<json> m_debian;
    json m_reference;
};

TEST_P(ClosedLoop, FastIsNoWorse) { EXPECT_EQ(worse(measure(Engine::fast(), GetParam(), 20)), ""); }

INSTANTIATE_TEST_SUITE_P(Experiments, ClosedLoop, testing::ValuesIn(experimentNames()),
                         [](const testing::TestParamInfo<std::string> &info) { return info.param; });

// What this suite would say of a solver that does a quarter of the iterations.
class FewerIterations : public ClosedLoop {};

TEST_P(FewerIterations, AreWorse) { EXPECT_NE(worse(measure(Engine::debian(), GetParam(), 5)), ""); }

INSTANTIATE_TEST_SUITE_P(Experiments, FewerIterations,
                         testing::Values("stack", "towers", "wall", "hub", "mass_ratio", "pile", "fixed_friction", "loaded_chain", "motors", "stop",
                                         "bridge", "ragdolls"),
                         [](const testing::TestParamInfo<std::string> &info) { return info.param; });

}  // namespace
