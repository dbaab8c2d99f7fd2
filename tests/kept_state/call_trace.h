// What one case of the call test saw: lines of text whose hash is compared between libraries. Numbers are
// written with all their bits; every NaN is equal. Text is kept only if it is to be shown.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <map>
#include <string>

namespace kept_state {

class CallTrace {
public:
    explicit CallTrace(bool keepsText) : m_keepsText(keepsText) {}

    void word(const std::string &text);
    void number(double value);
    void numbers(const dReal *values, int count);
    void object(const void *object);  // by its place in the order of acquaintance; null is "none"
    void endLine();

    void line(const std::string &text);
    void line(const std::string &what, double value);

    // Objects are numbered in the order in which they became known.
    void know(const void *object);
    void forget(const void *object);  // whose address another object may get

    std::uint64_t hash() const { return m_hash; }
    const std::string &text() const { return m_text; }

private:
    bool m_keepsText;
    std::uint64_t m_hash = 1469598103934665603u;  // FNV-1a
    std::string m_text;
    std::map<const void *, int> m_known;
    int m_count = 0;
};

}  // namespace kept_state
