#include "dynamics/quick_step/fast/dxColoredSweeps.h"

void dxColoredSweeps::reserve(unsigned chunks) {
    m_energies.reserve(chunks);
    if (m_claimCount >= chunks) return;
    m_claims = std::make_unique<std::atomic<unsigned>[]>(chunks);
    m_claimCount = chunks;
}

void dxColoredSweeps::begin(const dxConstraintPlan &plan, unsigned most) {
    m_phases = plan.phases().data();
    m_phaseCount = static_cast<unsigned>(plan.phases().size());
    m_chunkCount = static_cast<unsigned>(plan.chunks().size());
    m_most = m_phaseCount == 0 ? 0 : most;
    reserve(m_chunkCount);
    m_energies.resize(m_chunkCount);
    for (unsigned chunk = 0; chunk < m_chunkCount; ++chunk) m_claims[chunk].store(0, std::memory_order_relaxed);
    m_position.store(0, std::memory_order_relaxed);
    m_end.store(m_most * m_phaseCount, std::memory_order_relaxed);
    m_finished.store(0, std::memory_order_relaxed);
}
