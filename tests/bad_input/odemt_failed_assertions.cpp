// Fails the assertions that ODE_MT raises in upstream's place, one after the other, and prints what each says.
#include <ode/ode.h>

#include <dlfcn.h>

#include <csetjmp>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace {

std::jmp_buf g_outOfTheCall;
char g_answer[1024];

// Destructors of spaces assert, too: they let no exception out.
void leave(int number, const char *format, va_list arguments) {
    const int length = std::snprintf(g_answer, sizeof g_answer, "debug %d ", number);
    std::vsnprintf(g_answer + length, sizeof g_answer - static_cast<std::size_t>(length), format, arguments);
    std::longjmp(g_outOfTheCall, 1);
}

// Objects are left behind: an assertion leaves calls half done.
void tell(const std::string &what, const std::function<void()> &call) {
    if (setjmp(g_outOfTheCall) == 0) {
        std::strcpy(g_answer, "returns");
        call();
    }
    std::printf("%s: %s\n", what.c_str(), g_answer);
}

void ignorePair(void *, dGeomID, dGeomID) {}

dSpaceID makeQuadTree(dReal extentX, dReal extentY) {
    const dVector3 centre = {0, 0, 0}, extents = {extentX, extentY, 10};
    return dQuadTreeSpaceCreate(nullptr, centre, extents, 2);
}

struct Kind {
    std::string name;
    std::function<dSpaceID()> make;
};

const std::vector<Kind> kKinds = {
    {"simple", [] { return dSimpleSpaceCreate(nullptr); }},
    {"hash", [] { return dHashSpaceCreate(nullptr); }},
    {"sweep and prune", [] { return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ); }},
    {"quad tree", [] { return makeQuadTree(10, 10); }},
};

// --- any space ----------------------------------------------------------------------------------------------

// What a near-callback does with the space, which is locked.
void callInNearCallback(dSpaceID space, const std::function<void()> &call) {
    for (int i = 0; i < 2; ++i) dCreateSphere(space, 1);
    const auto callBack = [](void *data, dGeomID, dGeomID) { (*static_cast<const std::function<void()> *>(data))(); };
    dSpaceCollide(space, const_cast<std::function<void()> *>(&call), callBack);
}

void failMembers(const Kind &kind) {
    const dSpaceID space = kind.make(), other = kind.make();
    const dGeomID member = dCreateSphere(space, 1), foreign = dCreateSphere(other, 1), lone = dCreateSphere(nullptr, 1);
    tell(kind.name + ", no geom comes", [&] { dSpaceAdd(space, nullptr); });
    tell(kind.name + ", a member comes again", [&] { dSpaceAdd(space, member); });
    tell(kind.name + ", a member of another one comes", [&] { dSpaceAdd(space, foreign); });
    tell(kind.name + ", no geom goes", [&] { dSpaceRemove(space, nullptr); });
    tell(kind.name + ", a member of another one goes", [&] { dSpaceRemove(space, foreign); });
    tell(kind.name + ", a geom of no space goes", [&] { dSpaceRemove(space, lone); });
    for (const int index : {-1, 0, 1}) tell(kind.name + ", geom " + std::to_string(index), [&] { dSpaceGetGeom(space, index); });
}

void failCalls(const Kind &kind) {
    const dSpaceID space = kind.make(), other = kind.make();
    for (const dSpaceID one : {space, other})
        for (int i = 0; i < 2; ++i) dCreateSphere(one, 1);
    const dGeomID lone = dCreateSphere(nullptr, 1);
    const auto geomOf = [](dSpaceID of) { return reinterpret_cast<dGeomID>(of); };
    tell(kind.name + ", no callback", [&] { dSpaceCollide(space, nullptr, nullptr); });
    tell(kind.name + ", no callback for a geom", [&] { dSpaceCollide2(geomOf(space), lone, nullptr, nullptr); });
    tell(kind.name + ", no callback for a space", [&] { dSpaceCollide2(geomOf(space), geomOf(other), nullptr, nullptr); });
}

void failLocked(const Kind &kind) {
    const auto tellLocked = [&](const char *what, const std::function<void(dSpaceID)> &call) {
        const dSpaceID space = kind.make();
        tell(kind.name + ", locked, " + what, [&] { callInNearCallback(space, [&] { call(space); }); });
    };
    tellLocked("a geom comes", [](dSpaceID space) { dSpaceAdd(space, dCreateSphere(nullptr, 1)); });
    tellLocked("a geom goes", [](dSpaceID space) { dSpaceRemove(space, dCreateSphere(nullptr, 1)); });
    tellLocked("destroyed", [](dSpaceID space) { dSpaceDestroy(space); });
}

// A mesh gets other data, which no space hears of: its box is not up to date. It has come to the space last or first, and lies behind the other geom
// or before it.
void failUncleanBoxes(const Kind &kind) {
    static const float vertices[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    static const dTriIndex indices[] = {0, 1, 2};
    for (const bool isSphereFirst : {true, false}) {
        const dSpaceID space = kind.make();
        const dTriMeshDataID data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSingle(data, vertices, 3 * sizeof(float), 3, indices, 3, 3 * sizeof(dTriIndex));
        const dGeomID before = isSphereFirst ? dCreateSphere(space, 1) : nullptr;
        const dGeomID mesh = dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
        dGeomSetPosition(isSphereFirst ? before : dCreateSphere(space, 1), isSphereFirst ? -0.5 : 1.5, 0, 0);
        const dGeomID lone = dCreateSphere(nullptr, 1);
        dSpaceCollide(space, nullptr, &ignorePair);
        dGeomTriMeshSetData(mesh, data);
        const std::string name = kind.name + (isSphereFirst ? ", an unclean mesh last" : ", an unclean mesh first");
        tell(name, [&] { dSpaceCollide(space, nullptr, &ignorePair); });
        tell(name + ", and a geom", [&] { dSpaceCollide2(lone, reinterpret_cast<dGeomID>(space), nullptr, &ignorePair); });
    }
}

// --- one kind -----------------------------------------------------------------------------------------------

void failHashSpaces() {
    const dSpaceID hash = dHashSpaceCreate(nullptr), simple = dSimpleSpaceCreate(nullptr);
    int low, high;
    tell("hash, levels of no space", [&] { dHashSpaceSetLevels(nullptr, 0, 1); });
    tell("hash, levels crossed", [&] { dHashSpaceSetLevels(hash, 2, 1); });
    tell("hash, levels of another kind", [&] { dHashSpaceSetLevels(simple, 0, 1); });
    tell("hash, levels of no space read", [&] { dHashSpaceGetLevels(nullptr, &low, &high); });
    tell("hash, levels of another kind read", [&] { dHashSpaceGetLevels(simple, &low, &high); });
    for (const dReal far : {dReal(1e12), dReal(-1e12)}) {
        const dSpaceID space = dHashSpaceCreate(nullptr);
        dCreateSphere(space, 1);
        dGeomSetPosition(dCreateSphere(space, dReal(0.01)), far, 0, 0);
        tell("hash, a sphere at " + std::to_string(far), [&] { dSpaceCollide(space, nullptr, &ignorePair); });
    }
}

void failQuadTrees() {
    for (const auto &[x, y] : {std::pair<dReal, dReal>{-1, 1}, {1, -1}, {dInfinity, 1}, {1, dInfinity}})
        tell("quad tree, extents " + std::to_string(x) + " and " + std::to_string(y), [x = x, y = y] { makeQuadTree(x, y); });
}

dSpaceID spaceToClean;

// Has the space cleaned that is cleaning it.
void findBox(dGeomID, dReal box[6]) {
    for (int i = 0; i < 6; ++i) box[i] = i % 2 == 0 ? -1 : 1;
    const dSpaceID space = std::exchange(spaceToClean, nullptr);
    if (space != nullptr) dSpaceClean(space);
}

void failSweepSpaces() {
    dGeomClass geomClass = {};
    geomClass.aabb = &findBox;
    geomClass.collider = [](int) -> dColliderFn * { return nullptr; };
    const int number = dCreateGeomClass(&geomClass);
    const dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    for (int i = 0; i < 2; ++i) dSpaceAdd(space, dCreateGeom(number));
    spaceToClean = space;
    tell("sweep and prune, cleaned while it cleans", [&] { dSpaceCollide(space, nullptr, &ignorePair); });
}

}  // namespace

int main() {
    Dl_info library;
    dladdr(reinterpret_cast<void *>(&dInitODE2), &library);
    std::printf("%s\n", library.dli_fname);
    dInitODE2(0);
    dSetDebugHandler(&leave);
    for (const Kind &kind : kKinds) {
        failMembers(kind);
        failCalls(kind);
        failLocked(kind);
        failUncleanBoxes(kind);
    }
    failHashSpaces();
    failQuadTrees();
    failSweepSpaces();
    std::fflush(stdout);
    std::_Exit(0);
}
