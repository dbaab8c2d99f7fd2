// Messages by MPI. The coordinator and its workers are processes of one job (MPMD: mpirun -np 1 program : -np 15 odemt_worker), the coordinator
// the one of rank 0; or each worker is a job of its own that the coordinator has spawned, one after the other, so that none is in another one's.
//
// A lost worker of the second kind is replaced where mpirun lets the job live without it (--enable-recovery of Open MPI 4, --with-ft ulfm of 5): a
// thread of its own calls MPI_Comm_spawn, which takes a fraction of a second. If the new process dies before it has said hello, that call may take
// a minute, or never return: then the thread is left alone, and no other worker is replaced.
//
// Tried and dropped: MPI_Comm_accept, by which workers would join when they like (docs/notes/2026-11-remote-experiments.md).
//
// All calls are non-blocking but those of the beginning and the end, since blocking ones of Open MPI keep a core busy. Errors are returned
// (MPI_ERRORS_RETURN); the first one loses the link.
//
// Threading: the thread that makes the transport initialises MPI, unless the program has, and ends it. Others may send and receive where MPI gives
// MPI_THREAD_SERIALIZED; MPI_THREAD_FUNNELED suffices for the first one alone, which is MPI's main thread, where no worker is spawned. Where the
// program has initialised MPI, it must have asked for MPI_THREAD_MULTIPLE.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <list>
#include <memory>
#include <string>
#include <vector>

#include "remote/transport/dxRemoteTransport.h"
#include "remote/transport/dxSpareBytes.h"

class dxMpiTransport final : public dxRemoteTransport {
public:
    // The coordinator's. `wanted`: workers to spawn; 0: the other processes of the job. Null: `reason` says why.
    static std::unique_ptr<dxMpiTransport> openCoordinator(unsigned wanted, std::string &reason);

    // A worker's, with one link: to the process that has spawned it, else to that of rank 0.
    static std::unique_ptr<dxMpiTransport> openWorker(std::string &reason);

    unsigned links() const override { return static_cast<unsigned>(m_links.size()); }
    bool isForAllThreads() const override { return m_isForAllThreads; }
    bool send(unsigned link, const void *message, std::size_t bytes) override;
    std::size_t waiting(unsigned &link) override;
    bool receive(void *message) override;
    bool canReplace() const override { return m_canReplace; }
    void replace(unsigned link) override;
    Replacement replacement() override;
    void setEnd(void (*end)()) override;
    void close(bool isOrderly) override;

private:
    struct Link {
        MPI_Comm communicator;
        int rank;
    };
    struct Sending {
        dxRemoteBytes bytes;  // MPI reads them until the request is complete
        MPI_Request request;
    };

    struct Start;  // of a worker, shared with the thread that waits for it

    bool initialise(int wantedLevel, std::string &reason);
    bool spawn(unsigned wanted, std::string &reason);
    void forgetSent();
    std::size_t probe(unsigned &link);

    bool m_isForAllThreads = false;
    bool m_isOwn = false;      // MPI was initialised by this transport
    bool m_canReplace = false, m_hasReplaced = false;
    std::string m_program;  // the worker's, of the second kind
    std::shared_ptr<Start> m_start;
    bool m_isSpawned = false;  // communicators are intercommunicators, one for each link
    std::vector<Link> m_links;
    std::vector<MPI_Comm> m_probed;  // each communicator once
    std::list<Sending> m_sending;
    dxSpareBytes m_spare;
    unsigned m_next = 0;  // link or communicator that is looked at first
    MPI_Message m_message = MPI_MESSAGE_NULL;
    int m_bytes = 0;
};
