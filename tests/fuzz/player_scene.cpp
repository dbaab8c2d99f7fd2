// The scene that a drawn script begins with, and frames as programs play them.
#include "player.h"

#include "function.h"
#include "played_as.h"

namespace fuzz {

void Player::makeScene(Draw &draw) {
    const Reference world = makeNow("dWorldCreate", {});
    makeNow("dWorldSetGravity", {argumentOf(world), argumentOf(0), argumentOf(0), argumentOf(-9.75)});
    static const char *const kinds[] = {"dSimpleSpaceCreate", "dHashSpaceCreate", "dSweepAndPruneSpaceCreate", "dQuadTreeSpaceCreate"};
    Arguments arguments;
    const Function *const maker = functionOf(kinds[draw.spaceKind()]);
    draw.arguments(*maker, objects, arguments);
    arguments[0] = argumentOf(Reference{ObjectKind::space, -1});
    const Reference space = makeNow(maker->name.c_str(), arguments);
    if (maker->name == "dHashSpaceCreate" && draw.oneIn(2)) {
        const Function *const setter = functionOf("dHashSpaceSetLevels");
        if (draw.arguments(*setter, objects, arguments)) makeNow(setter->name.c_str(), arguments);
    }
    if (!draw.oneIn(4))
        makeNow("dCreatePlane", {argumentOf(space), argumentOf(0), argumentOf(0), argumentOf(1), argumentOf(0)});
    if (draw.oneIn(4)) makeTerrain(draw, space);
    if (draw.isHeap())
        makeHeap(draw, world, space);
    else
        makeBodies(draw, world, space);
    if (draw.oneIn(3)) setFilters(draw);
    if (draw.oneIn(2)) makeJoints(draw, world);
}

// By default every geom may collide with every other one; a single change of bits is visible only for geoms with other bits.
void Player::setFilters(Draw &draw) {
    for (const Reference &geom : objects.living(ObjectKind::geom)) {
        makeNow("dGeomSetCategoryBits", {argumentOf(geom), argumentOf(draw.below(4))});
        makeNow("dGeomSetCollideBits", {argumentOf(geom), argumentOf(draw.below(4))});
    }
}

void Player::makeTerrain(Draw &draw, const Reference &space) {
    Arguments arguments;
    if (draw.oneIn(2)) {
        const Function *const maker = functionOf("dGeomTriMeshDataBuildSimple");
        draw.arguments(*maker, objects, arguments);
        arguments[0] = argumentOf(1);
        const Reference data = makeNow(maker->name.c_str(), arguments);
        makeNow("dCreateTriMesh", {argumentOf(space), argumentOf(data)});
    } else {
        const Reference data = makeNow("dGeomHeightfieldDataCreate", {});
        const Reference field = makeNow("dCreateHeightfield", {argumentOf(space), argumentOf(data), argumentOf(1)});
        // Upright: its heights are along y.
        Argument turn;
        turn.kind = Argument::Kind::numbers;
        turn.numbers = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};
        makeNow("dGeomSetRotation", {argumentOf(field), turn});
    }
}

void Player::makeBodies(Draw &draw, const Reference &world, const Reference &space) {
    static const char *const shapes[] = {"dCreateSphere",   "dCreateBox",    "dCreateCapsule", "dCreateCylinder",
                                         "dCreateSphere",   "dCreateConvex", "dCreateGeom",    "dCreateBox"};
    Arguments arguments;
    for (unsigned i = 0; i < draw.bodies() && !m_isOver && !draw.isOver(); ++i) {
        const Reference body = makeNow("dBodyCreate", {argumentOf(world)});
        const Function *const shape = functionOf(shapes[draw.below(8)]);
        draw.arguments(*shape, objects, arguments);
        arguments[0] = argumentOf(space);
        const Reference geom = makeNow(shape->name.c_str(), arguments);
        if (geom.number < 0 || body.number < 0) continue;
        makeNow("dGeomSetBody", {argumentOf(geom), argumentOf(body)});
        draw.arguments(*functionOf("dBodySetPosition"), objects, arguments);
        arguments[0] = argumentOf(body);
        makeNow("dBodySetPosition", arguments);
    }
}

// A wall of touching boxes or balls: one island, whose contacts are enough for several workers to step it together. Its bodies
// take no bytes of the script.
void Player::makeHeap(Draw &draw, const Reference &world, const Reference &space) {
    constexpr unsigned kWidth = 8;
    constexpr double kSize = 0.5, kDistance = 0.498;
    const bool areBoxes = !draw.oneIn(4);
    for (unsigned i = 0; i < draw.bodies() && !m_isOver; ++i) {
        const Reference body = makeNow("dBodyCreate", {argumentOf(world)});
        const Reference geom = areBoxes ? makeNow("dCreateBox", {argumentOf(space), argumentOf(kSize), argumentOf(kSize), argumentOf(kSize)})
                                        : makeNow("dCreateSphere", {argumentOf(space), argumentOf(kSize / 2)});
        makeNow("dGeomSetBody", {argumentOf(geom), argumentOf(body)});
        makeNow("dBodySetPosition", {argumentOf(body), argumentOf(i % kWidth * kDistance), argumentOf(0),
                                     argumentOf(kSize / 2 + i / kWidth * kDistance)});
    }
    playFrames(1 + draw.below(4), !playedAs.isFast || draw.oneIn(2));
}

// Makes joints between neighbours, with anchors at drawn positions.
void Player::makeJoints(Draw &draw, const Reference &world) {
    static const char *const types[] = {"Ball", "Hinge", "Slider", "Universal", "Hinge2", "Fixed", "Piston", "PR", "PU", "AMotor", "LMotor",
                                        "DBall", "DHinge", "Transmission", "Plane2D", "Null"};
    Arguments arguments;
    for (unsigned count = draw.below(12); count > 0 && !m_isOver && !draw.isOver(); --count) {
        const std::string type = types[draw.below(16)];
        const Reference joint =
            makeNow(("dJointCreate" + type).c_str(), {argumentOf(world), argumentOf(Reference{ObjectKind::group, -1})});
        if (joint.number < 0) continue;
        draw.arguments(*functionOf("dJointAttach"), objects, arguments);
        arguments[0] = argumentOf(joint);
        if (!functionOf("dJointAttach")->adjust(objects, arguments)) continue;
        makeNow("dJointAttach", arguments);
        for (const char *const what : {"Anchor", "Axis", "Axis1", "Axis2"}) {
            const Function *const setter = functionOf("dJointSet" + type + what);
            if (setter == nullptr || !draw.arguments(*setter, objects, arguments)) continue;
            arguments[0] = argumentOf(joint);
            makeNow(setter->name.c_str(), arguments);
        }
    }
}

// Plays frames as programs do: all spaces collide, all worlds step, the contacts are removed. If there are more than two, the others wait.
void Player::playFrames(unsigned count, bool quick) {
    for (; count > 0 && !m_isOver && m_calls < m_options.maxCalls; --count) {
        int left = 2;
        for (const Reference &space : objects.living(ObjectKind::space)) {
            const auto handle = static_cast<dGeomID>(objects.find(space));
            if (handle != nullptr && dGeomGetSpace(handle) == nullptr && left-- > 0) makeNow("dSpaceCollide", {argumentOf(space)});
        }
        left = 2;
        for (const Reference &world : objects.living(ObjectKind::world))
            if (left-- > 0) makeNow(quick ? "dWorldQuickStep" : "dWorldStep", {argumentOf(world), argumentOf(0.015625)});
        makeNow("emptyContacts", {});
    }
}

}  // namespace fuzz
