// A geom class of the user with a collider, and a collider set in place of one of ODE.
//
// Covers dxColliderTable.cpp.
#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

struct Disc {
    dReal radius;  // m, of a flat upright disc, collided as a ball around its middle
};

int collideWithPlane(dGeomID disc, dGeomID plane, int, dContactGeom *contact, int) {
    const Disc *data = static_cast<const Disc *>(dGeomGetClassData(disc));
    const dReal *place = dGeomGetPosition(disc);
    dVector4 parameters;
    dGeomPlaneGetParams(plane, parameters);
    const dReal depth = data->radius + parameters[3] - dCalcVectorDot3(parameters, place);
    if (depth < 0) return 0;
    for (int i = 0; i < 3; ++i) {
        contact->pos[i] = place[i] - parameters[i] * data->radius;
        contact->normal[i] = parameters[i];
    }
    contact->depth = depth;
    contact->g1 = disc;
    contact->g2 = plane;
    contact->side1 = contact->side2 = -1;
    return 1;
}

int collideWithDisc(dGeomID one, dGeomID other, int, dContactGeom *contact, int) {
    const dReal *p1 = dGeomGetPosition(one), *p2 = dGeomGetPosition(other);
    dVector3 between;
    dSubtractVectors3(between, p1, p2);
    const dReal distance = dCalcVectorLength3(between);
    const dReal reach = static_cast<const Disc *>(dGeomGetClassData(one))->radius +
                        static_cast<const Disc *>(dGeomGetClassData(other))->radius;
    if (distance >= reach || distance == 0) return 0;
    for (int i = 0; i < 3; ++i) {
        contact->pos[i] = (p1[i] + p2[i]) / 2;
        contact->normal[i] = between[i] / distance;
    }
    contact->depth = reach - distance;
    contact->g1 = one;
    contact->g2 = other;
    contact->side1 = contact->side2 = -1;
    return 1;
}

dColliderFn *chooseCollider(int otherClass) {
    if (otherClass == dPlaneClass) return &collideWithPlane;
    return otherClass >= dFirstUserClass ? &collideWithDisc : nullptr;
}

void boundDisc(dGeomID disc, dReal box[6]) {
    const dReal radius = static_cast<const Disc *>(dGeomGetClassData(disc))->radius,
                *place = dGeomGetPosition(disc);
    for (int i = 0; i < 3; ++i) {
        box[2 * i] = place[i] - radius;
        box[2 * i + 1] = place[i] + radius;
    }
}

int refuseSome(dGeomID one, dGeomID other, dReal[6]) {
    return dGeomGetClass(one) == dGeomGetClass(other) ? 1 : 0;
}

// A collider set in place of ODE's own, which finds half of the contacts.
int collideSphereWithPlane(dGeomID sphere, dGeomID plane, int, dContactGeom *contact, int) {
    const dReal *place = dGeomGetPosition(sphere);
    const dReal depth =
        dGeomPlanePointDepth(plane, place[0], place[1], place[2]) + dGeomSphereGetRadius(sphere);
    if (depth < 0.01) return 0;
    contact->pos[0] = place[0];
    contact->pos[1] = place[1];
    contact->pos[2] = 0;
    contact->normal[0] = contact->normal[1] = 0;
    contact->normal[2] = 1;
    contact->depth = depth;
    contact->g1 = sphere;
    contact->g2 = plane;
    contact->side1 = contact->side2 = -1;
    return 1;
}

class UserGeoms : public ManyParts {
public:
    explicit UserGeoms(Stepper stepper) : ManyParts(stepper) {
        const dGeomClass description = {sizeof(Disc), &chooseCollider, &boundDisc, &refuseSome, nullptr};
        const int discClass = dCreateGeomClass(&description);
        dSetColliderOverride(dSphereClass, dPlaneClass, &collideSphereWithPlane);
        addGround();
        addParts([this, discClass](int part, Vector3 origin) {
            for (int i = 0; i < 6; ++i)
                addDisc(discClass,
                        origin + Vector3{dReal(0.02) * part, dReal(0.03) * i, dReal(0.3) + dReal(0.55) * i});
            addSphere(origin + Vector3{2, 0, 0.2}, 0.2, 1);
        });
    }

private:
    void addDisc(int discClass, Vector3 place) {
        const dBodyID body = addBody(place, world());
        const dGeomID disc = dCreateGeom(discClass);
        static_cast<Disc *>(dGeomGetClassData(disc))->radius = 0.3;
        dSpaceAdd(space(), disc);
        dGeomSetBody(disc, body);
        add(disc);
    }
};

}  // namespace

void addUserGeomClass(Catalogue &catalogue) {
    catalogue.push_back({"user_geom_class", "a class of geoms by the user, and a collider in place of ODE's",
                         60, make<UserGeoms>()});
}

}  // namespace exactness
