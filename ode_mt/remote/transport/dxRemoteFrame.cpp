#include "remote/transport/dxRemoteFrame.h"

#include <algorithm>

namespace {

constexpr std::size_t kAlignment = 8;

std::size_t paddingOf(std::size_t bytes) { return (kAlignment - bytes % kAlignment) % kAlignment; }

// Four sums that do not wait for one another. Each step is a bijection of the sum and of the word, so a word that was changed changes
// the result.
std::uint64_t findChecksum(const std::byte *data, std::size_t bytes) {
    constexpr std::uint64_t kFactor = 0x9e3779b97f4a7c15u;
    constexpr std::size_t kLanes = 4, kWord = sizeof(std::uint64_t);
    const auto mix = [](std::uint64_t sum, std::uint64_t word) {
        sum = (sum ^ word) * kFactor;
        return sum ^ sum >> 32;
    };
    std::uint64_t lanes[kLanes] = {1, 2, 3, 4}, words[kLanes];
    for (; bytes >= sizeof words; bytes -= sizeof words, data += sizeof words) {
        std::memcpy(words, data, sizeof words);
        for (std::size_t i = 0; i < kLanes; ++i) lanes[i] = mix(lanes[i], words[i]);
    }
    std::uint64_t sum = bytes;
    for (const std::uint64_t lane : lanes) sum = mix(sum, lane);
    for (; bytes > 0; bytes -= std::min(bytes, kWord), data += kWord) {
        std::uint64_t word = 0;
        std::memcpy(&word, data, std::min(bytes, kWord));
        sum = mix(sum, word);
    }
    return sum;
}

std::uint64_t findChecksum(const dxRemoteBytes &message, dxRemoteHeader header) {
    header.checksum = findChecksum(message.data() + sizeof header, message.size() - sizeof header);
    std::byte bytes[sizeof header];
    std::memcpy(bytes, &header, sizeof header);
    return findChecksum(bytes, sizeof bytes);
}

}  // namespace

void dxRemoteFrame::add(const void *data, std::size_t bytes) {
    const auto *const from = static_cast<const std::byte *>(data);
    m_bytes.insert(m_bytes.end(), from, from + bytes);
}

void dxRemoteFrame::addItem(std::uint64_t number, const void *data, std::size_t bytes) {
    m_bytes.reserve(m_bytes.size() + sizeof(dxRemoteItems::Head) + bytes + kAlignment);
    const dxRemoteItems::Head head{number, bytes};
    add(&head, sizeof head);
    add(data, bytes);
    m_bytes.resize(m_bytes.size() + paddingOf(bytes));
}

const dxRemoteBytes &dxRemoteFrame::seal(dxRemoteKind kind, std::uint64_t number) {
    dxRemoteHeader header{dxRemoteHeader::kMagic, dxRemoteHeader::kVersion, static_cast<std::uint16_t>(kind), m_bytes.size(), number, 0};
    header.checksum = findChecksum(m_bytes, header);
    std::memcpy(m_bytes.data(), &header, sizeof header);
    return m_bytes;
}

const char *dxFindFrameFault(const dxRemoteBytes &message) {
    if (message.size() < sizeof(dxRemoteHeader)) return "too short";
    const dxRemoteHeader header = dxReadHeader(message);
    if (header.magic == __builtin_bswap32(dxRemoteHeader::kMagic)) return "of another byte order";
    if (header.magic != dxRemoteHeader::kMagic) return "no message of ODE_MT";
    if (header.version != dxRemoteHeader::kVersion) return "of another version of messages";
    if (header.bytes != message.size()) return "of another size than it says";
    if (header.checksum != findChecksum(message, header)) return "damaged";
    return nullptr;
}

bool dxRemoteItems::next() {
    if (static_cast<std::size_t>(m_end - m_next) < sizeof m_head) return false;
    std::memcpy(&m_head, m_next, sizeof m_head);
    const std::size_t room = static_cast<std::size_t>(m_end - m_next) - sizeof m_head;
    if (m_head.bytes > room || m_head.bytes + paddingOf(m_head.bytes) > room) return false;
    m_data = m_next + sizeof m_head;
    m_next = m_data + m_head.bytes + paddingOf(m_head.bytes);
    return true;
}
