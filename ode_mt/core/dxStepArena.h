// An arena for arrays that live until a step (or a part of it) ends: they are taken one after the other and freed all at once.
//
// Memory is kept. A step that needs more gets further blocks, and the next reset() makes one block of all of them. Each further block is at least
// as large as those before it together, so that a scene at rest, or one that changes by little, soon allocates no more.
//
// Threading: one thread at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <type_traits>
#include <vector>

#include "core/dxCacheLine.h"

// An array in an arena: size() items, with room for more. It does not own them.
template <class T>
class dxArenaArray {
public:
    dxArenaArray() = default;
    dxArenaArray(T *data, std::size_t size) : m_data(data), m_size(size) {}
    template <class Item, class = std::enable_if_t<std::is_same_v<const Item, T> && !std::is_const_v<Item>>>
    dxArenaArray(const dxArenaArray<Item> &array) : m_data(array.data()), m_size(array.size()) {}

    T *data() const { return m_data; }
    std::size_t size() const { return m_size; }
    bool empty() const { return m_size == 0; }
    T *begin() const { return m_data; }
    T *end() const { return m_data + m_size; }
    T &operator[](std::size_t i) const { return m_data[i]; }
    T &back() const { return m_data[m_size - 1]; }

    // Requires room for one more.
    void push(const T &item) { m_data[m_size++] = item; }
    void clear() { m_size = 0; }

private:
    T *m_data = nullptr;
    std::size_t m_size = 0;
};

class dxStepArena {
public:
    dxStepArena() = default;
    dxStepArena(const dxStepArena &) = delete;
    dxStepArena &operator=(const dxStepArena &) = delete;

    // Frees all arrays. Throws std::bad_alloc, and is empty then.
    void reset() {
        if (m_blocks.size() > 1) makeOneBlock(m_capacity);
        m_used = 0;
    }

    // Provides memory of this size, as capacity() returns it, in one block. Requires that no array is in use. Throws std::bad_alloc.
    void reserve(std::size_t bytes) {
        if (m_capacity < bytes || m_blocks.size() > 1) makeOneBlock(std::max(bytes, m_capacity));
    }
    std::size_t capacity() const { return m_capacity; }

    // Returns an array of items without values. Arrays begin at a cache line. Throws std::bad_alloc.
    template <class T>
    dxArenaArray<T> take(std::size_t count) {
        static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T> && alignof(T) <= kCacheLine);
        return {new (takeBytes(count * sizeof(T))) T[count], count};
    }

    // Returns an array of items with this value. Throws std::bad_alloc.
    template <class T>
    dxArenaArray<T> takeFilled(std::size_t count, const T &value) {
        const dxArenaArray<T> array = take<T>(count);
        std::fill(array.begin(), array.end(), value);
        return array;
    }

    // Returns an array of no items, with room for this many. Throws std::bad_alloc.
    template <class T>
    dxArenaArray<T> takeList(std::size_t room) {
        dxArenaArray<T> list = take<T>(room);
        list.clear();
        return list;
    }

private:
    struct alignas(kCacheLine) Line {
        unsigned char bytes[kCacheLine];
    };
    struct Block {
        std::unique_ptr<Line[]> lines;
        std::size_t bytes = 0;
    };

    static constexpr std::size_t kMinBlock = 16384;

    void *takeBytes(std::size_t bytes) {
        bytes = (bytes + kCacheLine - 1) / kCacheLine * kCacheLine;
        if (m_blocks.empty() || m_blocks.back().bytes - m_used < bytes) addBlock(std::max({bytes, m_capacity, kMinBlock}));
        void *const place = reinterpret_cast<unsigned char *>(m_blocks.back().lines.get()) + m_used;
        m_used += bytes;
        return place;
    }

    void addBlock(std::size_t bytes) {
        const std::size_t lines = (bytes + kCacheLine - 1) / kCacheLine;
        m_blocks.reserve(m_blocks.size() + 1);
        m_blocks.push_back({std::unique_ptr<Line[]>(new Line[lines]), lines * kCacheLine});
        m_capacity += lines * kCacheLine;
        m_used = 0;
    }

    void makeOneBlock(std::size_t bytes) {
        m_blocks.clear();
        m_capacity = 0;
        addBlock(bytes);
    }

    std::vector<Block> m_blocks;
    std::size_t m_capacity = 0;  // of all blocks
    std::size_t m_used = 0;      // of the last block
};
