#include "dynamics/step/islands/dxDeferredIsland.h"

#include <ode/error.h>

#include <cstdio>
#include <new>

#include "dynamics/step/random/dxRandom.h"

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

std::uint32_t dxDeferredIsland::takeBlock(std::uint64_t draws) {
    const std::uint32_t before = m_seed;
    m_seed = dxRandom::jump(m_seed, draws);
    return before;
}

bool dxDeferredIsland::takeOver(dxReport kind, int number, const char *format, va_list arguments) {
    if (m_userHandlers) throw dxUpstreamInterrupted();
    try {
        m_reports.push_back({m_island, kind, number, formatText(format, arguments)});
    } catch (const std::bad_alloc &) {
        if (kind == dxReport::Message) return false;  // is printed at once, out of its order
    }
    if (kind != dxReport::Message) throw dxUpstreamInterrupted();
    return true;
}
