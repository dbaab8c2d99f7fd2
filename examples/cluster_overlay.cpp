// A debug overlay of clusters: which balls are tested with one another, and which cells of the grid they are in. Two groups of balls
// roll towards each other; when they meet, their clusters merge. Prints the clusters where they change.
#include <ode/ode.h>

#include <cstdio>
#include <vector>

namespace {

struct Scene {
    dWorldID world;
    dJointGroupID contacts;
};

void collide(void *data, dGeomID geom1, dGeomID geom2) {
    const auto *const scene = static_cast<const Scene *>(data);
    dContact contact = {};
    if (dCollide(geom1, geom2, 1, &contact.geom, sizeof(dContact)) == 0) return;
    contact.surface.mu = 0;
    dJointAttach(dJointCreateContact(scene->world, scene->contacts, &contact), dGeomGetBody(geom1), dGeomGetBody(geom2));
}

void print(int step, dWorldID world, dSpaceID space, const std::vector<dBodyID> &balls) {
    std::printf("step %3d: %d clusters; balls are in", step, dClusterGetCount(world, space));
    for (const dBodyID ball : balls) std::printf(" %u", dClusterGetOfBody(ball));
    std::vector<dClusterEvent> events(dClusterGetEvents(world, space, nullptr, 0));
    dClusterGetEvents(world, space, events.data(), static_cast<int>(events.size()));
    for (const dClusterEvent &event : events)
        if (event.isSplit)
            std::printf("; %u split from %u", event.into, event.from);
        else
            std::printf("; %u merged into %u", event.from, event.into);
    // What an overlay would draw: cells of an edge, coloured by cluster.
    std::vector<dClusterCell> cells(dClusterGetCells(world, space, nullptr, 0));
    dClusterGetCells(world, space, cells.data(), static_cast<int>(cells.size()));
    std::printf("; %zu cells of %.2f m\n", cells.size(), dClusterGetGridStep(world, space));
}

}  // namespace

int main() {
    dInitODE2(0);
    dODE_MT_SetAlgorithm("decluster");
    dODE_MT_SetHeuristics("none");  // clusters are checked in each frame, and the grid is fixed, so that pictures do not jump
    dODE_MT_SetGridCells(12);
    const Scene scene{dWorldCreate(), dJointGroupCreate(0)};
    const dSpaceID space = dHashSpaceCreate(nullptr);
    std::vector<dBodyID> balls;
    for (int i = 0; i < 6; ++i) {
        const bool isLeft = i < 3;
        const dBodyID ball = dBodyCreate(scene.world);
        dBodySetPosition(ball, isLeft ? -4 : 4, 0.5 * (i % 3), 0);
        dBodySetLinearVel(ball, isLeft ? 1 : -1, 0, 0);
        dGeomSetBody(dCreateSphere(space, 0.2), ball);
        balls.push_back(ball);
    }

    int clusters = 0;
    for (int step = 0; step < 600; ++step) {
        dSpaceCollide(space, const_cast<Scene *>(&scene), collide);
        if (dClusterGetCount(scene.world, space) != clusters) print(step, scene.world, space, balls);
        clusters = dClusterGetCount(scene.world, space);
        dWorldStep(scene.world, 0.01);
        dJointGroupEmpty(scene.contacts);
    }
    dJointGroupDestroy(scene.contacts);
    dSpaceDestroy(space);
    dWorldDestroy(scene.world);
    dCloseODE();
}
