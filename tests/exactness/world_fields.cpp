#include "field_readers.h"

namespace exactness {

const std::vector<Field<dWorldID>> &worldFields() {
    static const std::vector<Field<dWorldID>> fields{
        {"gravity", copyReals<dWorldID, dWorldGetGravity>},
        {"ERP", readReal<dWorldID, dWorldGetERP>},
        {"CFM", readReal<dWorldID, dWorldGetCFM>},
        {"QuickStep iterations", readInteger<dWorldID, dWorldGetQuickStepNumIterations>},
        {"QuickStep over-relaxation", readReal<dWorldID, dWorldGetQuickStepW>},
        {"contact max correcting velocity", readReal<dWorldID, dWorldGetContactMaxCorrectingVel>},
        {"contact surface layer", readReal<dWorldID, dWorldGetContactSurfaceLayer>},
        {"auto-disable", readInteger<dWorldID, dWorldGetAutoDisableFlag>},
        {"auto-disable steps", readInteger<dWorldID, dWorldGetAutoDisableSteps>},
        {"auto-disable time", readReal<dWorldID, dWorldGetAutoDisableTime>},
        {"auto-disable samples", readInteger<dWorldID, dWorldGetAutoDisableAverageSamplesCount>},
        {"auto-disable linear threshold", readReal<dWorldID, dWorldGetAutoDisableLinearThreshold>},
        {"auto-disable angular threshold", readReal<dWorldID, dWorldGetAutoDisableAngularThreshold>},
        {"linear damping", readReal<dWorldID, dWorldGetLinearDamping>},
        {"linear damping threshold", readReal<dWorldID, dWorldGetLinearDampingThreshold>},
        {"angular damping", readReal<dWorldID, dWorldGetAngularDamping>},
        {"angular damping threshold", readReal<dWorldID, dWorldGetAngularDampingThreshold>},
        {"max angular speed", readReal<dWorldID, dWorldGetMaxAngularSpeed>},
    };
    return fields;
}

}  // namespace exactness
