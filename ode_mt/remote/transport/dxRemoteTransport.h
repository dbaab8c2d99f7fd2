// What carries messages between the program's process and its workers: MPI (remote/mpi/, loaded by dxRemoteLoader), threads in tests.
//
// A transport has links: the coordinator one to each worker, a worker one (link 0) to the coordinator. Messages are whole, and those of one link
// arrive in the order in which they were sent. They may be lost or damaged with a worker, which is found out by others (dxRemoteLink).
//
// The coordinator's may be able to replace a lost worker by a new one, of which the link is then.
//
// Threading: one call at a time. The thread that made the transport replaces workers and closes it; others may send and receive where it says so.
// Nothing is waited for but in open and close.
#pragma once

#include <cstddef>

class dxRemoteTransport {
public:
    // What a library must know to give a transport to this one.
    static constexpr unsigned kInterfaceVersion = 4;

    virtual ~dxRemoteTransport() = default;

    virtual unsigned links() const = 0;

    // Whether other threads than that which made it may send and receive, one at a time.
    virtual bool isForAllThreads() const { return false; }

    // Takes a copy. False: the link is lost. To a worker that does not receive messages are kept.
    virtual bool send(unsigned link, const void *message, std::size_t bytes) = 0;

    // Size of the next message that has arrived, and its link; 0: none has. Messages have at least one byte.
    virtual std::size_t waiting(unsigned &link) = 0;

    // Receives the message that `waiting` has just found. False: the link is lost.
    virtual bool receive(void *message) = 0;

    // --- workers in the place of lost ones ---------------------------------------------------------------
    enum class Replacement { Expected, Here, Failed };

    virtual bool canReplace() const { return false; }

    // Begins to start one, if none is being started. The link has no worker until that is here: nothing of the lost one is received, nor of the
    // new one, whose greeting would be taken for the lost one's.
    virtual void replace(unsigned /*link*/) {}

    // What has become of it. Here: its messages can be sent and received.
    virtual Replacement replacement() { return Replacement::Failed; }

    // The coordinator's, once. Where the program ends what carries the messages, and not the transport, `end` is called before, on the program's
    // thread: it has this transport closed on the thread of its calls, and returns when that is done.
    virtual void setEnd(void (* /*end*/)()) {}

    // The last call. `isOrderly`: all others close as well, and may be waited for.
    virtual void close(bool isOrderly) = 0;
};

// What a library with a transport exports, by the name dxOpenRemoteTransport. `wanted`: workers to start; 0: those that are there. Returns null
// and writes why if there is no transport.
extern "C" {
using dxOpenRemoteTransportFunction = dxRemoteTransport *(unsigned interfaceVersion, unsigned wanted, char *reason, std::size_t reasonSize);
}
