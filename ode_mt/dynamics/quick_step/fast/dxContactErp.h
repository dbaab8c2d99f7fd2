// How much of a contact's depth one step corrects.
#pragma once

#include <ode/contact.h>

#include "objects.h"

inline dReal dxContactErp(const dxWorld &world, const dSurfaceParameters &surface) {
    return (surface.mode & dContactSoftERP) != 0 ? surface.soft_erp : world.global_erp;
}
