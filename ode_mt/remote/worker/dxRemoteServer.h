// A worker: solves the problems that the coordinator sends, until the coordinator has it end or sends nothing any more.
//
// Memory: a problem for which there is none is given back, by a result without bytes, or all of a message by one without results. A worker that
// cannot even receive or answer ends.
//
// Threading: one thread, that of the transport.
#pragma once

#include <functional>
#include <string>

#include "remote/transport/dxRemoteFrame.h"
#include "remote/transport/dxRemoteTransport.h"

class dxRemoteServer {
public:
    // Solves one problem; the result is always made, if only to say that there is none. No bytes say so, too, as does std::bad_alloc.
    using Solve = std::function<void(const std::byte *problem, std::size_t bytes, dxRemoteBytes &result)>;

    enum class End { Orderly, Disorderly, Refused, Silence, Lost, NoMemory };

    dxRemoteServer(dxRemoteTransport &transport, const dxRemoteHello &hello, Solve solve);

    // `maxSilence` (s): without a message for so long, the coordinator is taken to be gone.
    End run(double maxSilence);

    // Why it was refused.
    const std::string &refusal() const { return m_refusal; }

private:
    End serve(double maxSilence);
    // What was there: a sign of life, or what others may follow soon.
    enum class Received { Nothing, Sign, Work };
    Received receiveAll();
    void solveFirst();
    bool solveAll(const dxRemoteBytes &problems, dxRemoteFrame &results);
    bool send(const dxRemoteBytes &message);

    dxRemoteTransport &m_transport;
    const dxRemoteHello m_hello;
    const Solve m_solve;
    std::vector<dxRemoteBytes> m_problems;  // received, the oldest first
    dxRemoteBytes m_result;
    dxRemoteFrame m_none;  // results, of nothing
    std::string m_refusal;
    bool m_hasEnded = false;
    End m_end = End::Orderly;
};
