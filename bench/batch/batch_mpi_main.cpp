// odemt_batch_mpi: odemt_batch on the ranks of MPI, each with workers of its own. Rank 0 also is the master.
//
// Workers are forked before MPI begins and know nothing of it. The processes that do talk do so by messages that they poll for, with pauses: a
// blocking call of OpenMPI would take a processor from the workers.
#include "batch/batch_options.h"
#include "batch/master.h"
#include "batch/workers.h"
#include "tool_output.h"
#include "library_folders.h"
#include "support/text_file.h"

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <list>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

namespace {

constexpr int kMaster = 0;
enum Tag { kHello = 1, kRuns, kAnswers, kEnd };  // of messages, which are JSON

// ms between two looks at what has come, for a rank that has work and for one that has none.
constexpr int kBusyPause = 2, kMaxIdlePause = 20;

class Messages {
public:
    void send(int rank, Tag tag, const batch::Json &content) {
        Sent &sent = m_sent.emplace_back(Sent{content.dump(), MPI_REQUEST_NULL});
        MPI_Isend(sent.text.data(), static_cast<int>(sent.text.size()), MPI_CHAR, rank, tag, MPI_COMM_WORLD, &sent.request);
        forgetSent();
    }

    struct Message {
        int rank, tag;
        batch::Json content;
    };

    // None if nothing has come.
    std::optional<Message> take() {
        forgetSent();
        int hasCome = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &hasCome, &status);
        if (hasCome == 0) return std::nullopt;
        int size = 0;
        MPI_Get_count(&status, MPI_CHAR, &size);
        std::string text(static_cast<std::size_t>(size), '\0');
        MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return Message{status.MPI_SOURCE, status.MPI_TAG, batch::Json::parse(text)};
    }

    void finish() {
        for (Sent &sent : m_sent) MPI_Wait(&sent.request, MPI_STATUS_IGNORE);
        m_sent.clear();
    }

private:
    struct Sent {
        std::string text;
        MPI_Request request;
    };

    void forgetSent() {
        m_sent.remove_if([](Sent &sent) {
            int isSent = 0;
            MPI_Test(&sent.request, &isSent, MPI_STATUS_IGNORE);
            return isSent != 0;
        });
    }

    std::list<Sent> m_sent;
};

class OtherRanks : public batch::Ranks {
public:
    OtherRanks(int count, const batch::Plan &plan) : m_workers(static_cast<std::size_t>(count)) {
        for (int said = 0; said < count;) {
            const auto message = m_messages.take();
            if (!message) {
                std::this_thread::sleep_for(std::chrono::milliseconds(kBusyPause));
                continue;
            }
            if (message->content.at("plan") != plan.fingerprint)
                throw std::runtime_error("rank " + std::to_string(message->rank) + " has read another plan, or other worlds");
            m_workers[static_cast<std::size_t>(message->rank) - 1] = message->content.at("workers").get<unsigned>();
            ++said;
        }
    }

    unsigned count() const override { return static_cast<unsigned>(m_workers.size()); }
    unsigned workers(unsigned index) const override { return m_workers[index]; }
    void give(unsigned index, const std::vector<long> &runs) override { m_messages.send(static_cast<int>(index) + 1, kRuns, runs); }

    std::vector<std::pair<unsigned, batch::Json>> takeAnswers() override {
        std::vector<std::pair<unsigned, batch::Json>> answers;
        while (const auto message = m_messages.take())
            for (const batch::Json &answer : message->content) answers.emplace_back(message->rank - 1, answer);
        return answers;
    }

    void end() {
        for (unsigned i = 0; i < count(); ++i) m_messages.send(static_cast<int>(i) + 1, kEnd, {});
        m_messages.finish();
    }

private:
    std::vector<unsigned> m_workers;  // of each rank but this one
    Messages m_messages;
};

int beMaster(const batch::BatchOptions &options, const batch::Plan &plan, batch::Workers &workers, int ranks) {
    OtherRanks others(ranks - 1, plan);  // before the file: another plan leaves none
    batch::Store store(options.output, plan, options.isResumed ? batch::Store::Begin::Resumed : batch::Store::Begin::New);
    batch::runPlan(plan, store, workers, &others, options.isQuiet);
    others.end();
    const int exitCode = batch::exitCodeOf(store);
    store.close();
    return exitCode;
}

void serve(const batch::Plan &plan, batch::Workers &workers) {
    Messages messages;
    messages.send(kMaster, kHello, {{"workers", workers.count()}, {"plan", plan.fingerprint}});
    for (int idle = 1;;) {
        while (const auto message = messages.take()) {
            if (message->tag == kEnd) return messages.finish();
            workers.give(message->content.get<std::vector<long>>());
        }
        idle = workers.outstanding() > 0 ? kBusyPause : std::min(2 * idle, kMaxIdlePause);
        const std::vector<batch::Json> answers = workers.takeAnswers(idle);
        if (!answers.empty()) messages.send(kMaster, kAnswers, answers);
    }
}

}  // namespace

int main(int argc, char **argv) {
    bench::keepStandardFiles();
    int exitCode = 0;
    const auto options = batch::readBatchOptions(argc, argv, exitCode);
    if (!options) return bench::exitCodeAfterOutput(exitCode);
    for (const std::string &name : bench::libraryVariables()) unsetenv(name.c_str());
    try {
        const batch::Plan plan = batch::readPlan(support::readTextFile(options->planFile));
        batch::checkWorlds(plan);
        const auto workers = std::make_unique<batch::Workers>(plan, options->workers);
        MPI_Init(&argc, &argv);
        int rank = 0, ranks = 1;
        MPI_Comm_rank(MPI_COMM_WORLD, &rank);
        MPI_Comm_size(MPI_COMM_WORLD, &ranks);
        if (rank == kMaster)
            exitCode = beMaster(*options, plan, *workers, ranks);
        else
            serve(plan, *workers);
        MPI_Finalize();
        return exitCode;
    } catch (const std::exception &error) {
        bench::printError(error.what());
        int isRunning = 0;
        MPI_Initialized(&isRunning);
        if (isRunning != 0) MPI_Abort(MPI_COMM_WORLD, 1);
        return 1;
    }
}
