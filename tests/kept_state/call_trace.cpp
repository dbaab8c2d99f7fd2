#include "call_trace.h"

#include <cmath>
#include <cstdio>
#include <cstring>

namespace kept_state {

void CallTrace::word(const std::string &text) {
    for (const unsigned char c : text + ' ') m_hash = (m_hash ^ c) * 1099511628211u;
    if (m_keepsText) m_text += text + ' ';
}

void CallTrace::number(double value) {
    if (std::isnan(value)) return word("nan");
    std::uint64_t bits;
    std::memcpy(&bits, &value, sizeof bits);
    if (!m_keepsText) {
        m_hash = (m_hash ^ bits) * 1099511628211u;
        m_hash ^= m_hash >> 29;
        return;
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    word(text);
}

void CallTrace::numbers(const dReal *values, int count) {
    for (int i = 0; i < count; ++i) number(values[i]);
}

void CallTrace::object(const void *object) {
    const auto known = m_known.find(object);
    word(object == nullptr        ? "none"
         : known == m_known.end() ? "stranger"
                                  : '#' + std::to_string(known->second));
}

void CallTrace::endLine() {
    m_hash = (m_hash ^ '\n') * 1099511628211u;
    if (m_keepsText) m_text += '\n';
}

void CallTrace::line(const std::string &text) {
    word(text);
    endLine();
}

void CallTrace::line(const std::string &what, double value) {
    word(what);
    number(value);
    endLine();
}

void CallTrace::know(const void *object) { m_known[object] = m_count++; }
void CallTrace::forget(const void *object) { m_known.erase(object); }

}  // namespace kept_state
