#include "batch/world_run.h"

#include "batch/parameter.h"
#include "loader/load_world.h"
#include "protocol.h"
#include "scenes/generator.h"
#include "scenes/state_hash.h"
#include "support/text_file.h"
#include "world_source.h"

#include <algorithm>
#include <cstdarg>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>

namespace batch {

namespace {

using Clock = std::chrono::steady_clock;

const char *const kIgnoreUnsupported = "\"ignore_unsupported\": true in the plan";

std::unique_ptr<scenes::Scene> openChanged(const Plan &plan, const Run &run, std::vector<std::string> &warnings) {
    const bench::WorldSpec spec = bench::readWorldSpec(run.world);
    worlds::LoadOptions options = bench::loadOptions(spec);
    options.ignoreUnsupported = plan.ignoreUnsupported;
    options.ignoringOption = kIgnoreUnsupported;
    options.warnings = &warnings;
    const std::string name = worlds::findWorld(spec.name);
    Values values = run.values;
    values.emplace_back("seed", run.seed);
    return worlds::loadWorldText(changeElements(support::readTextFile(name), name, values), name, options);
}

std::unique_ptr<scenes::Scene> open(const Plan &plan, const Run &run) {
    std::vector<std::string> warnings;
    return changesElements(run.values) ? openChanged(plan, run, warnings)
                                       : bench::openWorld(run.world, {plan.ignoreUnsupported, kIgnoreUnsupported}, warnings);
}

// Bodies that can be pushed.
void perturb(const scenes::Scene &scene, const Perturbation &perturbation, std::uint32_t seed) {
    if (perturbation.position == 0 && perturbation.velocity == 0) return;
    scenes::Generator random(seed);
    const auto around = [&random](const dReal *vector, double most, dReal *out) {
        for (int axis = 0; axis < 3; ++axis) out[axis] = vector[axis] + random.between(static_cast<dReal>(-most), static_cast<dReal>(most));
    };
    for (const dBodyID body : scene.inventory().bodies) {
        if (dBodyIsKinematic(body) != 0) continue;
        dVector3 vector;
        around(dBodyGetPosition(body), perturbation.position, vector);
        if (perturbation.position > 0) dBodySetPosition(body, vector[0], vector[1], vector[2]);
        around(dBodyGetLinearVel(body), perturbation.velocity, vector);
        if (perturbation.velocity > 0) dBodySetLinearVel(body, vector[0], vector[1], vector[2]);
    }
}

class Watched {
public:
    Watched(const Observable &observable, const scenes::Scene &scene) : m_over(observable.over), m_read(findReading(observable, scene)) {}

    void look() {
        if (m_over == Observable::Over::End) return;
        const double value = m_read();
        m_value = m_count++ == 0                     ? value
                  : m_over == Observable::Over::Max ? std::max(m_value, value)
                  : m_over == Observable::Over::Min ? std::min(m_value, value)
                                                    : m_value + value;
    }

    double value() const {
        if (m_over == Observable::Over::End) return m_read();
        return m_over == Observable::Over::Mean ? m_value / static_cast<double>(m_count) : m_value;
    }

private:
    Observable::Over m_over;
    std::function<double()> m_read;
    double m_value = 0;
    long m_count = 0;
};

// In its decimal form a number is the same again when it is read; JSON has none for what is not finite.
Json numberOf(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? Json() : Json(value > 0 ? "inf" : "-inf");
}

std::string hashOf(const scenes::Scene &scene) { return bench::hashText(scenes::stateHash(scene.inventory())); }

long framesOf(const Plan &plan, const scenes::Scene &scene) {
    if (plan.frames > 0) return plan.frames;
    const double frames = plan.seconds / static_cast<double>(scene.stepSize());
    if (!(frames <= static_cast<double>(Plan::kMaxFrames)))
        fail("seconds", "are more than " + std::to_string(Plan::kMaxFrames) + " frames");
    return std::max(1L, std::lround(frames));
}

struct FrameTimes {
    double sum = 0, most = 0;
    void add(double seconds) {
        sum += seconds;
        most = std::max(most, seconds);
    }
};

void addStates(long frame, const scenes::Scene &scene, Json &states) {
    const std::vector<dBodyID> &bodies = scene.inventory().bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Json row = {frame, i};
        const auto add = [&row](const dReal *numbers, int count) {
            for (int k = 0; k < count; ++k) row.push_back(numberOf(static_cast<double>(numbers[k])));
        };
        add(dBodyGetPosition(bodies[i]), 3);
        add(dBodyGetQuaternion(bodies[i]), 4);
        add(dBodyGetLinearVel(bodies[i]), 3);
        add(dBodyGetAngularVel(bodies[i]), 3);
        states.push_back(std::move(row));
    }
}

Json play(const Plan &plan, const Run &run, scenes::Scene &scene) {
    std::vector<Watched> watched, series;
    for (const Observable &observable : plan.observables) watched.emplace_back(observable, scene);
    for (const Observable &observable : plan.series) series.emplace_back(observable, scene);
    Json rows = Json::array(), states = Json::array();
    FrameTimes times;
    const long frames = framesOf(plan, scene);
    for (long frame = 1; frame <= frames; ++frame) {
        const Clock::time_point begin = Clock::now();
        scene.frame();
        times.add(std::chrono::duration<double>(Clock::now() - begin).count());
        for (Watched &each : watched) each.look();
        if (plan.every == 0 || frame % plan.every != 0) continue;
        Json row = {frame, scene.time(), hashOf(scene)};
        for (const Watched &each : series) row.push_back(numberOf(each.value()));
        rows.push_back(std::move(row));
        if (plan.hasStates) addStates(frame, scene, states);
    }
    Json values = Json::array();
    for (const Watched &each : watched) values.push_back(numberOf(each.value()));
    return {{"run", run.number},
            {"status", "done"},
            {"frames", frames},
            {"time", scene.time()},
            {"hash", hashOf(scene)},
            {"values", values},
            {"series", rows},
            {"states", states},
            {"mean_ms", 1e3 * times.sum / static_cast<double>(frames)},
            {"max_ms", 1e3 * times.most}};
}

void ignoreMessage(int, const char *, va_list) {}

}  // namespace

void initialiseOde(dMessageFunction *endByError) {
    dInitODE2(0);
    dSetErrorHandler(endByError);
    dSetDebugHandler(endByError);
    dSetMessageHandler(ignoreMessage);
}

Json failedRun(long number, const std::string &message) { return {{"run", number}, {"status", "error"}, {"message", message}}; }

void tryWorld(const Plan &plan, const Run &run) {
    const std::unique_ptr<scenes::Scene> scene = open(plan, run);
    setProperties(*scene, run.values);
    for (const Observable &observable : plan.observables) try {
            findReading(observable, *scene);
        } catch (const ObservableError &error) {
            throw ObservableError("plan: observables." + observable.name + ": " + error.what());
        }
    framesOf(plan, *scene);
}

Json runWorld(const Plan &plan, const Run &run) try {
    const std::unique_ptr<scenes::Scene> scene = open(plan, run);
    setProperties(*scene, run.values);
    perturb(*scene, plan.perturbation, run.seed);
    dRandSetSeed(run.seed);
    return play(plan, run, *scene);
} catch (const std::exception &error) {
    return failedRun(run.number, error.what());
}

}  // namespace batch
