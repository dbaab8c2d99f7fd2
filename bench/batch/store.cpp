#include "batch/store.h"
#include "support/text.h"

#include <fcntl.h>
#include <sqlite3.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <stdexcept>

namespace batch {

namespace {

enum StatementIndex { kRuns, kSeries, kStates, kTimes };

// Tables of another layout are not gone on with.
constexpr const char *kLayout = "1";

void bindValue(sqlite3_stmt *statement, int place, const Json &value) {
    if (value.is_number_integer())
        sqlite3_bind_int64(statement, place, value.get<sqlite3_int64>());
    else if (value.is_number())
        sqlite3_bind_double(statement, place, value.get<double>());
    else if (value.is_boolean())
        sqlite3_bind_int64(statement, place, value.get<bool>() ? 1 : 0);
    else if (value == "inf" || value == "-inf")
        sqlite3_bind_double(statement, place, value == "inf" ? HUGE_VAL : -HUGE_VAL);
    else if (value.is_string())
        sqlite3_bind_text(statement, place, value.get_ref<const std::string &>().c_str(), -1, SQLITE_TRANSIENT);
    else
        sqlite3_bind_null(statement, place);
}

std::string places(std::size_t count) {
    std::string text = "?";
    for (std::size_t i = 1; i < count; ++i) text += ",?";
    return "(" + text + ")";
}

}  // namespace

// Of the file itself, so that its names by links are one, and it hinders nobody after a kill. SQLite's own locks are of another kind (fcntl), but end
// when the process closes the file: the database is closed first.
class Store::Lock {
public:
    explicit Lock(const std::string &file) : m_file(open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
        if (m_file < 0) throw std::runtime_error(file + ": " + std::strerror(errno));
        if (flock(m_file, LOCK_EX | LOCK_NB) == 0) return;
        ::close(m_file);
        throw std::runtime_error(file + ": another odemt_batch writes to it");
    }
    ~Lock() { ::close(m_file); }
    Lock(const Lock &) = delete;
    Lock &operator=(const Lock &) = delete;

private:
    int m_file;
};

namespace {

// Beside the file while it is open.
void removeDatabase(const std::string &file) {
    for (const char *const end : {"", "-wal", "-shm", "-journal"}) unlink((file + end).c_str());
}

}  // namespace

Store::Store(const std::string &file, const Plan &plan, Begin begin) : m_file(file), m_plan(plan), m_database(nullptr, sqlite3_close) {
    const bool isThere = access(file.c_str(), F_OK) == 0;
    if (isThere && begin == Begin::New) throw std::runtime_error(file + ": exists; --resume goes on with it");
    m_lock = std::make_unique<Lock>(file);
    try {
        openDatabase();
    } catch (...) {
        m_statements.clear();
        m_database.reset();
        if (!isThere) removeDatabase(file);
        throw;
    }
}

void Store::openDatabase() {
    sqlite3 *database = nullptr;
    const std::string path = std::filesystem::absolute(m_file);  // some names mean no file to SQLite: ':memory:', 'file:…'
    const int opened = sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr);
    m_database.reset(database);
    if (opened != SQLITE_OK) fail();
    sqlite3_busy_timeout(database, 60000);  // ms: a reader may hold a lock for a moment
    // What a kill leaves is whole with NORMAL, too; a power cut may cost the last transactions.
    execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
    createTables();
    checkPlan();
    m_statements.push_back(prepare("INSERT OR IGNORE INTO runs VALUES " + places(8 + m_plan.parameters.size() + m_plan.observables.size())));
    m_statements.push_back(prepare("INSERT OR IGNORE INTO series VALUES " + places(4 + m_plan.series.size())));
    m_statements.push_back(prepare("INSERT OR IGNORE INTO states VALUES " + places(16)));
    m_statements.push_back(prepare("INSERT OR REPLACE INTO times VALUES " + places(6)));
}

Store::~Store() = default;

void Store::close() {
    m_statements.clear();
    if (sqlite3_close(m_database.get()) != SQLITE_OK) fail();
    static_cast<void>(m_database.release());
}

void Store::fail() const {
    throw std::runtime_error(m_file + ": " + (m_database != nullptr ? sqlite3_errmsg(m_database.get()) : "too little memory"));
}

void Store::execute(const std::string &sql) const {
    if (sqlite3_exec(m_database.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

Store::Statement Store::prepare(const std::string &sql) const {
    sqlite3_stmt *statement = nullptr;
    if (sqlite3_prepare_v2(m_database.get(), sql.c_str(), -1, &statement, nullptr) != SQLITE_OK) fail();
    return {statement, sqlite3_finalize};
}

void Store::step(sqlite3_stmt *statement) const {
    if (sqlite3_step(statement) != SQLITE_DONE) fail();
    sqlite3_reset(statement);
}

void Store::createTables() {
    std::string parameters, observables, series;
    for (const Parameter &parameter : m_plan.parameters) parameters += ", " + support::doubleQuoted(parameter.name);
    for (const Observable &observable : m_plan.observables) observables += ", " + support::doubleQuoted(observable.name);
    for (const Observable &observable : m_plan.series) series += ", " + support::doubleQuoted(observable.name);
    execute(
        "BEGIN IMMEDIATE;"
        "CREATE TABLE IF NOT EXISTS plan (key TEXT PRIMARY KEY, value TEXT);"
        "CREATE TABLE IF NOT EXISTS runs (run INTEGER PRIMARY KEY, world TEXT" +
        parameters + ", seed INTEGER, status TEXT, message TEXT, frames INTEGER, time REAL, hash TEXT" + observables +
        ");"
        "CREATE TABLE IF NOT EXISTS series (run INTEGER, frame INTEGER, time REAL, hash TEXT" +
        series +
        ", PRIMARY KEY (run, frame)) WITHOUT ROWID;"
        "CREATE TABLE IF NOT EXISTS states (run INTEGER, frame INTEGER, body INTEGER, x REAL, y REAL, z REAL, qw REAL, qx REAL, qy REAL, qz REAL,"
        " vx REAL, vy REAL, vz REAL, wx REAL, wy REAL, wz REAL, PRIMARY KEY (run, frame, body)) WITHOUT ROWID;"
        "CREATE TABLE IF NOT EXISTS times (run INTEGER PRIMARY KEY, seconds REAL, mean_ms REAL, max_ms REAL, rank INTEGER, worker INTEGER);"
        "INSERT OR IGNORE INTO plan VALUES ('layout', '" +
        std::string(kLayout) + "'), ('fingerprint', '" + m_plan.fingerprint +
        "');"
        "COMMIT");
    const Statement text = prepare("INSERT OR IGNORE INTO plan VALUES ('plan', ?)");
    sqlite3_bind_text(text.get(), 1, m_plan.text.c_str(), -1, SQLITE_STATIC);
    step(text.get());
}

void Store::checkPlan() const {
    const Statement statement = prepare("SELECT value FROM plan WHERE key IN ('layout', 'fingerprint') ORDER BY key");
    std::vector<std::string> values;
    while (sqlite3_step(statement.get()) == SQLITE_ROW) values.emplace_back(reinterpret_cast<const char *>(sqlite3_column_text(statement.get(), 0)));
    if (values != std::vector<std::string>{m_plan.fingerprint, kLayout})
        throw std::runtime_error(m_file + ": is the table of another plan, or worlds of the plan have changed");
}

std::vector<bool> Store::done() const {
    std::vector<bool> done(static_cast<std::size_t>(m_plan.count()));
    const Statement statement = prepare("SELECT run FROM runs");
    while (sqlite3_step(statement.get()) == SQLITE_ROW) {
        const auto run = static_cast<std::size_t>(sqlite3_column_int64(statement.get(), 0));
        if (run < done.size()) done[run] = true;
    }
    return done;
}

Store::Failed Store::failed() const {
    const Statement statement = prepare("SELECT count(*) OVER (), run, message FROM runs WHERE status = 'error' ORDER BY run LIMIT 1");
    if (sqlite3_step(statement.get()) != SQLITE_ROW) return {};
    const auto *const message = reinterpret_cast<const char *>(sqlite3_column_text(statement.get(), 2));
    return {static_cast<long>(sqlite3_column_int64(statement.get(), 0)), static_cast<long>(sqlite3_column_int64(statement.get(), 1)),
            message != nullptr ? message : ""};
}

void Store::writeRows(sqlite3_stmt *statement, long run, const Json &rows) {
    for (const Json &row : rows) {
        sqlite3_bind_int64(statement, 1, run);
        for (std::size_t i = 0; i < row.size(); ++i) bindValue(statement, static_cast<int>(i) + 2, row[i]);
        step(statement);
    }
}

void Store::writeLine(const Json &line) {
    const Run run = m_plan.run(line.at("run").get<long>());
    Json values = Json::array();
    values.push_back(run.number);
    values.push_back(run.world);
    for (const auto &[name, value] : run.values) values.push_back(value);
    values.push_back(run.seed);
    for (const char *const key : {"status", "message", "frames", "time", "hash"}) values.push_back(line.value(key, Json()));
    const Json observed = line.value("values", Json::array());
    for (std::size_t i = 0; i < m_plan.observables.size(); ++i) values.push_back(i < observed.size() ? observed[i] : Json());
    sqlite3_stmt *const runs = m_statements[kRuns].get();
    for (std::size_t i = 0; i < values.size(); ++i) bindValue(runs, static_cast<int>(i) + 1, values[i]);
    step(runs);
    writeRows(m_statements[kSeries].get(), run.number, line.value("series", Json::array()));
    writeRows(m_statements[kStates].get(), run.number, line.value("states", Json::array()));
    Json times = Json::array();
    for (const char *const key : {"seconds", "mean_ms", "max_ms", "rank", "worker"}) times.push_back(line.value(key, Json()));
    writeRows(m_statements[kTimes].get(), run.number, Json::array({times}));
}

void Store::write(const std::vector<Json> &lines) {
    if (lines.empty()) return;
    execute("BEGIN IMMEDIATE");
    for (const Json &line : lines) writeLine(line);
    execute("COMMIT");
}

}  // namespace batch
