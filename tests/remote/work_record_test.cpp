// The record of what a worker did: a line for each problem, by step and number; messages pass unchanged.
#include "remote/worker/dxWorkRecord.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>

namespace {

struct Sent final : dxRemoteTransport {
    unsigned links() const override { return 1; }
    bool send(unsigned, const void *message, std::size_t bytes) override {
        const auto *const from = static_cast<const std::byte *>(message);
        messages.emplace_back(from, from + bytes);
        return true;
    }
    std::size_t waiting(unsigned &) override { return 0; }
    bool receive(void *) override { return false; }
    void close(bool) override {}

    std::vector<dxRemoteBytes> messages;
};

TEST(WorkRecord, HasALineForEachProblem) {
    const std::string file = testing::TempDir() + "work_record_" + std::to_string(getpid());
    Sent sent;
    std::string reason;
    {
        const std::unique_ptr<dxWorkRecord> record = dxWorkRecord::open(file, sent, reason);
        ASSERT_NE(record, nullptr) << reason;
        const dxRemoteServer::Solve solve =
            record->timed([](const std::byte *, std::size_t bytes, dxRemoteBytes &result) { result.resize(bytes / 2); });
        dxRemoteFrame results;
        for (std::uint64_t i = 0; i < 2; ++i) {
            const dxRemoteBytes problem(100 * (i + 1));
            dxRemoteBytes result;
            solve(problem.data(), problem.size(), result);
            results.addItem(std::uint64_t{7} << 32 | i, result.data(), result.size());
        }
        const dxRemoteBytes &message = results.seal(dxRemoteKind::Results, 3);
        EXPECT_TRUE(record->send(0, message.data(), message.size()));
        EXPECT_EQ(sent.messages.back(), message);
        const dxRemoteBytes withdrawn = dxRemoteFrame().seal(dxRemoteKind::Results, 4);
        EXPECT_TRUE(record->send(0, withdrawn.data(), withdrawn.size()));
    }
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    ASSERT_EQ(lines.size(), 2u);
    for (unsigned i = 0; i < 2; ++i) {
        std::istringstream words(lines[i]);
        const std::vector<double> numbers((std::istream_iterator<double>(words)), {});
        ASSERT_EQ(numbers.size(), 8u) << lines[i];
        EXPECT_EQ(numbers[0], 7);
        EXPECT_EQ(numbers[1], i);
        EXPECT_EQ(numbers[5], 100 * (i + 1));
        EXPECT_GE(numbers[6], 0);
        EXPECT_EQ(numbers[7], 50 * (i + 1));
    }
    std::remove(file.c_str());
}

TEST(WorkRecord, AFileThatCannotBeWrittenIsNamed) {
    Sent sent;
    std::string reason;
    EXPECT_EQ(dxWorkRecord::open("/no/such/folder/file", sent, reason), nullptr);
    EXPECT_EQ(reason, "/no/such/folder/file: No such file or directory");
}

}  // namespace
