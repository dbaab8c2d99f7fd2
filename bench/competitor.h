// One engine at work on one world.
#pragma once

#include <functional>
#include <memory>

#include "engine.h"
#include "protocol.h"
#include "support/process.h"

namespace bench {

class Competitor {
public:
    explicit Competitor(Engine engine) : m_engine(std::move(engine)) {}
    virtual ~Competitor() = default;

    const Engine &engine() const { return m_engine; }

    // Each throws std::runtime_error if the engine fails; it is not asked again then.
    virtual Ready start() = 0;
    virtual Batch run(int frames) = 0;

private:
    Engine m_engine;
};

struct ChildSettings {
    std::string program;                                        // odemt_bench_child
    std::string stockFolder;                                    // of the system's libode.so.8
    std::string oursFolder;                                     // of ours
    std::chrono::milliseconds limit = std::chrono::minutes(2);  // for one answer
    bool ignoreUnsupported = false;                             // elements of an SDF world
    bool timeCallbacks = false, serialShare = false;
    std::string traceFile;  // of ours; empty: none
    std::function<void()> whileLoading;  // called some times a second
};

// An engine in a process of its own: the same program, odemt_bench_child, for every engine.
// LD_LIBRARY_PATH decides which libode.so.8 it gets.
class ChildCompetitor final : public Competitor {
public:
    ChildCompetitor(const Engine &engine, const std::string &world, const ChildSettings &settings)
        : Competitor(engine), m_world(world), m_settings(settings) {}
    ~ChildCompetitor() override { endTrace(); }

    Ready start() override;
    Batch run(int frames) override;

private:
    std::string answer(const std::function<void()> &whileWaiting = {});
    std::vector<std::string> command() const;
    support::Environment environment(const std::string &libraryFolder) const;
    void check(const Ready &ready) const;
    void endTrace();

    std::string m_world;
    ChildSettings m_settings;
    std::unique_ptr<support::LineProcess> m_process;
};

}  // namespace bench
