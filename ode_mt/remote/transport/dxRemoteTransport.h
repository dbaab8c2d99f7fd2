// What carries messages between the program's process and its workers: MPI (remote/mpi/, loaded by dxRemoteLoader), threads in tests.
//
// A transport has links: the coordinator one to each worker, a worker one (link 0) to the coordinator. Messages are whole, and those of one link
// arrive in the order in which they were sent. They may be lost or damaged with a worker; other code detects that (dxRemoteLink).
//
// The coordinator's transport may be able to replace a lost worker by a new one on the same link.
//
// Threading: one call at a time. The thread that made the transport replaces workers and closes it; others may send and receive if isForAllThreads().
// Only open and close wait.
#pragma once

#include <cstddef>

class dxRemoteTransport {
public:
    // A library of a transport must have the same.
    static constexpr unsigned kInterfaceVersion = 4;

    virtual ~dxRemoteTransport() = default;

    virtual unsigned links() const = 0;

    // Returns whether threads other than the one that made it may send and receive, one at a time.
    virtual bool isForAllThreads() const { return false; }

    // Sends a copy. Returns false if the link is lost. Messages to a worker that does not receive are kept.
    virtual bool send(unsigned link, const void *message, std::size_t bytes) = 0;

    // Returns the size of the next message that has arrived, and sets its link; 0: none has. Messages have at least one byte.
    virtual std::size_t waiting(unsigned &link) = 0;

    // Receives the message that waiting() has just found. Returns false if the link is lost.
    virtual bool receive(void *message) = 0;

    // --- workers in the place of lost ones ---------------------------------------------------------------
    enum class Replacement { Expected, Here, Failed };

    virtual bool canReplace() const { return false; }

    // Begins to start a new worker, if none is being started. Until replacement() returns Here, the link receives nothing: neither from the lost
    // worker nor from the new one, whose hello would be taken for the lost one's.
    virtual void replace(unsigned /*link*/) {}

    // Returns the state of the new worker. Here: messages can be sent and received.
    virtual Replacement replacement() { return Replacement::Failed; }

    // Called once, by the coordinator. Where the program itself ends MPI, and not the transport, `end` is called before, on the program's
    // thread. It has this transport closed on the thread that made it, and returns when that is done.
    virtual void setEnd(void (* /*end*/)()) {}

    // The last call. `isOrderly`: all others close, too, so that waiting for them ends.
    virtual void close(bool isOrderly) = 0;
};

// The function dxOpenRemoteTransport that the library of a transport exports. `wanted`: number of workers to start; 0: those that there are. Returns
// null and writes the reason if there is no transport.
extern "C" {
using dxOpenRemoteTransportFunction = dxRemoteTransport *(unsigned interfaceVersion, unsigned wanted, char *reason, std::size_t reasonSize);
}
