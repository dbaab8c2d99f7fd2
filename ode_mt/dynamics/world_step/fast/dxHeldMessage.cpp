#include "dynamics/world_step/fast/dxHeldMessage.h"

#include <ode/error.h>

#include <cstdio>
#include <cstdlib>

bool dxHeldMessage::takeOver(dxReport kind, int number, const char *format, va_list arguments) {
    if (kind != dxReport::Message) {
        leave();
        dxUpstreamScope *const outer = current();
        return outer != nullptr && outer->takeOver(kind, number, format, arguments);
    }
    if (!m_isHeld) std::vsnprintf(m_text, sizeof m_text, format, arguments);
    m_number = number;
    m_isHeld = true;
    return true;
}

// Neither happens where a message may.
std::uint32_t dxHeldMessage::takeBlock(std::uint64_t) { std::abort(); }
bool dxHeldMessage::defersMoved() const { return false; }

void dxHeldMessage::deliver() {
    leave();
    if (m_isHeld) dMessage(m_number, "%s", m_text);
}
