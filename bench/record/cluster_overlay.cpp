#include "record/cluster_overlay.h"

#include <dlfcn.h>

#include <stdexcept>
#include <string>

namespace record {

namespace {

// Finds a function of ode_MT.h by name: the programs are linked to what Debian's library exports. Throws std::runtime_error if the library has none.
template <class Function>
void findOwn(const char *name, Function &function) {
    function = reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
    if (!function) throw std::runtime_error(std::string("this libode.so.8 has no ") + name + ": it is not ODE_MT");
}

// All of what `get(values, capacity)` writes, which returns how many there are.
template <class Value, class Get>
std::vector<Value> all(Get get) {
    std::vector<Value> values(static_cast<std::size_t>(get(nullptr, 0)));
    get(values.data(), static_cast<int>(values.size()));
    return values;
}

}  // namespace

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

ClusterOverlay::ClusterOverlay() {
    findOwn("dClusterGetCount", m_count);
    findOwn("dClusterGetGridCells", m_gridCells);
    findOwn("dClusterGetGridStep", m_gridStep);
    findOwn("dClusterGetCenter", m_center);
    findOwn("dClusterGetCells", m_cells);
    findOwn("dClusterGetEvents", m_events);
    findOwn("dClusterGetOfBody", m_ofBody);
    findOwn("dClusterGetOfGeom", m_ofGeom);
    findOwn("dClusterGetStaticOfGeom", m_staticOfGeom);
    findOwn("dClusterGetTestedWith", m_testedWith);
}

Grid ClusterOverlay::grid(dWorldID world, dSpaceID space) const {
    float x = 0, y = 0, z = 0;
    m_center(world, space, &x, &y, &z);
    return {m_gridCells(world, space), m_gridStep(world, space), {x, y, z}};
}

std::vector<Cell> ClusterOverlay::cells(dWorldID world, dSpaceID space) const {
    std::vector<Cell> cells;
    for (const dClusterCell &cell : all<dClusterCell>(
             [&](dClusterCell *values, int capacity) { return m_cells(world, space, values, capacity); }))
        cells.push_back({cell.x, cell.y, cell.z, cell.cluster});
    return cells;
}

std::vector<Event> ClusterOverlay::events(dWorldID world, dSpaceID space) const {
    std::vector<Event> events;
    for (const dClusterEvent &event : all<dClusterEvent>(
             [&](dClusterEvent *values, int capacity) { return m_events(world, space, values, capacity); }))
        events.push_back({event.isSplit != 0, event.from, event.into});
    return events;
}

Membership ClusterOverlay::of(dGeomID geom) const {
    return {m_ofGeom(geom), m_staticOfGeom(geom), all<unsigned>([&](unsigned *values, int capacity) {
                return m_testedWith(geom, values, capacity);
            })};
}

}  // namespace record
