#include "competitor.h"

#include <filesystem>
#include <optional>

#include "tool_output.h"
#include "library_folders.h"
#include "support/temporary_folder.h"

namespace bench {

namespace {

// A folder in which the loader finds an engine's library as libode.so.8: that of the library, or while this object lives one with a
// link, where the file has another name or the loader would take the folder's for several.
class LibraryFolder {
public:
    LibraryFolder(const Engine &engine, const ChildSettings &settings) : m_path(engine.isOurs() ? settings.oursFolder : settings.stockFolder) {
        if (engine.path.empty()) return;
        const std::filesystem::path file = std::filesystem::absolute(libraryAt(engine.path));
        m_path = file.parent_path();
        if (file.filename() == "libode.so.8" && m_path.find_first_of(":;$") == std::string::npos) return;
        m_made.emplace("odemt_bench");
        m_path = addLibrary(*m_made, "stock", file);
    }

    const std::string &path() const { return m_path; }

private:
    std::string m_path;
    std::optional<support::TemporaryFolder> m_made;
};

}  // namespace

// The child has loaded its library when it answers.
Ready ChildCompetitor::start() {
    const LibraryFolder folder(engine(), m_settings);
    m_process = std::make_unique<support::LineProcess>(command(), environment(folder.path()));
    const Ready ready = readReady(answer(m_settings.whileLoading));
    check(ready);
    return ready;
}

Batch ChildCompetitor::run(int frames) {
    m_process->writeLine(writeRequest(frames));
    return readBatch(answer());
}

std::string ChildCompetitor::answer(const std::function<void()> &whileWaiting) {
    try {
        return m_process->readLine(m_settings.limit, whileWaiting);
    } catch (const support::LineProcessError &) {
        m_process.reset();  // a child that hangs must not go on beside the others
        throw;
    }
}

std::vector<std::string> ChildCompetitor::command() const {
    std::vector<std::string> command = {m_settings.program, "--world", m_world};
    if (engine().kind == Engine::Kind::StockPool) command.insert(command.end(), {"--pool", engine().threads});
    if (m_settings.ignoreUnsupported) command.push_back("--ignore-unsupported");
    if (m_settings.timeCallbacks) command.push_back("--time-callbacks");
    if (m_settings.serialShare) command.push_back("--serial-share");
    return command;
}

support::Environment ChildCompetitor::environment(const std::string &libraryFolder) const {
    // Nothing that the user has set for other programs may reach one engine and not the other.
    support::Environment changes;
    for (const std::string &name : libraryVariables()) changes[name] = "";
    for (const auto &[name, value] : engine().environment()) changes[name] = value;
    if (engine().isOurs() && !m_settings.traceFile.empty()) changes["ODE_MT_TRACE"] = m_settings.traceFile;
    changes["LD_LIBRARY_PATH"] = libraryFolder;
    return changes;
}

// Its library writes the file when the child ends, which is killed otherwise.
void ChildCompetitor::endTrace() {
    if (m_process == nullptr || !engine().isOurs() || m_settings.traceFile.empty()) return;
    try {
        m_process->writeEnd();
        m_process->waitForExit();
    } catch (const support::LineProcessError &error) {
        printError("no trace of " + engine().name() + ": " + error.what());
    }
}

// The child says which library and settings it really got.
void ChildCompetitor::check(const Ready &ready) const {
    if (ready.isOurs != engine().isOurs())
        throw std::runtime_error("runs on " + ready.library + ", which is " +
                                 (ready.isOurs ? "ODE_MT" : "not ODE_MT"));
    // The loader passes over a library of another kind of processor, and takes the system's.
    std::error_code ignored;
    if (!engine().path.empty() && !std::filesystem::equivalent(ready.library, libraryAt(engine().path), ignored))
        throw std::runtime_error("runs on " + ready.library + ", not on " + libraryAt(engine().path));
    if (!engine().isOurs()) return;
    if (engine().threads != "auto" && std::to_string(ready.threads) != engine().threads)
        throw std::runtime_error("the library uses " + std::to_string(ready.threads) + " threads");
    if (!engine().manager.empty() && ready.manager != engine().manager)
        throw std::runtime_error("the library uses the thread manager '" + ready.manager + "'");
    if (!engine().algorithm.empty() && ready.algorithm != engine().algorithm)
        throw std::runtime_error("the library uses the algorithm '" + ready.algorithm + "'");
    if (!engine().callbacks.empty() && ready.callbacks != engine().callbacks)
        throw std::runtime_error("the library uses the callback policy '" + ready.callbacks + "'");
    if (!engine().gridCells.empty() && std::to_string(ready.gridCells) != engine().gridCells)
        throw std::runtime_error("the library uses a grid of " + std::to_string(ready.gridCells) +
                                 " cells on each axis");
}

}  // namespace bench
