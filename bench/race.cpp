#include "race.h"

#include "stopping_rule.h"

#include <algorithm>

namespace bench {

namespace {

// The first engine that works and has the bits that `engine` has: its states must equal that one's own. Null: none has.
const EngineResult *hashReference(const WorldResult &result, const EngineResult &engine) {
    for (const EngineResult &other : result.engines)
        if (engine.sharesBitsWith(other) && !other.failed()) return &other;
    return nullptr;
}

class Race {
public:
    Race(const std::string &world, Competitors &competitors, const RaceSettings &settings)
        : m_competitors(competitors), m_settings(settings) {
        m_result.world = world;
        for (const auto &competitor : competitors)
            m_result.engines.emplace_back().engine = competitor->engine();
    }

    WorldResult run(const std::function<void(const WorldResult &)> &onRound) {
        for (std::size_t i = 0; i < m_competitors.size(); ++i)
            attempt(i, [&] { m_result.engines[i].ready = m_competitors[i]->start(); });
        warmUp();
        while (anyRuns() && goesOn()) {
            round();
            onRound(m_result);
        }
        return std::move(m_result);
    }

private:
    // Runs `action` for engine `i` unless it has failed; a failure is kept as text.
    template <class Action>
    bool attempt(std::size_t i, Action action) {
        if (m_result.engines[i].failed()) return false;
        try {
            action();
            return true;
        } catch (const std::exception &error) {
            m_result.engines[i].failure = error.what();
            return false;
        }
    }

    bool anyRuns() const {
        return std::any_of(m_result.engines.begin(), m_result.engines.end(),
                           [](const EngineResult &engine) { return !engine.failed(); });
    }

    // The first engine that works finds out how many frames the warm-up has; all others repeat them.
    void warmUp() {
        bool found = false;
        for (std::size_t i = 0; i < m_competitors.size(); ++i)
            found = attempt(i, [&] { found ? repeatWarmUp(i) : findWarmUp(i); }) || found;
    }

    void findWarmUp(std::size_t i) {
        double seconds = 0;
        m_result.warmUpFrames = 0;
        for (long frames = 1;
             m_result.warmUpFrames < m_settings.warmUpFrames && seconds < m_settings.warmUpSeconds;
             frames = std::min(2 * frames, m_settings.warmUpFrames - m_result.warmUpFrames)) {
            const Batch batch = m_competitors[i]->run(static_cast<int>(frames));
            m_result.warmUpFrames += frames;
            seconds += secondsOf(batch.seconds, Part::Frame);
            m_fastest = m_slowest = secondsOf(batch.seconds, Part::Frame) / static_cast<double>(frames);
        }
    }

    void repeatWarmUp(std::size_t i) {
        if (m_result.warmUpFrames > 0) m_competitors[i]->run(static_cast<int>(m_result.warmUpFrames));
    }

    bool goesOn() {
        std::vector<RunningAverage> averages;
        for (const EngineResult &engine : m_result.engines)
            if (!engine.failed()) averages.push_back(engine.average(Part::Frame));
        m_result.verdict =
            m_settings.stop.judge(averages, m_result.rounds, m_result.seconds, m_result.frames);
        return m_result.verdict == StoppingRule::Verdict::GoOn;
    }

    void round() {
        const long framesLeft = m_settings.stop.maximumFrames - m_result.frames;
        const int wanted = m_fastest > 0 ? batchSize(m_fastest, m_slowest) : 1;
        const int frames = static_cast<int>(std::min<long>(wanted, framesLeft));
        const std::size_t count = m_competitors.size(),
                          first = static_cast<std::size_t>(m_result.rounds) % count;
        for (std::size_t i = 0; i < count; ++i) runBatch((first + i) % count, frames);
        noteSpeeds();
        ++m_result.rounds;
        m_result.frames += frames;
        compareStates();
    }

    void runBatch(std::size_t i, int frames) {
        attempt(i, [&] {
            const Batch batch = m_competitors[i]->run(frames);
            EngineResult &engine = m_result.engines[i];
            engine.batches.push_back(batch);
            for (Part part : kParts)
                engine.averages[static_cast<std::size_t>(part)].add(frames, secondsOf(batch.seconds, part));
            m_result.seconds += secondsOf(batch.seconds, Part::Frame);
        });
    }

    void noteSpeeds() {
        m_fastest = m_slowest = 0;
        for (const EngineResult &engine : m_result.engines) {
            if (engine.failed()) continue;
            const Batch &last = engine.batches.back();
            const double seconds = secondsOf(last.seconds, Part::Frame) / last.frames;
            m_fastest = m_fastest > 0 ? std::min(m_fastest, seconds) : seconds;
            m_slowest = std::max(m_slowest, seconds);
        }
    }

    void compareStates() {
        for (EngineResult &engine : m_result.engines) {
            if (engine.failed() || engine.firstDifference >= 0) continue;
            const EngineResult *reference = hashReference(m_result, engine);
            if (reference && engine.batches.back().hash != reference->batches.back().hash)
                engine.firstDifference = m_result.warmUpFrames + m_result.frames;
        }
    }

    Competitors &m_competitors;
    const RaceSettings &m_settings;
    WorldResult m_result;
    double m_fastest = 0, m_slowest = 0;  // seconds per frame in the last round; 0: none yet
};

}  // namespace

std::vector<double> EngineResult::seconds(Part part) const {
    std::vector<double> values;
    for (const Batch &batch : batches) values.push_back(secondsOf(batch.seconds, part));
    return values;
}

bool EngineResult::callbacksTimed() const {
    return std::any_of(batches.begin(), batches.end(),
                       [](const Batch &batch) { return batch.seconds.callbacks > 0; });
}

bool EngineResult::sharesBitsWith(const EngineResult &other) const {
    return engine.hasUpstreamsBits() && other.engine.hasUpstreamsBits() && !areOtherReleases(ready.release, other.ready.release);
}

bool WorldResult::hasSeveralReleases() const {
    for (const EngineResult &one : engines)
        for (const EngineResult &other : engines)
            if (areOtherReleases(one.ready.release, other.ready.release)) return true;
    return false;
}

bool WorldResult::callbacksTimed() const {
    return std::any_of(engines.begin(), engines.end(),
                       [](const EngineResult &engine) { return engine.callbacksTimed(); });
}

bool WorldResult::isClean() const {
    return std::none_of(engines.begin(), engines.end(), [](const EngineResult &engine) {
        return engine.failed() || engine.firstDifference >= 0;
    });
}

WorldResult race(const std::string &world, Competitors &competitors, const RaceSettings &settings,
                 const std::function<void(const WorldResult &)> &onRound) {
    return Race(world, competitors, settings).run(onRound);
}

}  // namespace bench
