#include "recorder.h"

#include <utility>

namespace exactness {

namespace {

void readSurface(const dSurfaceParameters &surface, Reading &reading) {
    reading.integer(surface.mode);
    for (dReal value : {surface.mu, surface.mu2, surface.rho, surface.rho2, surface.rhoN, surface.bounce,
                        surface.bounce_vel, surface.soft_erp, surface.soft_cfm, surface.motion1,
                        surface.motion2, surface.motionN, surface.slip1, surface.slip2}) {
        reading.real(value);
    }
}

}  // namespace

Recorder::Recorder(const scenes::Scene &scene, int dumpStep, Order order)
    : m_scene(scene), m_names(scene.inventory()), m_dumpStep(dumpStep), m_order(order) {}

void Recorder::endStage(const char *stage) {
    const std::string text = m_standardError.takeNew();
    if (!text.empty()) {
        Reading reading;
        reading.text(text);
        event("standard error", reading);
    }
    mix(m_sumOfEvents);
    m_sumOfEvents = 0;
    readState(m_scene.inventory(), m_names,
              [this](Kind kind, std::size_t index, const char *field, const Reading &reading) {
                  see(kind, index, field, reading);
              });
    m_record.stages.push_back({m_step, stage, m_hash});
    for (std::size_t i = m_firstOfStage; i < m_record.values.size(); ++i) m_record.values[i].stage = stage;
    m_firstOfStage = m_record.values.size();
    m_events = 0;
}

void Recorder::nearPair(dGeomID o1, dGeomID o2) {
    const std::lock_guard<std::mutex> lock(m_mutex);
    Reading &reading = m_collision;
    reading.clear();
    reading.integer(m_names.of(o1));
    reading.integer(m_names.of(o2));
    collisionEvent("near pair", reading);
}

// The fourth numbers of position and normal are read too: colliders leave them alone, and so must ours.
void Recorder::contact(const dContact &contact) {
    const std::lock_guard<std::mutex> lock(m_mutex);
    Reading &reading = m_collision;
    reading.clear();
    reading.integer(m_names.of(contact.geom.g1));
    reading.integer(m_names.of(contact.geom.g2));
    reading.integer(contact.geom.side1);
    reading.integer(contact.geom.side2);
    const int numbers = m_order == Order::kept ? 4 : 3;
    reading.reals(contact.geom.pos, numbers);
    reading.reals(contact.geom.normal, numbers);
    reading.real(contact.geom.depth);
    reading.reals(contact.fdir1, 3);
    readSurface(contact.surface, reading);
    collisionEvent("contact", reading);
}

void Recorder::bodyMoved(dBodyID body) {
    Reading reading;
    reading.integer(m_names.of(body));
    event("moved body", reading);
}

void Recorder::note(const char *what, double value) {
    Reading reading;
    reading.real(value);
    reading.text(what);
    event("note", reading);
}

Record Recorder::take(const Engine &engine) {
    m_record.engine = engine;
    return std::move(m_record);
}

std::string Recorder::summary() const {
    std::string text;
    for (const auto &[kind, count] : m_seen) text += kind + ": " + std::to_string(count) + ", ";
    return text + "NaN: " + std::to_string(m_notANumber);
}

// A sum does not depend on the order of its terms.
void Recorder::collisionEvent(const char *what, const Reading &reading) {
    if (m_order == Order::kept) {
        event(what, reading);
        return;
    }
    ++m_seen[what];
    const std::uint64_t before = std::exchange(m_hash, 0);
    for (const Word &word : reading.words()) mix(word.bits);
    m_sumOfEvents += m_hash;
    m_hash = before;
}

void Recorder::event(const char *what, const Reading &reading) {
    ++m_seen[what];
    see(Kind::Event, m_events++, what, reading);
}

void Recorder::see(Kind kind, std::size_t index, const char *field, const Reading &reading) {
    mix(static_cast<std::uint64_t>(kind));
    mix(index);
    mix(reading.words().size());
    for (const Word &word : reading.words()) {
        mix(word.bits);
        if (isNaN(word)) ++m_notANumber;
    }
    mix(reading.text().size());
    for (unsigned char c : reading.text()) mix(c);
    if (m_step != m_dumpStep) return;
    m_record.values.push_back({"", std::string(toString(kind)) + ' ' + std::to_string(index), field,
                               reading.words(), reading.text()});
}

// Multiplication by an odd constant and the shift are both one-to-one: no difference is lost in one step.
void Recorder::mix(std::uint64_t bits) {
    m_hash = (m_hash ^ bits) * 0x9e3779b97f4a7c15u;
    m_hash ^= m_hash >> 32;
}

}  // namespace exactness
