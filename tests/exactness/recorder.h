// Watches a scene and fills a record.
//
// Events (near pairs, contacts, moved-callbacks, notes, text on standard error) are hashed in the order
// in which they come, into the stage in which they come; the state is hashed at the end of each stage.
// For callbacks that run on several threads the order of near pairs and contacts is ignored, and so are the
// numbers that colliders leave as they find them in the caller's memory.
#pragma once

#include "fields.h"
#include "record.h"
#include "standard_error.h"

#include <map>
#include <mutex>

namespace exactness {

class Recorder final : public scenes::Observer {
public:
    static constexpr int noStep = -1;

    enum class Order { kept, ignored };

    // `dumpStep`: the step whose values are kept, or noStep.
    Recorder(const scenes::Scene &scene, int dumpStep, Order order = Order::kept);

    void beginStep(int step) { m_step = step; }
    void endStage(const char *stage);

    void nearPair(dGeomID o1, dGeomID o2) override;
    void contact(const dContact &contact) override;
    void bodyMoved(dBodyID body) override;
    void note(const char *what, double value) override;

    Record take(const Engine &engine);

    // How much there was to see, for people: "32 contacts, 40 near pairs, ...".
    std::string summary() const;

private:
    void event(const char *what, const Reading &reading);
    void collisionEvent(const char *what, const Reading &reading);
    void see(Kind kind, std::size_t index, const char *field, const Reading &reading);
    void mix(std::uint64_t bits);

    const scenes::Scene &m_scene;
    Names m_names;
    StandardError m_standardError;
    int m_dumpStep;
    int m_step = 0;
    std::size_t m_events = 0;                   // in this stage
    std::size_t m_firstOfStage = 0;             // the first value kept of this stage
    std::map<std::string, std::size_t> m_seen;  // events by kind
    std::size_t m_notANumber = 0;               // words
    std::uint64_t m_hash = 0;
    Order m_order;
    std::mutex m_mutex;                // near pairs and contacts may come on several threads
    Reading m_collision;               // the near pair or contact at hand; its memory is kept
    std::uint64_t m_sumOfEvents = 0;   // of this stage, with Order::ignored
    Record m_record;
};

}  // namespace exactness
