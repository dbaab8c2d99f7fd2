#include "input.h"

#include "driver/random.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace fuzz {

namespace {

// Bytes that choose settings, before those of the script.
constexpr std::size_t kSettingBytes = 9;

RequestHeader requestOf(const std::array<std::uint8_t, kSettingBytes> &bytes) {
    constexpr std::uint16_t threads[] = {0, 0, 1, 2, 2, 3, 5, 8};
    RequestHeader request{};
    request.jumps = bytes[0] % 2;
    request.messages = bytes[1] % 3 == 0;
    request.threads = threads[bytes[2] % 8];
    request.manager = bytes[3] % 6 == 0;
    request.algorithm = bytes[4] % 8;
    request.instructionSet = bytes[5] % 4;
    request.cells = bytes[6] % 3 == 0 ? bytes[7] % 16 : 0;
    request.disturbs = request.threads > 1 && bytes[8] % 2 == 0;
    request.maxCalls = 4000;
    request.seconds = 5;
    request.wallSeconds = 100;
    return request;
}

}  // namespace

Input inputOf(const std::uint8_t *bytes, std::size_t count) {
    std::array<std::uint8_t, kSettingBytes> settings{};
    const std::size_t known = std::min(count, kSettingBytes);
    std::copy_n(bytes, known, settings.begin());
    return {requestOf(settings), std::vector<std::uint8_t>(bytes + known, bytes + count)};
}

std::vector<std::uint8_t> bytesOf(std::uint64_t seed) {
    constexpr unsigned lengths[] = {200, 500, 1000, 2000, 4000, 8000};
    constexpr unsigned kShortest = 20;
    fuzz_driver::Random random(seed);
    const std::size_t length = lengths[random.below(std::size(lengths))];
    std::vector<std::uint8_t> bytes(kSettingBytes + kShortest + random.below(length));
    for (std::uint8_t &byte : bytes) byte = static_cast<std::uint8_t>(random.next());
    return bytes;
}

std::string settingOf(const RequestHeader &request) {
    std::string text = "# threads " + std::to_string(request.threads) + ", manager " + kManagers[request.manager % 2] + ", algorithm " +
                       kAlgorithms[request.algorithm % 8] + ", cells " + std::to_string(request.cells) + ", instruction set " +
                       std::to_string(request.instructionSet) + (request.disturbs != 0 ? ", disturbed\n" : "\n");
    if (request.jumps != 0) text += "# jumps\n";
    if (request.messages != 0) text += "# messages\n";
    return text;
}

}  // namespace fuzz
