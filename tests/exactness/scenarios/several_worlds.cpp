#include "additions.h"
#include "scenario_scene.h"

#include <dlfcn.h>

#include <cstdlib>
#include <vector>

namespace exactness {

namespace {

// Worlds side by side in one space, with other settings each, stepped one after the other.
class SeveralWorlds : public ManyParts {
public:
    explicit SeveralWorlds(Stepper stepper) : ManyParts(stepper) {
        addGround();
        for (int i = 1; i < 3; ++i) addWorld();
        const std::vector<dWorldID> &worlds = m_inventory.worlds;
        dWorldSetGravity(worlds[1], 0, 1, -4);
        dWorldSetCFM(worlds[1], 1e-4);
        dWorldSetERP(worlds[2], 0.5);
        dWorldSetQuickStepNumIterations(worlds[2], 33);
        addParts([&](int part, Vector3 origin) { addStack(worlds[part % worlds.size()], origin); }, 24);
    }

protected:
    void addStack(dWorldID where, Vector3 origin) {
        for (int i = 0; i < 5; ++i) {
            const dBodyID body =
                addBody(origin + Vector3{dReal(0.03) * i, 0, dReal(0.24) + dReal(0.5) * i}, where);
            const dGeomID box = dCreateBox(space(), 0.5, 0.5, 0.5);
            dGeomSetBody(box, body);
            add(box);
        }
    }
};

// More of them, which ODE_MT steps in one call.
class Together : public SeveralWorlds {
public:
    explicit Together(Stepper stepper) : SeveralWorlds(stepper) {
        for (int i = 0; i < 9; ++i) {
            dWorldSetQuickStepNumIterations(addWorld(), 9 + i);
            addStack(m_inventory.worlds.back(), {dReal(30) + 3 * i, 0, 0});
        }
    }

    void step() override {
        using StepWorlds = int(const dWorldID *, int, const char *, dReal);
        const auto together = reinterpret_cast<StepWorlds *>(dlsym(RTLD_DEFAULT, "dODE_MT_StepWorlds"));
        if (together == nullptr) return SeveralWorlds::step();
        const std::vector<dWorldID> &worlds = m_inventory.worlds;
        together(worlds.data(), static_cast<int>(worlds.size()), stepper() == Stepper::World ? "step" : "quick", m_stepSize);
    }
};

// The worlds share one working memory, which is taken away and given back at times.
class SharedMemory : public SeveralWorlds {
public:
    explicit SharedMemory(Stepper stepper) : SeveralWorlds(stepper) { share(); }

    void control() override {
        const std::vector<dWorldID> &worlds = m_inventory.worlds;
        if (frameNumber() == 20) dWorldUseSharedWorkingMemory(worlds[1], nullptr);
        if (frameNumber() == 30) dWorldCleanupWorkingMemory(worlds[0]);
        if (frameNumber() == 40) share();
        if (frameNumber() == 50) reserveMore(worlds[2]);
    }

private:
    void share() {
        const std::vector<dWorldID> &worlds = m_inventory.worlds;
        for (std::size_t i = 1; i < worlds.size(); ++i) {
            dWorldUseSharedWorkingMemory(worlds[i], nullptr);  // gives up what it has
            dWorldUseSharedWorkingMemory(worlds[i], worlds[0]);
        }
    }

    static void reserveMore(dWorldID where) {
        dWorldCleanupWorkingMemory(where);
        dWorldStepReserveInfo policy = {sizeof(policy), 2.5f, 1 << 18};
        dWorldSetStepMemoryReservationPolicy(where, &policy);
    }
};

// Working memory comes from the user, who counts the calls.
class UserMemory : public SeveralWorlds {
public:
    explicit UserMemory(Stepper stepper) : SeveralWorlds(stepper) {
        blocksInUse = 0;
        dWorldStepMemoryFunctionsInfo functions = {sizeof(functions), &allocate, &shrink, &release};
        for (dWorldID each : m_inventory.worlds) dWorldSetStepMemoryManager(each, &functions);
    }

    ~UserMemory() override {
        for (dWorldID each : m_inventory.worlds) dWorldCleanupWorkingMemory(each);
        note("blocks in use at the end", blocksInUse);
    }

private:
    static void *allocate(dsizeint size) {
        ++blocksInUse;
        static_cast<UserMemory &>(living()).note("memory allocated", static_cast<double>(size));
        return std::malloc(size);
    }

    static void *shrink(void *block, dsizeint, dsizeint smaller) {
        static_cast<UserMemory &>(living()).note("memory shrunk", static_cast<double>(smaller));
        return std::realloc(block, smaller);
    }

    static void release(void *block, dsizeint size) {
        --blocksInUse;
        static_cast<UserMemory &>(living()).note("memory freed", static_cast<double>(size));
        std::free(block);
    }

    static int blocksInUse;
};

int UserMemory::blocksInUse = 0;

}  // namespace

void addSeveralWorlds(Catalogue &catalogue) {
    catalogue.push_back({"several_worlds", "three worlds in one space", 70, make<SeveralWorlds>()});
    catalogue.push_back({"several_worlds/together", "twelve worlds in one space, stepped in one call", 25, make<Together>(),
                         "each world is stepped by one thread"});
    catalogue.push_back(
        {"several_worlds/shared_memory", "three worlds that share working memory", 70, make<SharedMemory>()});
    catalogue.push_back({"several_worlds/user_memory", "working memory from the user, calls in order", 70,
                         make<UserMemory>()});
}

}  // namespace exactness
