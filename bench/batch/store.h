// The table of results, an SQLite file (docs/tools.md has its columns).
//
// Each call of write() is one transaction. The file is in WAL mode, so that a reader sees whole transactions while the batch runs and a kill
// leaves those that were written; no more than one process writes (a lock of the file, which ends with its process).
#pragma once

#include "batch/plan.h"

#include <memory>
#include <string>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace batch {

class Store {
public:
    enum class Begin { New, Resumed };

    // Throws std::runtime_error that names the file, and leaves none that was not there: New, and it exists; it is of another plan; another process
    // writes to it. Resumed: there need not be one.
    Store(const std::string &file, const Plan &plan, Begin begin);
    ~Store();  // as it is without close(), but that no error is told
    Store(const Store &) = delete;
    Store &operator=(const Store &) = delete;

    // By the numbers of runs.
    std::vector<bool> done() const;

    struct Failed {
        long count = 0, first = 0;  // of runs whose status is error; the number of the first one
        std::string message;        // its
    };
    Failed failed() const;

    // Lines of runWorld(), in any order. A run that is there already is left as it is.
    void write(const std::vector<Json> &lines);

    void close();  // throws std::runtime_error

private:
    class Lock;
    using Statement = std::unique_ptr<sqlite3_stmt, int (*)(sqlite3_stmt *)>;

    void execute(const std::string &sql) const;
    Statement prepare(const std::string &sql) const;
    void step(sqlite3_stmt *statement) const;
    [[noreturn]] void fail() const;
    void openDatabase();
    void createTables();
    void checkPlan() const;
    void writeLine(const Json &line);
    void writeRows(sqlite3_stmt *statement, long run, const Json &rows);
    std::string columns() const;

    const std::string m_file;
    const Plan &m_plan;
    std::unique_ptr<Lock> m_lock;
    std::unique_ptr<sqlite3, int (*)(sqlite3 *)> m_database;
    std::vector<Statement> m_statements;  // of runs, series, states, times
};

}  // namespace batch
