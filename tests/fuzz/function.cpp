#include "function.h"

#include "typed.h"

#include <map>
#include <regex>

namespace fuzz {

namespace {

bool matches(const std::string &name, const char *pattern) { return std::regex_search(name, std::regex(pattern)); }

int weightBetween(const Function &function) {
    const std::string &name = function.name;
    if (function.weights[0] != 0) return function.weights[0];  // written by hand
    if (matches(name, "Get|^dAre|^dConnecting|Query|PointDepth|ToWorld|FromWorld|^dSpaceSet(Sublevel|ManualCleanup|Cleanup)$")) return 1;
    if (matches(name, "^dBodySet(Position|LinearVel)$|^dGeomSet(Position|Body)$|^dJointAttach$|^dSpaceAdd$")) return 12;
    if (matches(name, "^dGeomSet(Category|Collide)Bits$|^dGeom(En|Dis)able$|^dBody(En|Dis)able$")) return 10;
    return 4;
}

// Upstream refuses these while a space is locked.
constexpr const char *kRefused =
    "^dBodySet(Position|Rotation|Quaternion)$|^dGeomSet(Position|Rotation|Quaternion|Offset|Body|Convex|Category|Collide)|"
    "^dGeomClearOffset|^dGeom\\w+Set(Radius|Lengths|Params|Length)$|^dGeomRaySet|^dJointSet(Piston|PU)Anchor(Delta|Offset)$";
// In a callback it would do half of its work, or use destroyed objects.
constexpr const char *kHarmful =
    "^dCreate|SpaceCreate$|^dSpace(Add|Remove|Clean|Destroy|Collide|SetManualCleanup)|Destroy|Step$|WorldStep|emptyContacts|^look|^dGeomTransformSet|"
    "^dGeomTriMesh(Set|Data|EnableTC|Clear)|^dGeomHeightfieldSet|^dJointGroup|^dWorld(Create|Use|Cleanup|Export|SetStep)|GetAABB|"
    "^dODE_MT_SetCallbackPolicy$|^dGeomMoved$|^dSetColliderOverride$";
// Amid a step, or in a handler.
constexpr const char *kMild =
    "^dBodyGet|^dBodyAdd|^dBodySet(LinearVel|AngularVel|Force|Torque)$|^dBody(En|Dis)able$|^dWorldGet|^dToggleODE_MT$|"
    "^dODE_MT_(Set(Algorithm|Heuristics|GridCells|ThreadManager)|Get\\w+)$|^dRand|^dMakeRandom|^dMessage$|"
    "^dGeom(En|Dis)able$|^dGeomSet(Category|Collide)Bits$|^dGeomGet(Position|Rotation|Body|Class|Category|Collide|Space)";

int weightIn(Where where, const Function &function) {
    switch (where) {
        case Where::between:
            return weightBetween(function);
        case Where::moved:
        case Where::message:
        case Where::triangle:
        case Where::height:
            return matches(function.name, kMild) ? weightBetween(function) : 0;
        default:
            if (matches(function.name, kHarmful)) return 0;
            return matches(function.name, kRefused) ? 1 : weightBetween(function);
    }
}

std::vector<Function> makeFunctions() {
    std::vector<Function> all;
    addBodyFunctions(all);
    addGeomFunctions(all);
    addJointFunctions(all);
    addSpaceFunctions(all);
    addWorldFunctions(all);
    addNewFunctions(all);
    addProgramFunctions(all);
    addSettingFunctions(all);
    addAdjustments(all);
    for (Function &function : all) {
        std::array<int, places> weights{};
        for (int place = 0; place < places; ++place)
            weights[static_cast<std::size_t>(place)] = weightIn(static_cast<Where>(place), function);
        function.weights = weights;
        function.leavesHalves = function.isMaker || matches(function.name, "Destroy$|^dSpace(Add|Remove)$|^dGeom(Transform)?Set(Body|Geom)$");
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

bool isParameterNumber(const std::string &function) { return matches(function, "^dJoint[GS]et\\w+Param$"); }

bool isLevel(const std::string &function) { return matches(function, "^dHashSpaceSetLevels$"); }

int typeOf(const std::string &function, ObjectKind kind) {
    if (kind == ObjectKind::geom) {
        static const std::pair<const char *, int> classes[] = {
            {"^dGeomSphere", dSphereClass},       {"^dGeomBox", dBoxClass},           {"^dGeomPlane", dPlaneClass},
            {"^dGeomCapsule", dCapsuleClass},     {"^dGeomCylinder", dCylinderClass}, {"^dGeomRay", dRayClass},
            {"^dGeomTransform", dGeomTransformClass}, {"^dGeomTriMesh", dTriMeshClass}, {"^dGeomHeightfield", dHeightfieldClass}};
        for (const auto &[pattern, number] : classes)
            if (matches(function, pattern)) return number;
        if (matches(function, "^dGeom(Set|Clear)Offset")) return kOnBody;
        return matches(function, "^dGeom(Set|Get|Copy)(Position|Rotation|Quaternion|Offset|Body)|^dGeom(Copy|Is)?Offset|RelPoint|World")
                   ? kWithPose
                   : kAnyType;
    }
    if (kind == ObjectKind::space) return matches(function, "^dHashSpace[SG]et") ? dHashSpaceClass : kAnyType;
    if (kind != ObjectKind::joint) return kAnyType;
    static const std::pair<const char *, int> types[] = {
        {"AMotor", dJointTypeAMotor}, {"DBall", dJointTypeDBall},   {"DHinge", dJointTypeDHinge},   {"Ball", dJointTypeBall},
        {"Fixed", dJointTypeFixed},   {"Hinge2", dJointTypeHinge2}, {"Hinge", dJointTypeHinge},     {"LMotor", dJointTypeLMotor},
        {"Piston", dJointTypePiston}, {"Plane2D", dJointTypePlane2D}, {"PR", dJointTypePR},         {"PU", dJointTypePU},
        {"Slider", dJointTypeSlider}, {"Transmission", dJointTypeTransmission}, {"Universal", dJointTypeUniversal}};
    for (const auto &[name, number] : types)
        if (matches(function, (std::string("^dJoint(Set|Get|Add)") + name).c_str())) return number;
    return kAnyType;
}

int lengthOf(const std::string &function) {
    if (matches(function, "Rotation$")) return 12;
    return matches(function, "Quaternion$") ? 4 : 3;
}

}  // namespace fuzz
