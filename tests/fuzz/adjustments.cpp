// What upstream's assertions ask of arguments. Drawn ones are mostly adjusted to that, so that scripts get long; functions whose
// assertions do not depend on other objects need no more than a range.
#include "function.h"

#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <regex>

namespace fuzz {

namespace {

using Adjust = bool (*)(const Objects &, Arguments &);

dGeomID geomOf(const Objects &objects, const Argument &argument) { return static_cast<dGeomID>(objects.find(argument.reference)); }

// The first geom or space from the one drawn on that fits.
template <class Fits>
bool replaceGeom(const Objects &objects, Argument &argument, Fits fits) {
    if (const dGeomID geom = geomOf(objects, argument); geom != nullptr && fits(geom)) return true;
    for (const ObjectKind kind : {ObjectKind::geom, ObjectKind::space}) {
        const std::vector<Reference> living = objects.living(kind);
        for (std::size_t i = 0; i < living.size(); ++i) {
            const Reference &reference = living[(i + static_cast<std::size_t>(std::max(0, argument.reference.number))) % living.size()];
            if (!fits(static_cast<dGeomID>(objects.find(reference)))) continue;
            argument.reference = reference;
            return true;
        }
    }
    return false;
}

bool addWhatIsNowhere(const Objects &objects, Arguments &arguments) {
    const auto space = static_cast<dGeomID>(objects.find(arguments[0].reference));
    return replaceGeom(objects, arguments[1], [space](dGeomID geom) { return dGeomGetSpace(geom) == nullptr && geom != space; });
}

bool removeFromItsSpace(const Objects &objects, Arguments &arguments) {
    if (!replaceGeom(objects, arguments[1], [](dGeomID geom) { return dGeomGetSpace(geom) != nullptr; })) return false;
    const dSpaceID space = dGeomGetSpace(geomOf(objects, arguments[1]));
    arguments[0].reference = {ObjectKind::space, objects.numberOf(ObjectKind::space, space)};
    return arguments[0].reference.number >= 0;
}

bool orderNumbers(const Objects &, Arguments &arguments) {
    if (arguments[1].numbers[0] > arguments[2].numbers[0]) std::swap(arguments[1].numbers, arguments[2].numbers);
    return true;
}

bool useSizes(const Objects &, Arguments &arguments) {
    for (Argument &argument : arguments)
        for (double &number : argument.numbers) number = std::isnan(number) ? 0.5 : std::fabs(number);
    return true;
}

bool useTime(const Objects &, Arguments &arguments) {
    double &time = arguments.back().numbers[0];
    time = !std::isnan(time) && time != 0 ? std::fabs(time) : 0.0078125;
    return true;
}

// Two bodies of the joint's world, which are not the same; Hinge2 and transmissions need both.
bool attachTwo(const Objects &objects, Arguments &arguments) {
    const auto joint = static_cast<dJointID>(objects.find(arguments[0].reference));
    const dWorldID world = objects.worldOf(joint);
    const bool needsBoth = dJointGetType(joint) == dJointTypeHinge2 || dJointGetType(joint) == dJointTypeTransmission;
    const std::vector<Reference> living = objects.living(ObjectKind::body);
    for (int which : {1, 2}) {
        Reference &body = arguments[static_cast<std::size_t>(which)].reference;
        const auto fits = [&](const Reference &reference) {
            return dBodyGetWorld(static_cast<dBodyID>(objects.find(reference))) == world &&
                   (which == 1 || !(reference == arguments[1].reference));
        };
        if (body.number < 0 ? !needsBoth : fits(body)) continue;
        const auto from = static_cast<std::size_t>(std::max(0, body.number));
        std::size_t i = 0;
        while (i < living.size() && !fits(living[(i + from) % living.size()])) ++i;
        if (i == living.size() && needsBoth) return false;
        body = i == living.size() ? Reference{ObjectKind::body, -1} : living[(i + from) % living.size()];
    }
    return true;
}

void limit(Argument &argument, int count) {
    const int number = static_cast<int>(argument.numbers.at(0));
    argument.numbers[0] = (number % count + count) % count;
}

// Motors have three axes, each of which is relative to one of three frames.
bool useAxis(const Objects &, Arguments &arguments) {
    limit(arguments[1], 3);
    if (arguments.size() > 3) limit(arguments[2], 3);
    return true;
}

bool useThree(const Objects &, Arguments &arguments) {
    limit(arguments[1], 3);
    return true;
}

bool useIterations(const Objects &, Arguments &arguments) {
    limit(arguments[1], 40);
    ++arguments[1].numbers[0];
    return true;
}

bool useMember(const Objects &objects, Arguments &arguments) {
    const int count = dSpaceGetNumGeoms(static_cast<dSpaceID>(objects.find(arguments[0].reference)));
    if (count == 0) return false;
    limit(arguments[1], count);
    return true;
}

bool isNotInUse(const Objects &objects, Arguments &arguments) { return !objects.isInUse(objects.find(arguments[0].reference)); }

constexpr struct {
    const char *functions;
    Adjust adjust;
} kAdjustments[] = {
    {"^dSpaceAdd$", addWhatIsNowhere},
    {"^dSpaceRemove$", removeFromItsSpace},
    {"^dHashSpaceSetLevels$", orderNumbers},
    {"^dCreate(Box|Capsule|Cylinder|Sphere|Ray|Geom)$|^dGeom\\w+Set(Radius|Lengths|Length)$|^dGeom(Capsule|Cylinder)SetParams$", useSizes},
    {"^dWorld(Quick)?Step$", useTime},
    {"^dJointAttach$", attachTwo},
    {"^dJointSet[AL]MotorNumAxes$|^dJointSetTransmissionMode$", useThree},
    {"^dJoint([GS]et[AL]Motor(Axis|Angle)|Get[AL]Motor(AngleRate|AxisRel))$", useAxis},
    {"^dWorldSetQuickStepNumIterations$", useIterations},
    {"^dSpaceGetGeom$", useMember},
    {"^dGeom(TriMesh|Heightfield)DataDestroy$", isNotInUse},
};

}  // namespace

void addAdjustments(std::vector<Function> &all) {
    for (const auto &[pattern, adjust] : kAdjustments) {
        const std::regex names(pattern);
        for (Function &function : all)
            if (std::regex_search(function.name, names)) function.adjust = adjust;
    }
}

}  // namespace fuzz
