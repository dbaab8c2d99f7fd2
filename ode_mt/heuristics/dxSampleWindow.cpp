#include "heuristics/dxSampleWindow.h"

#include <numeric>

void dxSampleWindow::add(double value) {
    if (m_samples.size() < m_window) {
        m_samples.push_back(value);
        return;
    }
    m_samples[m_next] = value;
    m_next = (m_next + 1) % m_window;
}

void dxSampleWindow::clear() {
    m_samples.clear();
    m_next = 0;
}

double dxSampleWindow::average() const {
    if (m_samples.empty()) return 0;
    return std::accumulate(m_samples.begin(), m_samples.end(), 0.0) / static_cast<double>(m_samples.size());
}

double dxSampleWindow::speed() const {
    if (m_samples.size() < 2) return 0;
    return (newest() - oldest()) / static_cast<double>(m_samples.size() - 1);
}
