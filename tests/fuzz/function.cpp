#include "function.h"

#include "typed.h"

#include <map>
#include <regex>

namespace fuzz {

namespace {

bool matches(const std::string &name, const char *pattern) { return std::regex_search(name, std::regex(pattern)); }

std::vector<Function> makeFunctions() {
    std::vector<Function> all;
    addBodyFunctions(all);
    addGeomFunctions(all);
    addJointFunctions(all);
    addSpaceFunctions(all);
    addWorldFunctions(all);
    for (Function &function : all) {
        function.leavesHalves = function.isMaker || matches(function.name, "Destroy$|^dSpace(Add|Remove)$|^dGeom(Transform)?Set(Body|Geom)$");
        if (matches(function.name, "Get|^dAre|^dConnecting|Query|PointDepth|ToWorld|FromWorld")) function.weight = 1;
        if (matches(function.name, "^dBodySet(Position|LinearVel)$|^dGeomSetPosition$|^dGeomSetBody$|^dJointAttach$|^dSpaceAdd$"))
            function.weight = 12;
        if (matches(function.name, "^dGeomSet(Category|Collide)Bits$|^dGeom(En|Dis)able$|^dBody(En|Dis)able$")) function.weight = 10;
        if (matches(function.name, "^dSpaceSet(Sublevel|ManualCleanup|Cleanup)$")) function.weight = 1;
        for (Parameter &parameter : function.parameters) {
            if (parameter.kind != Parameter::Kind::object) continue;
            const bool mayBeNull = function.name == "dGeomSetBody" ? parameter.object == ObjectKind::body
                                   : function.name == "dJointAttach" && parameter.object == ObjectKind::body;
            if (mayBeNull) parameter.kind = Parameter::Kind::nullableObject;
        }
    }
    return all;
}

}  // namespace

const std::vector<Function> &functions() {
    static const std::vector<Function> all = makeFunctions();
    return all;
}

const Function *functionOf(const std::string &name) {
    static const std::map<std::string, const Function *> byName = [] {
        std::map<std::string, const Function *> map;
        for (const Function &function : functions()) map[function.name] = &function;
        return map;
    }();
    const auto found = byName.find(name);
    return found == byName.end() ? nullptr : found->second;
}

Meaning meaningOf(const std::string &function) {
    if (matches(function, "^dCreate(?!Plane)|Set(Radius|Lengths|Length|Params)$|Threshold|MaxAngularSpeed|AutoDisableTime|Distance$|Ratio$"))
        return Meaning::size;
    if (matches(function, "Anchor|AtPos|AtRelPos|Pos|PointDepth|RaySet$")) return Meaning::place;
    if (matches(function, "Vel|Force|Torque|Gravity")) return Meaning::speed;
    if (matches(function, "ERP|CFM|Damping|QuickStepW|SurfaceLayer|Backlash")) return Meaning::fraction;
    if (matches(function, "Angle")) return Meaning::angle;
    if (matches(function, "Axis|Axes|Plane|Vector")) return Meaning::coordinate;
    return Meaning::any;
}

// -1: any. -2: any that has a pose.
int typeOf(const std::string &function, ObjectKind kind) {
    if (kind == ObjectKind::geom) {
        static const std::pair<const char *, int> classes[] = {
            {"^dGeomSphere", dSphereClass},       {"^dGeomBox", dBoxClass},           {"^dGeomPlane", dPlaneClass},
            {"^dGeomCapsule", dCapsuleClass},     {"^dGeomCylinder", dCylinderClass}, {"^dGeomRay", dRayClass},
            {"^dGeomTransform", dGeomTransformClass}, {"^dGeomTriMesh", dTriMeshClass}, {"^dGeomHeightfield", dHeightfieldClass}};
        for (const auto &[pattern, number] : classes)
            if (matches(function, pattern)) return number;
        return matches(function, "^dGeom(Set|Get|Copy)(Position|Rotation|Quaternion|Offset|Body)|^dGeom(Clear|Copy|Is)?Offset|RelPoint|World")
                   ? -2
                   : -1;
    }
    if (kind != ObjectKind::joint) return -1;
    static const std::pair<const char *, int> types[] = {
        {"AMotor", dJointTypeAMotor}, {"DBall", dJointTypeDBall},   {"DHinge", dJointTypeDHinge},   {"Ball", dJointTypeBall},
        {"Fixed", dJointTypeFixed},   {"Hinge2", dJointTypeHinge2}, {"Hinge", dJointTypeHinge},     {"LMotor", dJointTypeLMotor},
        {"Piston", dJointTypePiston}, {"Plane2D", dJointTypePlane2D}, {"PR", dJointTypePR},         {"PU", dJointTypePU},
        {"Slider", dJointTypeSlider}, {"Transmission", dJointTypeTransmission}, {"Universal", dJointTypeUniversal}};
    for (const auto &[name, number] : types)
        if (matches(function, (std::string("^dJoint(Set|Get|Add)") + name).c_str())) return number;
    return -1;
}

int lengthOf(const std::string &function) {
    if (matches(function, "Rotation$")) return 12;
    return matches(function, "Quaternion$") ? 4 : 3;
}

bool isAllowed(const std::string &function, Where where) {
    if (where == Where::near)
        return !matches(function,
                        "^dBodySet(Position|Rotation|Quaternion)$|^dGeomSet(Position|Rotation|Quaternion|Offset|Body|Convex)|"
                        "^dGeomClearOffset|^dGeom\\w+Set(Radius|Lengths|Params|Length)$|^dGeomRaySet|^dGeomTransformSet|"
                        "^dGeomTriMesh(Set|Data)|^dGeomHeightfield(Set|Data)|"
                        "^dCreate|SpaceCreate$|^dSpace(Add|Remove|Clean|Destroy|Collide)|Destroy|Step$|emptyContacts|^look|"
                        "^dJointGroup|^dWorldCreate|^dWorldUse|^dWorldCleanup|GetAABB");
    return matches(function,
                   "^dBodyGet|^dBodyAdd|^dBodySet(LinearVel|AngularVel|Force|Torque)$|^dBody(En|Dis)able$|^dWorldGet|"
                   "^dGeom(En|Dis)able$|^dGeomSet(Category|Collide)Bits$|^dGeomGet(Position|Rotation|Body|Class|Category|Collide|Space)");
}

}  // namespace fuzz
