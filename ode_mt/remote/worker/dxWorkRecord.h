// What a worker was given, and how long each problem took: a line of text for each, appended to a file. From it bench/scale/ predicts how long
// a step takes with other networks and numbers of workers.
//
//   step problem bodies joints rows bytes ns result-bytes       ns: the processor's time
//
// It stands between a worker's server and its transport, and notes results as they are sent. Several workers may have one file.
//
// Threading: that of a transport.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "remote/worker/dxRemoteServer.h"
#include "remote/transport/dxRemoteTransport.h"

class dxWorkRecord final : public dxRemoteTransport {
public:
    // Null: the file cannot be written; `reason` says why.
    static std::unique_ptr<dxWorkRecord> open(const std::string &file, dxRemoteTransport &below, std::string &reason);
    ~dxWorkRecord() override;

    // For the server: solves by `solve`, and remembers what that took until the results are sent.
    dxRemoteServer::Solve timed(dxRemoteServer::Solve solve);

    unsigned links() const override { return m_below.links(); }
    bool send(unsigned link, const void *message, std::size_t bytes) override;
    std::size_t waiting(unsigned &link) override { return m_below.waiting(link); }
    bool receive(void *message) override { return m_below.receive(message); }
    void close(bool isOrderly) override { m_below.close(isOrderly); }

private:
    struct Solved {
        std::uint32_t bodies, joints, rows;
        std::size_t bytes, resultBytes;
        double ns;
    };

    dxWorkRecord(int file, dxRemoteTransport &below) : m_file(file), m_below(below) {}
    void note(const dxRemoteBytes &results);

    const int m_file;
    dxRemoteTransport &m_below;
    std::vector<Solved> m_solved;  // since the last results
};
