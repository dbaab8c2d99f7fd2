// odemt_bench_child: runs one world on the libode.so.8 that the loader finds, batch by batch, as
// protocol.h says. odemt_bench starts it; by hand:
//   echo '{"frames":100}' | ODE_MT_THREADS=2 LD_LIBRARY_PATH=build/release/lib odemt_bench_child --world
//   stacks:10
// The exit code is 0, 1 after an error, 2 for a wrong option.
#include "callback_timer.h"
#include "tool_output.h"
#include "platform.h"
#include "command_line.h"
#include "protocol.h"
#include "scenes/state_hash.h"
#include "world_source.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <vector>

namespace {

// Upstream's own thread pool, lent to all worlds of a scene while this object lives.
class StockPool {
public:
    // Throws std::runtime_error if the library was built without threads.
    StockPool(const scenes::Inventory &inventory, unsigned threads);
    ~StockPool();
    StockPool(const StockPool &) = delete;
    StockPool &operator=(const StockPool &) = delete;

private:
    std::vector<dWorldID> m_worlds;
    dThreadingImplementationID m_threading;
    dThreadingThreadPoolID m_pool;
};

StockPool::StockPool(const scenes::Inventory &inventory, unsigned threads)
    : m_worlds(inventory.worlds),
      m_threading(dThreadingAllocateMultiThreadedImplementation()),
      m_pool(dThreadingAllocateThreadPool(threads, 0, dAllocateFlagBasicData, nullptr)) {
    if (!m_threading || !m_pool) throw std::runtime_error("this libode.so.8 has no thread pool");
    dThreadingThreadPoolServeMultiThreadedImplementation(m_pool, m_threading);
    for (dWorldID world : m_worlds)
        dWorldSetStepThreadingImplementation(world, dThreadingImplementationGetFunctions(m_threading),
                                             m_threading);
}

StockPool::~StockPool() {
    dThreadingImplementationShutdownProcessing(m_threading);
    dThreadingFreeThreadPool(m_pool);
    for (dWorldID world : m_worlds) dWorldSetStepThreadingImplementation(world, nullptr, nullptr);
    dThreadingFreeImplementation(m_threading);
}

unsigned messageCount = 0;

// Messages are counted, not printed: a wall of them would be timed as well.
void countMessage(int, const char *, va_list) { ++messageCount; }

bench::Ready describe(const bench::LibraryProbe &library, const scenes::Scene &scene,
                      const std::vector<std::string> &warnings) {
    bench::Ready ready;
    ready.library = library.file;
    ready.isOurs = library.isOurs;
    ready.release = library.release();
    ready.threads = library.threads();
    ready.manager = library.manager();
    ready.algorithm = library.algorithm();
    ready.callbacks = library.callbacks();
    ready.gridCells = library.gridCells();
    ready.bodies = scene.inventory().bodies.size();
    ready.joints = scene.inventory().joints.size();
    ready.geoms = scene.inventory().geoms.size();
    ready.stepSize = static_cast<double>(scene.stepSize());
    ready.warnings = warnings;
    return ready;
}

bench::StageTimes timedFrame(scenes::Scene &scene) {
    using Clock = std::chrono::steady_clock;
    const auto seconds = [](Clock::time_point from, Clock::time_point to) {
        return std::chrono::duration<double>(to - from).count();
    };
    const Clock::time_point start = Clock::now();
    scene.control();
    const Clock::time_point controlled = Clock::now();
    scene.collide();
    const Clock::time_point collided = Clock::now();
    scene.step();
    const Clock::time_point stepped = Clock::now();
    scene.finish();
    const Clock::time_point finished = Clock::now();
    const bench::CallbackTimes times = bench::takeCallbackTimes();
    return {seconds(start, controlled), seconds(controlled, collided) - times.timing,
            seconds(collided, stepped), seconds(stepped, finished), times.callbacks};
}

bench::SerialWork workOfLastFrame(const scenes::Scene &scene, const bench::LibraryProbe &library) {
    bench::SerialWork work;
    for (const dWorldID world : scene.inventory().worlds) work += library.workOf(world);
    return work;
}

bench::Batch runBatch(scenes::Scene &scene, const bench::LibraryProbe &library, int frames, bool serialShare) {
    bench::Batch batch;
    batch.frames = frames;
    messageCount = 0;
    const unsigned sharedBefore = library.sharedSteps();
    for (int i = 0; i < frames; ++i) {
        const bench::StageTimes times = timedFrame(scene);
        batch.seconds += times;
        batch.frameTimes.add(bench::secondsOf(times, bench::Part::Frame));
        if (serialShare) batch.work += workOfLastFrame(scene, library);
    }
    batch.sharedSteps = library.sharedSteps() - sharedBefore;
    batch.messages = messageCount;
    batch.contacts = scene.contactCount();
    batch.hash = scenes::stateHash(scene.inventory());
    return batch;
}

std::unique_ptr<scenes::Scene> load(const std::string &world, bool ignoreUnsupported, std::vector<std::string> &warnings) {
    const bench::ReaderWatch watch;
    return bench::openWorld(world, {ignoreUnsupported}, warnings);
}

void serve(const std::string &world, unsigned poolThreads, bool ignoreUnsupported, bool serialShare) {
    const bench::LibraryProbe library = bench::probeLibrary();
    std::vector<std::string> warnings;
    const std::unique_ptr<scenes::Scene> scene = load(world, ignoreUnsupported, warnings);
    std::optional<StockPool> pool;
    if (poolThreads > 0) pool.emplace(scene->inventory(), poolThreads);

    bench::print(bench::writeReady(describe(library, *scene, warnings)) + "\n");
    for (std::string line; std::getline(std::cin, line);)
        bench::print(bench::writeBatch(runBatch(*scene, library, bench::readRequest(line), serialShare)) + "\n");
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    CLI::App app("Runs one world on one engine for odemt_bench.");
    std::string world;
    unsigned poolThreads = 0;
    bool ignoreUnsupported = false, timeCallbacks = false, serialShare = false;
    app.add_option("--world", world, "SDF world or scene")->required();
    app.add_option("--pool", poolThreads, "threads of upstream's own pool; 0: none")->check(bench::wholeNumberIn(0, 1024));
    app.add_flag("--ignore-unsupported", ignoreUnsupported, "leave out what the SDF loader does not know");
    app.add_flag("--time-callbacks", timeCallbacks, "time near-callbacks apart");
    app.add_flag("--serial-share", serialShare, "tell which part of the work is one thread's");
    int code = 0;
    if (!bench::readCommandLine(app, [&] { app.parse(argc, argv); }, code)) return bench::exitCodeAfterOutput(code);

    bench::setCallbackTiming(timeCallbacks);
    dInitODE2(0);
    dSetMessageHandler(countMessage);
    try {
        serve(world, poolThreads, ignoreUnsupported, serialShare);
    } catch (const std::exception &error) {
        if (!(std::cout << bench::writeError(error.what()) << std::endl)) bench::printError(error.what());
        code = 1;
    }
    dCloseODE();
    return code;
}
