#include "remote/worker/dxRemoteServer.h"

#include <algorithm>
#include <chrono>
#include <new>
#include <utility>

#include "core/dxStopwatch.h"
#include "remote/transport/dxPollPause.h"

dxRemoteServer::dxRemoteServer(dxRemoteTransport &transport, const dxRemoteHello &hello, Solve solve)
    : m_transport(transport), m_hello(hello), m_solve(std::move(solve)) {}

bool dxRemoteServer::send(const dxRemoteBytes &message) {
    if (m_transport.send(0, message.data(), message.size())) return true;
    m_hasEnded = true;
    m_end = End::Lost;
    return false;
}

dxRemoteServer::End dxRemoteServer::run(double maxSilence) try {
    return serve(maxSilence);
} catch (const std::bad_alloc &) {
    return End::NoMemory;
}

dxRemoteServer::End dxRemoteServer::serve(double maxSilence) {
    dxRemoteFrame hello;
    hello.add(&m_hello, sizeof m_hello);
    send(hello.seal(dxRemoteKind::Hello));
    dxPollPause pause;
    dxStopwatch silence;
    while (!m_hasEnded) {
        const Received received = receiveAll();
        if (received != Received::Nothing) silence.restart();
        if (received == Received::Work || !m_problems.empty()) {
            pause.reset();
        } else if (silence.ns() > maxSilence * 1e9) {
            return End::Silence;
        } else {
            pause.wait();
        }
        if (!m_hasEnded && !m_problems.empty()) {
            solveFirst();
            pause.reset();
        }
    }
    return m_end;
}

// Messages that are not whole are the coordinator's to miss.
dxRemoteServer::Received dxRemoteServer::receiveAll() {
    Received received = Received::Nothing;
    unsigned link = 0;
    for (std::size_t bytes; !m_hasEnded && (bytes = m_transport.waiting(link)) != 0;) {
        received = std::max(received, Received::Sign);
        dxRemoteBytes message(bytes);
        if (!m_transport.receive(message.data())) {
            m_hasEnded = true;
            m_end = End::Lost;
            break;
        }
        if (dxFindFrameFault(message) != nullptr) continue;
        const dxRemoteHeader header = dxReadHeader(message);
        if (static_cast<dxRemoteKind>(header.kind) != dxRemoteKind::Alive) received = Received::Work;
        const char *const body = reinterpret_cast<const char *>(message.data()) + sizeof header;
        const std::size_t bodySize = message.size() - sizeof header;
        switch (static_cast<dxRemoteKind>(header.kind)) {
            case dxRemoteKind::Problems:
                m_problems.push_back(std::move(message));
                break;
            case dxRemoteKind::Echo:
                send(message);
                break;
            case dxRemoteKind::Withdraw: {
                const auto found = std::find_if(m_problems.begin(), m_problems.end(),
                                                [&header](const dxRemoteBytes &kept) { return dxReadHeader(kept).number == header.number; });
                if (found == m_problems.end()) break;
                m_problems.erase(found);
                send(m_none.seal(dxRemoteKind::Results, header.number));
                break;
            }
            case dxRemoteKind::Refusal:
                m_refusal.assign(body, bodySize);
                m_hasEnded = true;
                m_end = End::Refused;
                break;
            case dxRemoteKind::Quit:
                m_hasEnded = true;
                m_end = bodySize == 1 && body[0] != 0 ? End::Orderly : End::Disorderly;
                break;
            default:
                break;
        }
    }
    return received;
}

// Returns false without memory for the results.
bool dxRemoteServer::solveAll(const dxRemoteBytes &problems, dxRemoteFrame &results) try {
    for (dxRemoteItems items(problems); items.next();) {
        m_result.clear();
        try {
            m_solve(items.data(), items.size(), m_result);
        } catch (const std::bad_alloc &) {
            m_result.clear();
        }
        results.addItem(items.number(), m_result.data(), m_result.size());
    }
    return true;
} catch (const std::bad_alloc &) {
    return false;
}

void dxRemoteServer::solveFirst() {
    const dxRemoteBytes problems = std::move(m_problems.front());
    m_problems.erase(m_problems.begin());
    const std::uint64_t number = dxReadHeader(problems).number;
    {
        dxRemoteFrame results;
        if (solveAll(problems, results)) {
            send(results.seal(dxRemoteKind::Results, number));
            return;
        }
    }
    send(m_none.seal(dxRemoteKind::Results, number));
}
