#include "call_scene.h"

#include "call_shapes.h"
#include "user_code.h"

#include <algorithm>
#include <cstdarg>
#include <cstdio>

namespace kept_state {

namespace {

std::string textOf(const char *text, va_list arguments) {
    char buffer[1000];
    std::vsnprintf(buffer, sizeof buffer, text, arguments);
    const std::string whole = buffer;
    return whole.substr(0, whole.find(" ["));  // file and line of an assertion are not compared
}

void tellHandler(const char *kind, int number, const char *text, va_list arguments) {
    if (CallScene::living == nullptr) return;
    CallScene::living->trace.line(std::string(kind) + ": " + textOf(text, arguments), number);
}

void onMessage(int number, const char *text, va_list arguments) {
    tellHandler("message", number, text, arguments);
    reached(UserCode::messageHandler);
}

// A jump rather than an exception: an exception out of a constructor would free a geom that is in a list
// already.
void onDebug(int number, const char *text, va_list arguments) {
    tellHandler("debug", number, text, arguments);
    reached(UserCode::debugHandler);
    std::longjmp(*CallScene::faultTarget, 1);
}

void onError(int number, const char *text, va_list arguments) {
    tellHandler("error", number, text, arguments);
    std::longjmp(*CallScene::faultTarget, 1);
}

}  // namespace

CallScene *CallScene::living = nullptr;
std::jmp_buf *CallScene::faultTarget = nullptr;

const char *nameOf(SpaceKind kind) {
    static const char *const names[] = {"simple", "hash", "sap", "quadtree"};
    return names[static_cast<int>(kind)];
}

const char *nameOf(Place place) {
    static const char *const names[] = {"root", "nested", "other", "nowhere"};
    return names[static_cast<int>(place)];
}

dSpaceID createSpace(SpaceKind kind, dSpaceID parent) {
    const dVector3 center{0, 0, 0, 0}, extents{8, 8, 8, 0};
    switch (kind) {
        case SpaceKind::simple:
            return dSimpleSpaceCreate(parent);
        case SpaceKind::hash:
            return dHashSpaceCreate(parent);
        case SpaceKind::sweepAndPrune:
            return dSweepAndPruneSpaceCreate(parent, dSAP_AXES_XYZ);
        default:
            return dQuadTreeSpaceCreate(parent, center, extents, 4);
    }
}

CallScene::CallScene(SpaceKind kind, Place place, int turn, bool keepsText)
    : kind(kind), place(place), turn(turn), trace(keepsText) {
    living = this;
    dSetMessageHandler(onMessage);
    dSetDebugHandler(onDebug);
    dSetErrorHandler(onError);
    dRandSetSeed(7);
    trace.know(world = dWorldCreate());
    trace.know(second = dWorldCreate());
    for (const dWorldID w : {world, second}) {
        dWorldSetGravity(w, 0, 0, -9.81);
        dWorldSetERP(w, 0.3);
        dWorldSetCFM(w, 1e-5);
    }
    contacts = dJointGroupCreate(0);
    const SpaceKind inner = allSpaceKinds[(static_cast<int>(kind) + 1 + turn % 4) % 4];
    GeomSet &root = setAt(Place::root), &nested = setAt(Place::nested);
    root.space = createSpace(kind, nullptr);
    nested.space = createSpace(inner, root.space);
    setAt(Place::other).space = createSpace(turn % 2 == 0 ? kind : SpaceKind::hash, nullptr);
    for (int i = 0; i < 3; ++i) trace.know(m_sets[i].space);
    for (int i = 0; i < 4; ++i) fill(m_sets[i], i);
    addTowers();
    addJoints();
}

dGeomID CallScene::put(GeomSet &set, dGeomID geom, int number, bool withBody) {
    trace.know(geom);
    set.all.push_back(geom);
    if (dGeomGetClass(geom) == dPlaneClass) return geom;
    const int index = static_cast<int>(set.all.size());
    const dReal x = 0.42 * (index % 4) + 0.11 * number, y = 0.4 * (index / 4), z = 0.25 + 0.22 * number;
    if (withBody) {
        dMass mass;
        dMassSetSphereTotal(&mass, 1, 0.2);
        const dBodyID body = dBodyCreate(number == 2 ? second : world);
        trace.know(body);
        bodies.push_back(body);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        dBodySetMovedCallback(body, movedCallback);
        dGeomSetBody(geom, body);
    } else {
        dGeomSetPosition(geom, x, y, z);
    }
    return geom;
}

void CallScene::fill(GeomSet &set, int number) {
    const ConvexArrays convex = convexArrays(0);
    const dSpaceID space = set.space;
    set.plane = put(set, dCreatePlane(space, 0, 0, 1, 0), number, false);
    set.sphere = put(set, dCreateSphere(space, 0.2), number, true);
    set.box = put(set, dCreateBox(space, 0.4, 0.35, 0.3), number, true);
    set.capsule = put(set, dCreateCapsule(space, 0.15, 0.3), number, true);
    set.cylinder = put(set, dCreateCylinder(space, 0.2, 0.4), number, true);
    set.convex = put(set,
                     dCreateConvex(space, convex.planes, convex.planeCount, convex.points, convex.pointCount,
                                   convex.polygons),
                     number, true);
    set.mesh = put(set, dCreateTriMesh(space, createMeshData(0), nullptr, nullptr, nullptr), number, true);
    set.slab = put(set, dCreateBox(space, 0.8, 0.8, 0.2), number, false);
    set.terrain =
        put(set, dCreateTriMesh(space, createMeshData(1), nullptr, nullptr, nullptr), number, false);
    set.heights = put(set, dCreateHeightfield(space, createHeights(0), 1), number, false);
    set.custom = put(set, createCustom(space, 0.3, customClass()), number, false);
    set.tested = put(set, createCustom(space, 0.25, testedClass()), number, false);
    set.ray = put(set, dCreateRay(space, 3), number, false);
    dGeomRaySet(set.ray, 0.3, 0.3, 2, 0.1, 0.05, -1);
    set.transform = put(set, dCreateGeomTransform(space), number, false);
    set.wrapped = dCreateBox(nullptr, 0.3, 0.3, 0.3);
    trace.know(set.wrapped);
    dGeomSetPosition(set.wrapped, 0.1, 0, 0);
    dGeomTransformSetGeom(set.transform, set.wrapped);
    dGeomTransformSetCleanup(set.transform, 1);
}

// Small boxes and balls in towers beside the rest: enough for a second worker.
void CallScene::addTowers() {
    const dSpaceID space = setAt(Place::root).space;
    dMass mass;
    dMassSetSphereTotal(&mass, 1, 0.1);
    for (int i = 0; i < 48; ++i) {
        const dBodyID body = dBodyCreate(world);
        trace.know(body);
        bodies.push_back(body);
        fillers.push_back(body);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, 2.5 + 0.5 * (i % 4) + 0.01 * (i / 12), 0.5 * (i / 4 % 3),
                         0.1 + 0.19 * (i / 12));
        const dGeomID geom = i % 3 == 2 ? dCreateSphere(space, 0.1) : dCreateBox(space, 0.2, 0.2, 0.2);
        trace.know(geom);
        setAt(Place::root).all.push_back(geom);
        dGeomSetBody(geom, body);
    }
}

void CallScene::addJoints() {
    using Create = dJointID (*)(dWorldID, dJointGroupID);
    const std::pair<dJointType, Create> creators[] = {
        {dJointTypeBall, dJointCreateBall},     {dJointTypeHinge, dJointCreateHinge},
        {dJointTypeSlider, dJointCreateSlider}, {dJointTypeUniversal, dJointCreateUniversal},
        {dJointTypeHinge2, dJointCreateHinge2}, {dJointTypeFixed, dJointCreateFixed},
        {dJointTypeNull, dJointCreateNull},     {dJointTypeAMotor, dJointCreateAMotor},
        {dJointTypeLMotor, dJointCreateLMotor}, {dJointTypePlane2D, dJointCreatePlane2D},
        {dJointTypePR, dJointCreatePR},         {dJointTypePU, dJointCreatePU},
        {dJointTypePiston, dJointCreatePiston}, {dJointTypeDBall, dJointCreateDBall},
        {dJointTypeDHinge, dJointCreateDHinge}, {dJointTypeTransmission, dJointCreateTransmission}};
    joints.assign(dJointTypeTransmission + 1, nullptr);
    int number = 0;
    for (const auto &[type, create] : creators) {
        const dJointID joint = joints[type] = create(world, nullptr);
        trace.know(joint);
        const dBodyID upper = filler(36 + number % 12), lower = filler(24 + number % 12);
        ++number;
        dJointAttach(joint, upper, type == dJointTypePlane2D ? nullptr : lower);
        const dReal *at = dBodyGetPosition(upper);
        switch (type) {
            case dJointTypeBall:
                dJointSetBallAnchor(joint, at[0], at[1], at[2]);
                break;
            case dJointTypeHinge:
                dJointSetHingeAnchor(joint, at[0], at[1], at[2]);
                break;
            case dJointTypeUniversal:
                dJointSetUniversalAnchor(joint, at[0], at[1], at[2]);
                break;
            case dJointTypeHinge2: {
                const dVector3 up{0, 0, 1, 0}, side{0, 1, 0, 0};
                dJointSetHinge2Anchor(joint, at[0], at[1], at[2]);
                dJointSetHinge2Axes(joint, up, side);
                break;
            }
            case dJointTypeFixed:
                dJointSetFixed(joint);
                break;
            case dJointTypeAMotor:
                dJointSetAMotorNumAxes(joint, 1);
                dJointSetAMotorAxis(joint, 0, 1, 0, 0, 1);
                break;
            case dJointTypeLMotor:
                dJointSetLMotorNumAxes(joint, 1);
                dJointSetLMotorAxis(joint, 0, 1, 0, 0, 1);
                break;
            case dJointTypeDBall:
                dJointSetDBallAnchor1(joint, at[0], at[1], at[2]);
                dJointSetDBallAnchor2(joint, at[0], at[1], at[2] - 0.3);
                break;
            case dJointTypeDHinge:
                dJointSetDHingeAxis(joint, 1, 0, 0);
                dJointSetDHingeAnchor1(joint, at[0], at[1], at[2]);
                dJointSetDHingeAnchor2(joint, at[0], at[1], at[2] - 0.3);
                break;
            case dJointTypeTransmission:
                dJointSetTransmissionMode(joint, dTransmissionParallelAxes);
                dJointSetTransmissionRatio(joint, 2);
                dJointSetTransmissionAxis(joint, 0, 0, 1);
                dJointSetTransmissionAnchor1(joint, at[0], at[1], at[2]);
                dJointSetTransmissionAnchor2(joint, at[0] + 0.2, at[1], at[2]);
                break;
            default:
                break;
        }
    }
}

// --- frames ---------------------------------------------------------------------------------------------

bool CallScene::attempt(const std::function<void()> &call) {
    std::jmp_buf here, *const outer = faultTarget;
    faultTarget = &here;
    const bool refused = setjmp(here) != 0;
    if (!refused) call();
    faultTarget = outer;
    if (refused) trace.line("refused");
    return !refused;
}

void CallScene::nearCallback(void *scene, dGeomID o1, dGeomID o2) {
    static_cast<CallScene *>(scene)->nearPair(o1, o2);
}

void CallScene::nearPair(dGeomID o1, dGeomID o2) {
    trace.word("near");
    trace.object(o1);
    trace.object(o2);
    trace.endLine();
    if (dGeomIsSpace(o1) || dGeomIsSpace(o2)) return dSpaceCollide2(o1, o2, this, nearCallback);
    if (inNearCallback && ++m_pairs == 9 + turn % 11) {
        const std::function<void()> call = std::move(inNearCallback);
        inNearCallback = nullptr;
        attempt(call);
    }
    const dBodyID b1 = dGeomGetBody(o1), b2 = dGeomGetBody(o2);
    if (b1 != nullptr && b1 == b2) return;
    dContact contact[4]{};
    const int count = dCollide(o1, o2, 4, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        const dContactGeom &found = contact[i].geom;
        trace.word("contact");
        trace.numbers(found.pos, 3);
        trace.numbers(found.normal, 3);
        trace.number(found.depth);
        trace.object(found.g1);
        trace.object(found.g2);
        trace.endLine();
        if (b1 == nullptr && b2 == nullptr) continue;
        const dWorldID w = dBodyGetWorld(b1 != nullptr ? b1 : b2);
        if (b1 != nullptr && b2 != nullptr && dBodyGetWorld(b2) != w) continue;
        if (dGeomGetClass(o1) == dRayClass || dGeomGetClass(o2) == dRayClass) continue;
        contact[i].surface.mode = dContactSoftCFM;
        contact[i].surface.mu = 0.5;
        contact[i].surface.soft_cfm = 0.01;
        dJointAttach(dJointCreateContact(w, contacts, &contact[i]), b1, b2);
    }
}

void CallScene::movedCallback(dBodyID body) {
    CallScene &scene = *living;
    scene.trace.word("moved");
    scene.trace.object(body);
    scene.trace.endLine();
    if (!scene.inMovedCallback) return;
    const std::function<void()> call = std::move(scene.inMovedCallback);
    scene.inMovedCallback = nullptr;
    scene.attempt(call);
}

void CallScene::collide() {
    m_pairs = 0;
    // Callbacks may destroy spaces: each is looked up again.
    const auto space = [this](Place where) { return setAt(where).space; };
    const auto geom = [this](Place where) { return reinterpret_cast<dGeomID>(setAt(where).space); };
    if (space(Place::root) != nullptr) dSpaceCollide(space(Place::root), this, nearCallback);
    if (space(Place::other) != nullptr) dSpaceCollide(space(Place::other), this, nearCallback);
    if (space(Place::root) != nullptr && space(Place::other) != nullptr)
        dSpaceCollide2(geom(Place::root), geom(Place::other), this, nearCallback);
    const std::vector<dGeomID> &loose = setAt(Place::nowhere).all;
    for (std::size_t i = 0; i < loose.size(); i += 3)
        if (space(Place::root) != nullptr) dSpaceCollide2(loose[i], geom(Place::root), this, nearCallback);
}

void CallScene::step() {
    for (const dWorldID w : {world, second}) {
        if (w == nullptr) continue;
        trace.line("step", stepsExactly ? dWorldStep(w, 0.01) : dWorldQuickStep(w, 0.01));
    }
    dJointGroupEmpty(contacts);
    tellBodies();
}

void CallScene::frame() {
    trace.line("frame");
    collide();
    step();
}

void CallScene::tellBodies() {
    for (const dBodyID body : bodies) {
        trace.word("body");
        trace.number(dBodyIsEnabled(body));
        trace.numbers(dBodyGetPosition(body), 3);
        trace.numbers(dBodyGetQuaternion(body), 4);
        trace.numbers(dBodyGetLinearVel(body), 3);
        trace.numbers(dBodyGetAngularVel(body), 3);
        trace.endLine();
    }
    trace.line("seed", static_cast<double>(dRandGetSeed()));
}

void CallScene::askBoxes() {
    for (const GeomSet &set : m_sets)
        for (const dGeomID geom : set.all) {
            dReal box[6];
            dGeomGetAABB(geom, box);
        }
    for (const GeomSet &set : m_sets)
        if (set.space != nullptr) dSpaceClean(set.space);
}

void CallScene::tellState() {
    for (const GeomSet &set : m_sets) {
        if (set.space != nullptr) {
            trace.line("geoms", dSpaceGetNumGeoms(set.space));
            if (dSpaceGetClass(set.space) != dQuadTreeSpaceClass)
                for (int i = 0; i < dSpaceGetNumGeoms(set.space); ++i) {
                    trace.object(dSpaceGetGeom(set.space, i));
                    trace.endLine();
                }
        }
        for (const dGeomID geom : set.all) {
            dReal box[6];
            dGeomGetAABB(geom, box);
            trace.word("geom");
            trace.object(geom);
            trace.object(dGeomGetSpace(geom));
            trace.object(dGeomGetBody(geom));
            trace.number(dGeomIsEnabled(geom));
            trace.number(static_cast<double>(dGeomGetCategoryBits(geom)));
            trace.number(static_cast<double>(dGeomGetCollideBits(geom)));
            trace.numbers(box, 6);
            trace.endLine();
        }
    }
}

void CallScene::destroy() {
    for (GeomSet &set : m_sets) {
        if (set.space != nullptr) continue;
        for (const dGeomID geom : set.all) dGeomDestroy(geom);
    }
    dJointGroupDestroy(contacts);
    if (setAt(Place::root).space != nullptr) dSpaceDestroy(setAt(Place::root).space);
    if (setAt(Place::other).space != nullptr) dSpaceDestroy(setAt(Place::other).space);
    if (world != nullptr) dWorldDestroy(world);
    if (second != nullptr) dWorldDestroy(second);
    trace.line("destroyed");
}

void CallScene::destroyRoot() {
    GeomSet &root = setAt(Place::root), &nested = setAt(Place::nested);
    const dSpaceID space = root.space;
    root.space = nested.space = nullptr;
    for (GeomSet *const set : {&root, &nested})
        while (!set->all.empty()) drop(set->all.back());
    dSpaceDestroy(space);
}

// --- objects for recipes --------------------------------------------------------------------------------

namespace {

template <class Wanted>
dGeomID byTurns(const std::vector<dGeomID> &geoms, int turn, Wanted isWanted) {
    for (std::size_t i = 0; i < geoms.size(); ++i) {
        const dGeomID geom = geoms[(i + turn) % geoms.size()];
        if (isWanted(geom)) return geom;
    }
    return geoms.front();
}

}  // namespace

dGeomID CallScene::any() {
    return byTurns(set().all, turn, [](dGeomID) { return true; });
}

dGeomID CallScene::placeable() {
    return byTurns(set().all, turn, [](dGeomID geom) { return dGeomGetClass(geom) != dPlaneClass; });
}

dGeomID CallScene::carried() {
    return byTurns(set().all, turn, [](dGeomID geom) { return dGeomGetBody(geom) != nullptr; });
}

dGeomID CallScene::takeGeom() {
    const dGeomID geom = any();
    drop(geom);
    return geom;
}

dBodyID CallScene::takeBody() {
    const dBodyID taken = body();
    bodies.erase(std::find(bodies.begin(), bodies.end(), taken));
    fillers.erase(std::remove(fillers.begin(), fillers.end(), taken), fillers.end());
    return taken;
}

dGeomID CallScene::adopt(dGeomID geom) {
    trace.know(m_created = geom);
    GeomSet &where = dGeomGetSpace(geom) == nullptr ? setAt(Place::nowhere) : set();
    where.all.push_back(geom);
    return geom;
}

dBodyID CallScene::adopt(dBodyID body) {
    trace.know(body);
    bodies.push_back(body);
    return body;
}

dJointID CallScene::adopt(dJointID joint) {
    trace.know(joint);
    m_made.push_back(joint);
    return joint;
}

void CallScene::drop(dGeomID geom) {
    for (GeomSet &set : m_sets)
        set.all.erase(std::remove(set.all.begin(), set.all.end(), geom), set.all.end());
    trace.forget(geom);
}

void CallScene::drop(dJointID joint) {
    std::replace(joints.begin(), joints.end(), joint, dJointID(nullptr));
    trace.forget(joint);
}

void CallScene::tell(const void *object) {
    trace.word("value");
    trace.object(object);
    trace.endLine();
}

void CallScene::tell(const dReal *values, int count) {
    trace.word("values");
    trace.numbers(values, count);
    trace.endLine();
}

}  // namespace kept_state
