// A message between the coordinator and a worker: a header, then a body that depends on the kind. The page is docs/remote.md.
//
// Numbers are in the sender's byte order. A receiver with another one finds a wrong magic number.
//
// Threading: one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

using dxRemoteBytes = std::vector<std::byte>;

enum class dxRemoteKind : std::uint16_t {
    Hello,     // worker: dxRemoteHello
    Welcome,   // coordinator: the worker is taken
    Refusal,   // coordinator: it is not; text
    Echo,      // coordinator: to measure the link; the worker sends it back
    Problems,  // coordinator: items
    Results,   // worker: items; the number is that of the problems
    Withdraw,  // coordinator: the problems of this number are no longer wanted
    Alive,     // coordinator: nothing but that, for a worker that may go on sleeping
    Quit,      // coordinator: the worker ends; body: one byte, whether all end in good order
    Wake,      // coordinator: problems are about to come
};

struct dxRemoteHeader {
    static constexpr std::uint32_t kMagic = 0x4f44654d;
    static constexpr std::uint16_t kVersion = 1;

    std::uint32_t magic;
    std::uint16_t version;
    std::uint16_t kind;
    std::uint64_t bytes;  // of the whole message
    std::uint64_t number;
    std::uint64_t checksum;  // of all else
};
static_assert(sizeof(dxRemoteHeader) == 32, "the body is aligned");

// The properties of a worker. Workers for which all are equal to the coordinator's compute the same bits.
struct dxRemoteHello {
    static constexpr std::size_t kTextSize = 32;

    char version[kTextSize] = {};  // dODE_MT_VERSION
    std::uint32_t realSize = 0;
    std::uint32_t padding = 0;
    std::uint64_t digest = 0;  // of the bits of solutions of known problems
};

// A message under construction: the header's room, then what is added. Items begin on 8 bytes.
class dxRemoteFrame {
public:
    dxRemoteFrame() : dxRemoteFrame(dxRemoteBytes()) {}
    explicit dxRemoteFrame(dxRemoteBytes &&room) : m_bytes(std::move(room)) { m_bytes.assign(sizeof(dxRemoteHeader), std::byte{0}); }

    void add(const void *data, std::size_t bytes);
    void addItem(std::uint64_t number, const void *data, std::size_t bytes);
    std::size_t size() const { return m_bytes.size(); }

    // Completes the header. Returns the message.
    const dxRemoteBytes &seal(dxRemoteKind kind, std::uint64_t number = 0);

    // The last call: its memory, for another one.
    dxRemoteBytes release() { return std::move(m_bytes); }

private:
    dxRemoteBytes m_bytes;
};

// Returns null if the message is complete and of this version; else its fault.
const char *dxFindFrameFault(const dxRemoteBytes &message);

// Requires a message without fault.
inline dxRemoteHeader dxReadHeader(const dxRemoteBytes &message) {
    dxRemoteHeader header;
    std::memcpy(&header, message.data(), sizeof header);
    return header;
}

// The items of a message without fault, one after the other.
class dxRemoteItems {
public:
    explicit dxRemoteItems(const dxRemoteBytes &message)
        : m_next(message.data() + sizeof(dxRemoteHeader)), m_end(message.data() + message.size()) {}

    // Returns false if there is no further one, or the bytes that follow are no item.
    bool next();
    bool isAtEnd() const { return m_next == m_end; }

    std::uint64_t number() const { return m_head.number; }
    const std::byte *data() const { return m_data; }
    std::size_t size() const { return static_cast<std::size_t>(m_head.bytes); }

private:
    friend class dxRemoteFrame;
    struct Head {
        std::uint64_t number, bytes;
    };

    Head m_head{};
    const std::byte *m_data = nullptr, *m_next, *m_end;
};
