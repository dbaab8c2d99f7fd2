// A sum over many numbers that depends on their order: for events too many to note each by itself.
#pragma once

#include <cstdint>
#include <cstring>

namespace exactness {

class OrderSum {
public:
    void add(std::int64_t number) {
        m_sum = (m_sum ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15u;
        m_sum ^= m_sum >> 29;
        ++m_count;
    }
    void addReal(double number) {
        std::int64_t bits;
        std::memcpy(&bits, &number, sizeof bits);
        add(bits);
    }

    long count() const { return m_count; }
    double value() const { return static_cast<double>(m_sum >> 11); }  // as many bits as a double holds

private:
    std::uint64_t m_sum = 0;
    long m_count = 0;
};

}  // namespace exactness
