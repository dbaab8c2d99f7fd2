// Recipes for the functions of objects.h that are for joints of one type: setters and getters by their
// signatures, each on the scene's joint of that type.
#include "call_recipes.h"

namespace kept_state {

namespace {

void add(CallRecipes &r, const char *name, CallRecipe::Call call, bool readsOnly) {
    r.push_back({name, std::move(call), nullptr, readsOnly});
    r.back().anySpace = true;
}

void add(CallRecipes &r, const char *name, void (*set)(dJointID), dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type]); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, int), dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 1); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, dReal), dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 0.4); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, dReal, dReal), dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 2, 3); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, dReal, dReal, dReal), dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 0.1, 0.3, 0.9); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, dReal, dReal, dReal, dReal),
         dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 0.1, 0.3, 0.9, 0.2); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, dReal, dReal, dReal, dReal, dReal),
         dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 0.1, 0.3, 0.9, 0.2, 0.1); }, false);
}
// Some of these move a body to and fro: from so far that its position comes back as another one.
void add(CallRecipes &r, const char *name, void (*set)(dJointID, dReal, dReal, dReal, dReal, dReal, dReal),
         dJointType type) {
    add(
        r, name,
        [=](CallScene &s) {
            set(s.joints[type], 0.1, 0.3, 0.9, 2e14, 1e14, 3e14);
            set(s.joints[type], 0.1, 0.3, 0.9, 0.02, 0.01, 0.03);
        },
        false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, int, int, dReal, dReal, dReal),
         dJointType type) {
    add(
        r, name, [=](CallScene &s) { set(s.joints[type], 0, 1, 0.1, 0.3, 0.9); }, false);
}
void add(CallRecipes &r, const char *name, void (*set)(dJointID, const dReal *, const dReal *),
         dJointType type) {
    add(
        r, name,
        [=](CallScene &s) {
            const dVector3 axis1{0, 0.1, 1, 0}, axis2{1, 0, 0, 0};
            set(s.joints[type], axis1, axis2);
        },
        false);
}
// A motor, where it is a parameter that is set; an angle of the first axis otherwise.
void add(CallRecipes &r, const char *name, void (*set)(dJointID, int, dReal), dJointType type) {
    const bool isAngle = set == dJointSetAMotorAngle;
    r.push_back({name,
                 [=](CallScene &s) {
                     if (isAngle) return set(s.joints[type], 0, 0.2);
                     set(s.joints[type], dParamVel, 0.5);
                     set(s.joints[type], dParamFMax, 4);
                     set(s.joints[type], dParamLoStop, -0.01);
                 },
                 [=](CallScene &s) { set(s.joints[type], isAngle ? 0 : static_cast<int>(dParamFMax), 0); }});
    r.back().anySpace = true;
}

template <class Value>
void add(CallRecipes &r, const char *name, Value (*get)(dJointID), dJointType type) {
    add(
        r, name, [=](CallScene &s) { s.tell(get(s.joints[type])); }, true);
}
template <class Value>
void add(CallRecipes &r, const char *name, Value (*get)(dJointID, int), dJointType type) {
    const bool isParameter = std::string(name).find("Param") != std::string::npos;
    add(
        r, name,
        [=](CallScene &s) { s.tell(get(s.joints[type], isParameter ? static_cast<int>(dParamFMax) : 0)); },
        true);
}
void add(CallRecipes &r, const char *name, void (*get)(dJointID, dReal *), dJointType type) {
    add(
        r, name,
        [=](CallScene &s) {
            dVector3 result{};
            get(s.joints[type], result);
            s.tell(result, 3);
        },
        true);
}
void add(CallRecipes &r, const char *name, void (*get)(dJointID, int, dReal *), dJointType type) {
    add(
        r, name,
        [=](CallScene &s) {
            dVector3 result{};
            get(s.joints[type], 0, result);
            s.tell(result, 3);
        },
        true);
}
void add(CallRecipes &r, const char *name, void (*get)(dJointID, dReal *, dReal *), dJointType type) {
    add(
        r, name,
        [=](CallScene &s) {
            dReal one = 0, other = 0;
            get(s.joints[type], &one, &other);
            s.tell(one);
            s.tell(other);
        },
        true);
}

void addBallCalls(CallRecipes &r) {
    add(r, "dJointSetBallAnchor", dJointSetBallAnchor, dJointTypeBall);
    add(r, "dJointSetBallAnchor2", dJointSetBallAnchor2, dJointTypeBall);
    add(r, "dJointSetBallParam", dJointSetBallParam, dJointTypeBall);
    add(r, "dJointGetBallAnchor", dJointGetBallAnchor, dJointTypeBall);
    add(r, "dJointGetBallAnchor2", dJointGetBallAnchor2, dJointTypeBall);
    add(r, "dJointGetBallParam", dJointGetBallParam, dJointTypeBall);
}

void addHingeCalls(CallRecipes &r) {
    add(r, "dJointSetHingeAnchor", dJointSetHingeAnchor, dJointTypeHinge);
    add(r, "dJointSetHingeAnchorDelta", dJointSetHingeAnchorDelta, dJointTypeHinge);
    add(r, "dJointSetHingeAxis", dJointSetHingeAxis, dJointTypeHinge);
    add(r, "dJointSetHingeAxisOffset", dJointSetHingeAxisOffset, dJointTypeHinge);
    add(r, "dJointSetHingeParam", dJointSetHingeParam, dJointTypeHinge);
    add(r, "dJointAddHingeTorque", dJointAddHingeTorque, dJointTypeHinge);
    add(r, "dJointGetHingeAnchor", dJointGetHingeAnchor, dJointTypeHinge);
    add(r, "dJointGetHingeAnchor2", dJointGetHingeAnchor2, dJointTypeHinge);
    add(r, "dJointGetHingeAxis", dJointGetHingeAxis, dJointTypeHinge);
    add(r, "dJointGetHingeParam", dJointGetHingeParam, dJointTypeHinge);
    add(r, "dJointGetHingeAngle", dJointGetHingeAngle, dJointTypeHinge);
    add(r, "dJointGetHingeAngleRate", dJointGetHingeAngleRate, dJointTypeHinge);
}

void addSliderCalls(CallRecipes &r) {
    add(r, "dJointSetSliderAxis", dJointSetSliderAxis, dJointTypeSlider);
    add(r, "dJointSetSliderAxisDelta", dJointSetSliderAxisDelta, dJointTypeSlider);
    add(r, "dJointSetSliderParam", dJointSetSliderParam, dJointTypeSlider);
    add(r, "dJointAddSliderForce", dJointAddSliderForce, dJointTypeSlider);
    add(r, "dJointGetSliderPosition", dJointGetSliderPosition, dJointTypeSlider);
    add(r, "dJointGetSliderPositionRate", dJointGetSliderPositionRate, dJointTypeSlider);
    add(r, "dJointGetSliderAxis", dJointGetSliderAxis, dJointTypeSlider);
    add(r, "dJointGetSliderParam", dJointGetSliderParam, dJointTypeSlider);
}

void addHinge2Calls(CallRecipes &r) {
    add(r, "dJointSetHinge2Anchor", dJointSetHinge2Anchor, dJointTypeHinge2);
    add(r, "dJointSetHinge2Axes", dJointSetHinge2Axes, dJointTypeHinge2);
    add(r, "dJointSetHinge2Axis1", dJointSetHinge2Axis1, dJointTypeHinge2);
    add(r, "dJointSetHinge2Axis2", dJointSetHinge2Axis2, dJointTypeHinge2);
    add(r, "dJointSetHinge2Param", dJointSetHinge2Param, dJointTypeHinge2);
    add(r, "dJointAddHinge2Torques", dJointAddHinge2Torques, dJointTypeHinge2);
    add(r, "dJointGetHinge2Anchor", dJointGetHinge2Anchor, dJointTypeHinge2);
    add(r, "dJointGetHinge2Anchor2", dJointGetHinge2Anchor2, dJointTypeHinge2);
    add(r, "dJointGetHinge2Axis1", dJointGetHinge2Axis1, dJointTypeHinge2);
    add(r, "dJointGetHinge2Axis2", dJointGetHinge2Axis2, dJointTypeHinge2);
    add(r, "dJointGetHinge2Param", dJointGetHinge2Param, dJointTypeHinge2);
    add(r, "dJointGetHinge2Angle1", dJointGetHinge2Angle1, dJointTypeHinge2);
    add(r, "dJointGetHinge2Angle2", dJointGetHinge2Angle2, dJointTypeHinge2);
    add(r, "dJointGetHinge2Angle1Rate", dJointGetHinge2Angle1Rate, dJointTypeHinge2);
    add(r, "dJointGetHinge2Angle2Rate", dJointGetHinge2Angle2Rate, dJointTypeHinge2);
}

void addUniversalCalls(CallRecipes &r) {
    add(r, "dJointSetUniversalAnchor", dJointSetUniversalAnchor, dJointTypeUniversal);
    add(r, "dJointSetUniversalAxis1", dJointSetUniversalAxis1, dJointTypeUniversal);
    add(r, "dJointSetUniversalAxis1Offset", dJointSetUniversalAxis1Offset, dJointTypeUniversal);
    add(r, "dJointSetUniversalAxis2", dJointSetUniversalAxis2, dJointTypeUniversal);
    add(r, "dJointSetUniversalAxis2Offset", dJointSetUniversalAxis2Offset, dJointTypeUniversal);
    add(r, "dJointSetUniversalParam", dJointSetUniversalParam, dJointTypeUniversal);
    add(r, "dJointAddUniversalTorques", dJointAddUniversalTorques, dJointTypeUniversal);
    add(r, "dJointGetUniversalAnchor", dJointGetUniversalAnchor, dJointTypeUniversal);
    add(r, "dJointGetUniversalAnchor2", dJointGetUniversalAnchor2, dJointTypeUniversal);
    add(r, "dJointGetUniversalAxis1", dJointGetUniversalAxis1, dJointTypeUniversal);
    add(r, "dJointGetUniversalAxis2", dJointGetUniversalAxis2, dJointTypeUniversal);
    add(r, "dJointGetUniversalParam", dJointGetUniversalParam, dJointTypeUniversal);
    add(r, "dJointGetUniversalAngles", dJointGetUniversalAngles, dJointTypeUniversal);
    add(r, "dJointGetUniversalAngle1", dJointGetUniversalAngle1, dJointTypeUniversal);
    add(r, "dJointGetUniversalAngle2", dJointGetUniversalAngle2, dJointTypeUniversal);
    add(r, "dJointGetUniversalAngle1Rate", dJointGetUniversalAngle1Rate, dJointTypeUniversal);
    add(r, "dJointGetUniversalAngle2Rate", dJointGetUniversalAngle2Rate, dJointTypeUniversal);
}

void addPRCalls(CallRecipes &r) {
    add(r, "dJointSetPRAnchor", dJointSetPRAnchor, dJointTypePR);
    add(r, "dJointSetPRAxis1", dJointSetPRAxis1, dJointTypePR);
    add(r, "dJointSetPRAxis2", dJointSetPRAxis2, dJointTypePR);
    add(r, "dJointSetPRParam", dJointSetPRParam, dJointTypePR);
    add(r, "dJointAddPRTorque", dJointAddPRTorque, dJointTypePR);
    add(r, "dJointGetPRAnchor", dJointGetPRAnchor, dJointTypePR);
    add(r, "dJointGetPRPosition", dJointGetPRPosition, dJointTypePR);
    add(r, "dJointGetPRPositionRate", dJointGetPRPositionRate, dJointTypePR);
    add(r, "dJointGetPRAngle", dJointGetPRAngle, dJointTypePR);
    add(r, "dJointGetPRAngleRate", dJointGetPRAngleRate, dJointTypePR);
    add(r, "dJointGetPRAxis1", dJointGetPRAxis1, dJointTypePR);
    add(r, "dJointGetPRAxis2", dJointGetPRAxis2, dJointTypePR);
    add(r, "dJointGetPRParam", dJointGetPRParam, dJointTypePR);
}

void addPUCalls(CallRecipes &r) {
    add(r, "dJointSetPUAnchor", dJointSetPUAnchor, dJointTypePU);
    add(r, "dJointSetPUAnchorDelta", dJointSetPUAnchorDelta, dJointTypePU);
    add(r, "dJointSetPUAnchorOffset", dJointSetPUAnchorOffset, dJointTypePU);
    add(r, "dJointSetPUAxis1", dJointSetPUAxis1, dJointTypePU);
    add(r, "dJointSetPUAxis2", dJointSetPUAxis2, dJointTypePU);
    add(r, "dJointSetPUAxis3", dJointSetPUAxis3, dJointTypePU);
    add(r, "dJointSetPUAxisP", dJointSetPUAxisP, dJointTypePU);
    add(r, "dJointSetPUParam", dJointSetPUParam, dJointTypePU);
    add(r, "dJointGetPUAnchor", dJointGetPUAnchor, dJointTypePU);
    add(r, "dJointGetPUPosition", dJointGetPUPosition, dJointTypePU);
    add(r, "dJointGetPUPositionRate", dJointGetPUPositionRate, dJointTypePU);
    add(r, "dJointGetPUAxis1", dJointGetPUAxis1, dJointTypePU);
    add(r, "dJointGetPUAxis2", dJointGetPUAxis2, dJointTypePU);
    add(r, "dJointGetPUAxis3", dJointGetPUAxis3, dJointTypePU);
    add(r, "dJointGetPUAxisP", dJointGetPUAxisP, dJointTypePU);
    add(r, "dJointGetPUAngles", dJointGetPUAngles, dJointTypePU);
    add(r, "dJointGetPUAngle1", dJointGetPUAngle1, dJointTypePU);
    add(r, "dJointGetPUAngle1Rate", dJointGetPUAngle1Rate, dJointTypePU);
    add(r, "dJointGetPUAngle2", dJointGetPUAngle2, dJointTypePU);
    add(r, "dJointGetPUAngle2Rate", dJointGetPUAngle2Rate, dJointTypePU);
    add(r, "dJointGetPUParam", dJointGetPUParam, dJointTypePU);
}

void addPistonCalls(CallRecipes &r) {
    add(r, "dJointSetPistonAnchor", dJointSetPistonAnchor, dJointTypePiston);
    add(r, "dJointSetPistonAnchorOffset", dJointSetPistonAnchorOffset, dJointTypePiston);
    add(r, "dJointSetPistonAxis", dJointSetPistonAxis, dJointTypePiston);
    add(r, "dJointSetPistonAxisDelta", dJointSetPistonAxisDelta, dJointTypePiston);
    add(r, "dJointSetPistonParam", dJointSetPistonParam, dJointTypePiston);
    add(r, "dJointAddPistonForce", dJointAddPistonForce, dJointTypePiston);
    add(r, "dJointGetPistonPosition", dJointGetPistonPosition, dJointTypePiston);
    add(r, "dJointGetPistonPositionRate", dJointGetPistonPositionRate, dJointTypePiston);
    add(r, "dJointGetPistonAngle", dJointGetPistonAngle, dJointTypePiston);
    add(r, "dJointGetPistonAngleRate", dJointGetPistonAngleRate, dJointTypePiston);
    add(r, "dJointGetPistonAnchor", dJointGetPistonAnchor, dJointTypePiston);
    add(r, "dJointGetPistonAnchor2", dJointGetPistonAnchor2, dJointTypePiston);
    add(r, "dJointGetPistonAxis", dJointGetPistonAxis, dJointTypePiston);
    add(r, "dJointGetPistonParam", dJointGetPistonParam, dJointTypePiston);
}

void addFixedCalls(CallRecipes &r) {
    add(r, "dJointSetFixed", dJointSetFixed, dJointTypeFixed);
    add(r, "dJointSetFixedParam", dJointSetFixedParam, dJointTypeFixed);
    add(r, "dJointGetFixedParam", dJointGetFixedParam, dJointTypeFixed);
}

void addAMotorCalls(CallRecipes &r) {
    add(r, "dJointSetAMotorNumAxes", dJointSetAMotorNumAxes, dJointTypeAMotor);
    add(r, "dJointSetAMotorAxis", dJointSetAMotorAxis, dJointTypeAMotor);
    add(r, "dJointSetAMotorAngle", dJointSetAMotorAngle, dJointTypeAMotor);
    add(r, "dJointSetAMotorParam", dJointSetAMotorParam, dJointTypeAMotor);
    add(r, "dJointSetAMotorMode", dJointSetAMotorMode, dJointTypeAMotor);
    add(r, "dJointAddAMotorTorques", dJointAddAMotorTorques, dJointTypeAMotor);
    add(r, "dJointGetAMotorNumAxes", dJointGetAMotorNumAxes, dJointTypeAMotor);
    add(r, "dJointGetAMotorAxis", dJointGetAMotorAxis, dJointTypeAMotor);
    add(r, "dJointGetAMotorAxisRel", dJointGetAMotorAxisRel, dJointTypeAMotor);
    add(r, "dJointGetAMotorAngle", dJointGetAMotorAngle, dJointTypeAMotor);
    add(r, "dJointGetAMotorAngleRate", dJointGetAMotorAngleRate, dJointTypeAMotor);
    add(r, "dJointGetAMotorParam", dJointGetAMotorParam, dJointTypeAMotor);
    add(r, "dJointGetAMotorMode", dJointGetAMotorMode, dJointTypeAMotor);
}

void addLMotorCalls(CallRecipes &r) {
    add(r, "dJointSetLMotorNumAxes", dJointSetLMotorNumAxes, dJointTypeLMotor);
    add(r, "dJointSetLMotorAxis", dJointSetLMotorAxis, dJointTypeLMotor);
    add(r, "dJointSetLMotorParam", dJointSetLMotorParam, dJointTypeLMotor);
    add(r, "dJointGetLMotorNumAxes", dJointGetLMotorNumAxes, dJointTypeLMotor);
    add(r, "dJointGetLMotorAxis", dJointGetLMotorAxis, dJointTypeLMotor);
    add(r, "dJointGetLMotorParam", dJointGetLMotorParam, dJointTypeLMotor);
}

void addPlane2DCalls(CallRecipes &r) {
    add(r, "dJointSetPlane2DXParam", dJointSetPlane2DXParam, dJointTypePlane2D);
    add(r, "dJointSetPlane2DYParam", dJointSetPlane2DYParam, dJointTypePlane2D);
    add(r, "dJointSetPlane2DAngleParam", dJointSetPlane2DAngleParam, dJointTypePlane2D);
}

void addTransmissionCalls(CallRecipes &r) {
    add(r, "dJointGetTransmissionContactPoint1", dJointGetTransmissionContactPoint1, dJointTypeTransmission);
    add(r, "dJointGetTransmissionContactPoint2", dJointGetTransmissionContactPoint2, dJointTypeTransmission);
    add(r, "dJointSetTransmissionAxis1", dJointSetTransmissionAxis1, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAxis1", dJointGetTransmissionAxis1, dJointTypeTransmission);
    add(r, "dJointSetTransmissionAxis2", dJointSetTransmissionAxis2, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAxis2", dJointGetTransmissionAxis2, dJointTypeTransmission);
    add(r, "dJointSetTransmissionAnchor1", dJointSetTransmissionAnchor1, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAnchor1", dJointGetTransmissionAnchor1, dJointTypeTransmission);
    add(r, "dJointSetTransmissionAnchor2", dJointSetTransmissionAnchor2, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAnchor2", dJointGetTransmissionAnchor2, dJointTypeTransmission);
    add(r, "dJointSetTransmissionParam", dJointSetTransmissionParam, dJointTypeTransmission);
    add(r, "dJointGetTransmissionParam", dJointGetTransmissionParam, dJointTypeTransmission);
    add(r, "dJointSetTransmissionMode", dJointSetTransmissionMode, dJointTypeTransmission);
    add(r, "dJointGetTransmissionMode", dJointGetTransmissionMode, dJointTypeTransmission);
    add(r, "dJointSetTransmissionRatio", dJointSetTransmissionRatio, dJointTypeTransmission);
    add(r, "dJointGetTransmissionRatio", dJointGetTransmissionRatio, dJointTypeTransmission);
    add(r, "dJointSetTransmissionAxis", dJointSetTransmissionAxis, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAxis", dJointGetTransmissionAxis, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAngle1", dJointGetTransmissionAngle1, dJointTypeTransmission);
    add(r, "dJointGetTransmissionAngle2", dJointGetTransmissionAngle2, dJointTypeTransmission);
    add(r, "dJointGetTransmissionRadius1", dJointGetTransmissionRadius1, dJointTypeTransmission);
    add(r, "dJointGetTransmissionRadius2", dJointGetTransmissionRadius2, dJointTypeTransmission);
    add(r, "dJointSetTransmissionRadius1", dJointSetTransmissionRadius1, dJointTypeTransmission);
    add(r, "dJointSetTransmissionRadius2", dJointSetTransmissionRadius2, dJointTypeTransmission);
    add(r, "dJointGetTransmissionBacklash", dJointGetTransmissionBacklash, dJointTypeTransmission);
    add(r, "dJointSetTransmissionBacklash", dJointSetTransmissionBacklash, dJointTypeTransmission);
}

void addDBallCalls(CallRecipes &r) {
    add(r, "dJointSetDBallAnchor1", dJointSetDBallAnchor1, dJointTypeDBall);
    add(r, "dJointSetDBallAnchor2", dJointSetDBallAnchor2, dJointTypeDBall);
    add(r, "dJointGetDBallAnchor1", dJointGetDBallAnchor1, dJointTypeDBall);
    add(r, "dJointGetDBallAnchor2", dJointGetDBallAnchor2, dJointTypeDBall);
    add(r, "dJointGetDBallDistance", dJointGetDBallDistance, dJointTypeDBall);
    add(r, "dJointSetDBallDistance", dJointSetDBallDistance, dJointTypeDBall);
    add(r, "dJointSetDBallParam", dJointSetDBallParam, dJointTypeDBall);
    add(r, "dJointGetDBallParam", dJointGetDBallParam, dJointTypeDBall);
}

void addDHingeCalls(CallRecipes &r) {
    add(r, "dJointSetDHingeAxis", dJointSetDHingeAxis, dJointTypeDHinge);
    add(r, "dJointGetDHingeAxis", dJointGetDHingeAxis, dJointTypeDHinge);
    add(r, "dJointSetDHingeAnchor1", dJointSetDHingeAnchor1, dJointTypeDHinge);
    add(r, "dJointSetDHingeAnchor2", dJointSetDHingeAnchor2, dJointTypeDHinge);
    add(r, "dJointGetDHingeAnchor1", dJointGetDHingeAnchor1, dJointTypeDHinge);
    add(r, "dJointGetDHingeAnchor2", dJointGetDHingeAnchor2, dJointTypeDHinge);
    add(r, "dJointGetDHingeDistance", dJointGetDHingeDistance, dJointTypeDHinge);
    add(r, "dJointSetDHingeParam", dJointSetDHingeParam, dJointTypeDHinge);
    add(r, "dJointGetDHingeParam", dJointGetDHingeParam, dJointTypeDHinge);
}

}  // namespace

void addJointTypeCalls(CallRecipes &recipes) {
    addBallCalls(recipes);
    addHingeCalls(recipes);
    addSliderCalls(recipes);
    addHinge2Calls(recipes);
    addUniversalCalls(recipes);
    addPRCalls(recipes);
    addPUCalls(recipes);
    addPistonCalls(recipes);
    addFixedCalls(recipes);
    addAMotorCalls(recipes);
    addLMotorCalls(recipes);
    addPlane2DCalls(recipes);
    addTransmissionCalls(recipes);
    addDBallCalls(recipes);
    addDHingeCalls(recipes);
}

}  // namespace kept_state
