#include "observer.h"

#include <pthread.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "body_states.h"

namespace observer {

namespace {

using Lock = std::lock_guard<std::mutex>;
using Clock = std::chrono::steady_clock;

// 0: not set.
std::uint64_t stepNamed(const char *variable) {
    const char *const text = std::getenv(variable);
    return text != nullptr ? std::strtoull(text, nullptr, 10) : 0;
}

const std::uint64_t g_dumpStep = stepNamed(check::kDumpVariable), g_lastStep = stepNamed(check::kLastVariable);

// What the program has printed comes out, but nothing of it runs any more: it might step on.
[[noreturn]] void endProcess() {
    std::fflush(nullptr);
    _exit(0);
}

}  // namespace

void Observer::openFile(const OdeLibrary &library) {
    m_file.open(library);
    m_file.setHasOneMaker(m_hasOneMaker);
}

Observer::World &Observer::add(const OdeLibrary &library, dxWorld *world) {
    if (m_worldsCreated == 0) m_maker = pthread_self();
    if (pthread_equal(m_maker, pthread_self()) == 0) m_hasOneMaker = false;
    openFile(library);
    std::unique_ptr<World> &place = m_worlds[world];
    place = std::make_unique<World>();
    place->number = m_worldsCreated++;
    return *place;
}

// A world whose creation was not seen has those bodies that are created from now on.
Observer::World &Observer::find(const OdeLibrary &library, dxWorld *world) {
    const auto found = m_worlds.find(world);
    return found != m_worlds.end() ? *found->second : add(library, world);
}

void Observer::worldCreated(const OdeLibrary &library, dxWorld *world) {
    const Lock lock(m_mutex);
    add(library, world);
}

void Observer::worldDestroyed(dxWorld *world) {
    const Lock lock(m_mutex);
    m_worlds.erase(world);
}

void Observer::bodyCreated(const OdeLibrary &library, dxWorld *id, dxBody *body) {
    const Lock lock(m_mutex);
    World &world = find(library, id);
    world.places[body] = world.bodies.size();
    world.bodies.push_back({body, world.bodiesCreated++});
}

// Bodies of a world that is destroyed come here, too, and find no world.
void Observer::bodyDestroyed(dxWorld *id, dxBody *body) {
    const Lock lock(m_mutex);
    const auto found = m_worlds.find(id);
    if (found == m_worlds.end()) return;
    World &world = *found->second;
    const auto place = world.places.find(body);
    if (place == world.places.end()) return;
    world.bodies[place->second].id = nullptr;
    world.places.erase(place);
    if (world.bodies.size() > 2 * world.places.size() + 16) leaveOutDestroyed(world);
}

void Observer::leaveOutDestroyed(World &world) {
    std::size_t count = 0;
    for (const Body &body : world.bodies) {
        if (body.id == nullptr) continue;
        world.places[body.id] = count;
        world.bodies[count++] = body;
    }
    world.bodies.resize(count);
}

void Observer::record(const OdeLibrary &library, World &world, const StepCall &call) {
    ++world.steps;
    if (!library.isDouble) return;
    BodyStates states(library, {world.number,
                                world.steps,
                                world.places.size(),
                                {bitsOf(call.stepSize), call.isQuickStep, static_cast<std::uint64_t>(call.result)}});
    const bool isDumped = world.steps == g_dumpStep;
    if (isDumped) states.keep();
    for (const Body &body : world.bodies)
        if (body.id != nullptr) states.add(body.id, body.number);
    const Lock lock(m_mutex);
    if (isDumped) m_file.writeStates(states.kept());
    m_file.write({world.number, static_cast<std::uint32_t>(world.places.size()), world.steps, states.hash()});
}

void Observer::stepped(const OdeLibrary &library, dxWorld *id, const StepCall &call, std::chrono::nanoseconds duration) {
    const Clock::time_point start = Clock::now();
    World *world;
    {
        const Lock lock(m_mutex);
        world = &find(library, id);
        openFile(library);  // the first step behind a fork
    }
    record(library, *world, call);
    const bool isLast = world->steps == g_lastStep;
    {
        const Lock lock(m_mutex);
        m_file.addTimes(duration, Clock::now() - start);
    }
    if (isLast) endProcess();
}

void Observer::afterForkInChild() {
    m_file.leaveToParent();
    m_mutex.unlock();
}

void Observer::ending() {
    const Lock lock(m_mutex);
    if (m_worldsCreated == 0) listObjects();
}

Observer &theObserver() {
    static auto *const observer = new Observer;
    return *observer;
}

namespace {

[[gnu::constructor]] void loaded() {
    markLoaded();
    pthread_atfork([] { theObserver().beforeFork(); }, [] { theObserver().afterForkInParent(); },
                   [] { theObserver().afterForkInChild(); });
}

[[gnu::destructor]] void unloaded() { theObserver().ending(); }

}  // namespace

}  // namespace observer
