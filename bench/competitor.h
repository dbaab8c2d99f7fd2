// One engine at work on one world.
#pragma once

#include "engine.h"
#include "protocol.h"

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

}  // namespace bench
