#include "threading/timeline/dxTimelineRing.h"

#include <algorithm>
#include <cstddef>

#include "core/dxPrefetch.h"
#include "threading/timeline/dxTimeline.h"

namespace {

// Records between the one that is written and the one whose cache line is requested for write: a step writes some at once.
constexpr std::uint64_t kPrefetchDistance = 4;

}  // namespace

void dxTimelineRing::add(const dxTimelineEvent &event, std::uint64_t begin, std::uint64_t end, const Arguments &arguments) {
    m_times[event.stage] += end - begin;
    if (!dxTimeline::isTraced()) return;
    const std::uint64_t head = m_head.load(std::memory_order_relaxed);
    std::atomic<std::uint64_t> *const words = m_records[head % kCapacity].words;
    set(words[kBegin], begin);
    set(words[kEnd], end);
    set(words[kEvent], reinterpret_cast<std::uintptr_t>(&event));
    set(words[kFrame], std::uint64_t{m_caller.frame} << 32 | m_caller.ring->thread());
    for (std::size_t i = 0; i < arguments.size(); ++i) set(words[kArguments + i], arguments[i]);
    m_head.store(head + 1, std::memory_order_release);
    dxPrefetch::lineForWrite(m_records + (head + kPrefetchDistance) % kCapacity);
}

bool dxTimelineRing::isLast(const dxTimelineEvent &event, std::uint64_t run) const {
    if (m_head.load(std::memory_order_relaxed) == 0) return false;
    const std::atomic<std::uint64_t> *const words = last().words;
    return words[kEvent].load(std::memory_order_relaxed) == reinterpret_cast<std::uintptr_t>(&event) &&
           words[kArguments + 1].load(std::memory_order_relaxed) == run;
}

std::uint64_t dxTimelineRing::beginBlock(const dxTimelineEvent &event, std::uint64_t run) const {
    return isLast(event, run) ? last().words[kEnd].load(std::memory_order_relaxed) : dxTimelineClock::ticks();
}

std::uint64_t dxTimelineRing::endBlock(const dxTimelineEvent &event, std::uint64_t run, std::uint64_t begin) {
    const std::uint64_t end = dxTimelineClock::ticks();
    if (!isLast(event, run)) {
        add(event, begin, end, {1, run});
        return end;
    }
    std::atomic<std::uint64_t> *const words = const_cast<Record &>(last()).words;
    set(words[kArguments], words[kArguments].load(std::memory_order_relaxed) + 1);
    set(words[kEnd], end);
    return end;
}

unsigned dxTimelineRing::takeThreads() {
    const unsigned threads = m_threads;
    m_threads = 1;
    return threads;
}

void dxTimelineRing::own(std::uint32_t thread) {
    m_thread.store(thread, std::memory_order_relaxed);
    m_frames = 0;
    m_caller = {this, 0};
    m_threads = 1;
    m_times = {};
    collisionDepth = 0;
    stepBegin = 0;
    takeRowsOfStep();
    forget();
}

std::uint64_t dxTimelineRing::read(std::vector<dxTimelineRecord> &records) const {
    records.clear();
    const std::uint64_t end = m_head.load(std::memory_order_acquire);
    const std::uint64_t begin = std::max(m_first, end - std::min(end, kCapacity));
    records.reserve(end - begin);
    for (std::uint64_t i = begin; i < end; ++i) {
        std::uint64_t words[kWords];
        for (unsigned w = 0; w < kWords; ++w) words[w] = m_records[i % kCapacity].words[w].load(std::memory_order_acquire);
        dxTimelineRecord record{words[kBegin], words[kEnd], reinterpret_cast<const dxTimelineEvent *>(words[kEvent]),
                                static_cast<std::uint32_t>(words[kFrame] >> 32), static_cast<std::uint32_t>(words[kFrame]), {}};
        std::copy_n(words + kArguments, record.arguments.size(), record.arguments.begin());
        records.push_back(record);
    }
    // The owner may have gone on meanwhile, and may be writing the record of its head.
    const std::uint64_t now = m_head.load(std::memory_order_acquire);
    const std::uint64_t whole = now >= kCapacity ? std::max(begin, now - kCapacity + 1) : begin;
    records.erase(records.begin(), records.begin() + static_cast<std::ptrdiff_t>(std::min(whole - begin, end - begin)));
    return std::min(whole, end) - m_first;
}
