#include "field_readers.h"

#include <map>

namespace exactness {

namespace {

template <dReal (*get)(dJointID)>
constexpr auto scalar = readReal<dJointID, get>;
template <int (*get)(dJointID)>
constexpr auto number = readInteger<dJointID, get>;
template <void (*get)(dJointID, dReal *)>
constexpr auto vector = copyReals<dJointID, get>;

// All parameters of `axes` groups; a parameter that a joint does not have reads as 0.
template <dReal (*get)(dJointID, int), int axes>
void parameters(dJointID joint, const Names &, Reading &reading) {
    for (int axis = 0; axis < axes; ++axis) {
        for (int parameter = 0; parameter < dParamsInGroup; ++parameter) {
            reading.real(get(joint, axis * dParamGroup + parameter));
        }
    }
}

// A getter of a motor's axes 0, 1, 2, as far as the motor has them.
template <int (*count)(dJointID), void (*get)(dJointID, int, dReal *)>
void motorAxes(dJointID joint, const Names &, Reading &reading) {
    reading.integer(count(joint));
    for (int axis = 0; axis < count(joint); ++axis) {
        dVector3 value = {};
        get(joint, axis, value);
        reading.reals(value, 3);
    }
}

void motorAngles(dJointID joint, const Names &, Reading &reading) {
    for (int axis = 0; axis < dJointGetAMotorNumAxes(joint); ++axis) {
        reading.real(dJointGetAMotorAngle(joint, axis));
        if (dJointGetBody(joint, 0) != nullptr) reading.real(dJointGetAMotorAngleRate(joint, axis));
    }
}

void readBodies(dJointID joint, const Names &names, Reading &reading) {
    reading.integer(names.of(dJointGetBody(joint, 0)));
    reading.integer(names.of(dJointGetBody(joint, 1)));
}

void readFeedback(dJointID joint, const Names &, Reading &reading) {
    const dJointFeedback *feedback = dJointGetFeedback(joint);
    if (feedback == nullptr) return;
    for (const dReal *part : {feedback->f1, feedback->t1, feedback->f2, feedback->t2}) reading.reals(part, 3);
}

using Fields = std::vector<Field<dJointID>>;

const Fields ball{{"ball anchor", vector<dJointGetBallAnchor>},
                  {"ball anchor 2", vector<dJointGetBallAnchor2>},
                  {"ball parameters", parameters<dJointGetBallParam, 1>}};

const Fields hinge{{"hinge anchor", vector<dJointGetHingeAnchor>},
                   {"hinge anchor 2", vector<dJointGetHingeAnchor2>},
                   {"hinge axis", vector<dJointGetHingeAxis>},
                   {"hinge angle", scalar<dJointGetHingeAngle>},
                   {"hinge angle rate", scalar<dJointGetHingeAngleRate>},
                   {"hinge parameters", parameters<dJointGetHingeParam, 1>}};

const Fields slider{{"slider axis", vector<dJointGetSliderAxis>},
                    {"slider position", scalar<dJointGetSliderPosition>},
                    {"slider position rate", scalar<dJointGetSliderPositionRate>},
                    {"slider parameters", parameters<dJointGetSliderParam, 1>}};

const Fields hinge2{{"hinge2 anchor", vector<dJointGetHinge2Anchor>},
                    {"hinge2 anchor 2", vector<dJointGetHinge2Anchor2>},
                    {"hinge2 axis 1", vector<dJointGetHinge2Axis1>},
                    {"hinge2 axis 2", vector<dJointGetHinge2Axis2>},
                    {"hinge2 angle 1", scalar<dJointGetHinge2Angle1>},
                    {"hinge2 angle 2", scalar<dJointGetHinge2Angle2>},
                    {"hinge2 angle rate 1", scalar<dJointGetHinge2Angle1Rate>},
                    {"hinge2 angle rate 2", scalar<dJointGetHinge2Angle2Rate>},
                    {"hinge2 parameters", parameters<dJointGetHinge2Param, 2>}};

const Fields universal{{"universal anchor", vector<dJointGetUniversalAnchor>},
                       {"universal anchor 2", vector<dJointGetUniversalAnchor2>},
                       {"universal axis 1", vector<dJointGetUniversalAxis1>},
                       {"universal axis 2", vector<dJointGetUniversalAxis2>},
                       {"universal angle 1", scalar<dJointGetUniversalAngle1>},
                       {"universal angle 2", scalar<dJointGetUniversalAngle2>},
                       {"universal angle rate 1", scalar<dJointGetUniversalAngle1Rate>},
                       {"universal angle rate 2", scalar<dJointGetUniversalAngle2Rate>},
                       {"universal parameters", parameters<dJointGetUniversalParam, 2>}};

const Fields pr{{"PR anchor", vector<dJointGetPRAnchor>},
                {"PR axis 1", vector<dJointGetPRAxis1>},
                {"PR axis 2", vector<dJointGetPRAxis2>},
                {"PR position", scalar<dJointGetPRPosition>},
                {"PR position rate", scalar<dJointGetPRPositionRate>},
                {"PR angle", scalar<dJointGetPRAngle>},
                {"PR angle rate", scalar<dJointGetPRAngleRate>},
                {"PR parameters", parameters<dJointGetPRParam, 2>}};

const Fields pu{{"PU anchor", vector<dJointGetPUAnchor>},
                {"PU axis 1", vector<dJointGetPUAxis1>},
                {"PU axis 2", vector<dJointGetPUAxis2>},
                {"PU axis 3", vector<dJointGetPUAxis3>},
                {"PU position", scalar<dJointGetPUPosition>},
                {"PU position rate", scalar<dJointGetPUPositionRate>},
                {"PU angle 1", scalar<dJointGetPUAngle1>},
                {"PU angle 2", scalar<dJointGetPUAngle2>},
                {"PU angle rate 1", scalar<dJointGetPUAngle1Rate>},
                {"PU angle rate 2", scalar<dJointGetPUAngle2Rate>},
                {"PU parameters", parameters<dJointGetPUParam, 3>}};

const Fields piston{{"piston anchor", vector<dJointGetPistonAnchor>},
                    {"piston anchor 2", vector<dJointGetPistonAnchor2>},
                    {"piston axis", vector<dJointGetPistonAxis>},
                    {"piston position", scalar<dJointGetPistonPosition>},
                    {"piston position rate", scalar<dJointGetPistonPositionRate>},
                    {"piston angle", scalar<dJointGetPistonAngle>},
                    {"piston angle rate", scalar<dJointGetPistonAngleRate>},
                    {"piston parameters", parameters<dJointGetPistonParam, 2>}};

const Fields fixed{{"fixed parameters", parameters<dJointGetFixedParam, 1>}};

const Fields angularMotor{{"angular motor axes", motorAxes<dJointGetAMotorNumAxes, dJointGetAMotorAxis>},
                          {"angular motor angles", motorAngles},
                          {"angular motor mode", number<dJointGetAMotorMode>},
                          {"angular motor parameters", parameters<dJointGetAMotorParam, 3>}};

const Fields linearMotor{{"linear motor axes", motorAxes<dJointGetLMotorNumAxes, dJointGetLMotorAxis>},
                         {"linear motor parameters", parameters<dJointGetLMotorParam, 3>}};

const Fields doubleBall{{"double ball anchor 1", vector<dJointGetDBallAnchor1>},
                        {"double ball anchor 2", vector<dJointGetDBallAnchor2>},
                        {"double ball distance", scalar<dJointGetDBallDistance>},
                        {"double ball parameters", parameters<dJointGetDBallParam, 1>}};

const Fields doubleHinge{{"double hinge anchor 1", vector<dJointGetDHingeAnchor1>},
                         {"double hinge anchor 2", vector<dJointGetDHingeAnchor2>},
                         {"double hinge axis", vector<dJointGetDHingeAxis>},
                         {"double hinge distance", scalar<dJointGetDHingeDistance>},
                         {"double hinge parameters", parameters<dJointGetDHingeParam, 1>}};

// Contact points and angles are excluded: upstream leaves them unset until the first step. The scenario
// of transmissions notes them after every step.
const Fields transmission{{"transmission anchor 1", vector<dJointGetTransmissionAnchor1>},
                          {"transmission anchor 2", vector<dJointGetTransmissionAnchor2>},
                          {"transmission axis 1", vector<dJointGetTransmissionAxis1>},
                          {"transmission axis 2", vector<dJointGetTransmissionAxis2>},
                          {"transmission mode", number<dJointGetTransmissionMode>},
                          {"transmission ratio", scalar<dJointGetTransmissionRatio>},
                          {"transmission radius 1", scalar<dJointGetTransmissionRadius1>},
                          {"transmission radius 2", scalar<dJointGetTransmissionRadius2>},
                          {"transmission backlash", scalar<dJointGetTransmissionBacklash>},
                          {"transmission parameters", parameters<dJointGetTransmissionParam, 1>}};

}  // namespace

const std::vector<Field<dJointID>> &jointFields() {
    static const Fields fields{{"type", [](dJointID joint, const Names &,
                                           Reading &reading) { reading.integer(dJointGetType(joint)); }},
                               {"enabled", number<dJointIsEnabled>},
                               {"bodies", readBodies},
                               {"feedback", readFeedback}};
    return fields;
}

const std::vector<Field<dJointID>> &jointFields(dJointType type) {
    static const std::map<dJointType, Fields> byType{{dJointTypeBall, ball},
                                                     {dJointTypeHinge, hinge},
                                                     {dJointTypeSlider, slider},
                                                     {dJointTypeHinge2, hinge2},
                                                     {dJointTypeUniversal, universal},
                                                     {dJointTypePR, pr},
                                                     {dJointTypePU, pu},
                                                     {dJointTypePiston, piston},
                                                     {dJointTypeFixed, fixed},
                                                     {dJointTypeAMotor, angularMotor},
                                                     {dJointTypeLMotor, linearMotor},
                                                     {dJointTypeDBall, doubleBall},
                                                     {dJointTypeDHinge, doubleHinge},
                                                     {dJointTypeTransmission, transmission}};
    static const Fields none;
    const auto found = byType.find(type);
    return found == byType.end() ? none : found->second;
}

}  // namespace exactness
