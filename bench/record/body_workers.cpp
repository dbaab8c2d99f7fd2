#include "record/body_workers.h"

#include "record/own_function.h"

namespace record {

BodyWorkers::BodyWorkers() {
    decltype(&dODE_MT_NoteBodyWorkers) note = nullptr;
    findOwn("dODE_MT_NoteBodyWorkers", note);
    findOwn("dODE_MT_GetBodyWorker", m_get);
    note(1);
}

std::vector<int> BodyWorkers::of(const std::vector<dBodyID> &bodies) const {
    std::vector<int> workers;
    for (const dBodyID body : bodies) workers.push_back(m_get(body));
    return workers;
}

}  // namespace record
