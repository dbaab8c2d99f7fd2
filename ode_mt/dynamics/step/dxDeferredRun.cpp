#include "dynamics/step/dxDeferredRun.h"

#include <ode/error.h>

#include <cstdio>
#include <new>

namespace {

std::string formatText(const char *format, va_list arguments) {
    va_list again;
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, arguments);
    std::string text(length > 0 ? static_cast<std::size_t>(length) : 0, '\0');
    std::vsnprintf(text.data(), text.size() + 1, format, again);
    va_end(again);
    return text;
}

}  // namespace

void dxKeptReport::deliver() const {
    switch (kind) {
        case dxReport::Message:
            dMessage(number, "%s", text.c_str());
            break;
        case dxReport::Debug:
            dDebug(number, "%s", text.c_str());
        case dxReport::Error:
            dError(number, "%s", text.c_str());
    }
}

std::uint32_t dxDeferredScope::takeBlock(std::uint64_t draws) {
    const std::uint32_t before = m_seed;
    m_seed = dxRandom::jump(m_seed, draws);
    return before;
}

bool dxDeferredScope::takeOver(dxReport kind, int number, const char *format, va_list arguments) {
    if (m_hasUserHandlers) throw dxUpstreamInterrupted();
    try {
        m_reports.push_back({m_unit, kind, number, formatText(format, arguments)});
    } catch (const std::bad_alloc &) {
        if (kind == dxReport::Message) return false;  // it is printed at once, out of order
    }
    if (kind != dxReport::Message) throw dxUpstreamInterrupted();
    return true;
}

void dxDeferredRun::begin(unsigned units, unsigned workers, bool hasUserHandlers) {
    m_units.assign(units, {});
    if (m_workers.size() < workers) m_workers.resize(workers);
    for (Worker &worker : m_workers) {
        worker.reports.clear();
        worker.feedbacks.clear();
        // One worker may come to survey all units: room for what the last run found keeps a steady state from allocating.
        worker.feedbacks.reserve(m_feedbacks.size());
        worker.busyNs = 0;
    }
    m_hasUserHandlers = hasUserHandlers;
    m_randomEnd = 0;
    m_interrupted.store(units, std::memory_order_relaxed);
}

void dxDeferredRun::interruptAt(unsigned unit) {
    unsigned known = m_interrupted.load(std::memory_order_relaxed);
    while (unit < known && !m_interrupted.compare_exchange_weak(known, unit, std::memory_order_relaxed)) {
    }
}

void dxDeferredRun::sortFeedback() {
    m_feedbacks.clear();
    for (const Worker &worker : m_workers) m_feedbacks.insert(m_feedbacks.end(), worker.feedbacks.begin(), worker.feedbacks.end());
    std::sort(m_feedbacks.begin(), m_feedbacks.end(), [](const dxFeedbackUse &a, const dxFeedbackUse &b) {
        return a.feedback != b.feedback ? a.feedback < b.feedback : a.unit < b.unit;
    });
}

// The workers that ran the unit have its reports, and few units have any.
void dxDeferredRun::deliverReports(unsigned unit) const {
    const Unit &one = m_units[unit];
    if (one.first == kNoIndex) return;
    const auto deliver = [this, unit](unsigned worker) {
        for (const dxKeptReport &report : m_workers[worker].reports)
            if (report.unit == unit) report.deliver();
    };
    deliver(one.first);
    if (one.last != one.first) deliver(one.last);
}

double dxDeferredRun::busyNs() const {
    double busy = 0;
    for (const Worker &worker : m_workers) busy += worker.busyNs;
    return busy;
}
