#include "additions.h"
#include "scenario_scene.h"

namespace exactness {

namespace {

struct Surface {
    int mode;
    dReal mu;
};

// One for each part of the scene: every mode of a contact joint, alone and with others.
constexpr Surface surfaces[] = {
    {dContactApprox0, 0.6},
    {dContactApprox1, 0.6},
    {dContactApprox1_1, 0.6},
    {dContactApprox1_2, 0.6},
    {dContactApprox0, 0},
    {dContactApprox0, dInfinity},
    {dContactApprox1 | dContactMu2, 0.2},
    {dContactApprox0 | dContactMu2 | dContactFDir1, 0.9},
    {dContactApprox1 | dContactBounce, 0.5},
    {dContactSoftERP | dContactSoftCFM, 0.4},
    {dContactApprox1 | dContactMotion1 | dContactMotion2, 0.8},
    {dContactApprox1 | dContactMotionN | dContactFDir1, 0.8},
    {dContactApprox1 | dContactSlip1 | dContactSlip2, 0.8},
    {dContactApprox1 | dContactRolling | dContactApprox1_N, 0.7},
    {dContactRolling, 0.7},
    {dContactRolling | dContactAxisDep | dContactBounce | dContactSlip1 | dContactMotion1 | dContactFDir1,
     0.7},
};
constexpr int surfaceCount = sizeof(surfaces) / sizeof(surfaces[0]);

// Boxes, spheres and capsules sliding and rolling over the ground and over one another.
class Friction : public ManyParts {
public:
    explicit Friction(Stepper stepper) : ManyParts(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) { addPart(part, origin); }, surfaceCount);
    }

protected:
    void setSurface(dContact &contact) override {
        const Surface &surface = surfaces[partOf(contact.geom)];
        dSurfaceParameters &parameters = contact.surface;
        parameters.mode = surface.mode;
        parameters.mu = surface.mu;
        parameters.mu2 = 0.3;
        parameters.rho = 0.02;
        parameters.rho2 = 0.03;
        parameters.rhoN = 0.01;
        parameters.bounce = 0.6;
        parameters.bounce_vel = 0.1;
        parameters.soft_erp = 0.5;
        parameters.soft_cfm = 1e-3;
        parameters.motion1 = 0.7;
        parameters.motion2 = -0.4;
        parameters.motionN = 0.05;
        parameters.slip1 = 0.02;
        parameters.slip2 = 0.01;
        setDirection(contact);
    }

private:
    void addPart(int part, Vector3 origin) {
        for (int i = 0; i < 3; ++i) {
            const Vector3 place = origin + Vector3{dReal(0.7) * i, 0, 0};
            push(addBox(place + Vector3{0, 0, 0.26}, {0.6, 0.5, 0.5}, 2), part);
            push(addSphere(place + Vector3{0.05, 0.02, 0.72}, 0.2, 1), part);
            push(addCapsule(place + Vector3{0, 1, 0.3}, scenes::kAxisY, 0.15, 0.3, 1), part);
        }
    }

    static void push(dBodyID body, int part) {
        dBodySetLinearVel(body, 1.5, 0.3 * (part % 3), 0);
        dGeomSetData(dBodyGetFirstGeom(body), const_cast<Surface *>(&surfaces[part]));
    }

    static int partOf(const dContactGeom &contact) {
        void *data = dGeomGetData(contact.g1);
        if (data == nullptr) data = dGeomGetData(contact.g2);
        return static_cast<int>(static_cast<const Surface *>(data) - surfaces);
    }

    // A tangent: the normal turned by a quarter about some axis.
    static void setDirection(dContact &contact) {
        dVector3 other;
        dPlaneSpace(contact.geom.normal, contact.fdir1, other);
        contact.fdir1[3] = 0;
    }
};

}  // namespace

void addFriction(Catalogue &catalogue) {
    catalogue.push_back({"friction",
                         "all contact modes: pyramids, mu2, directions, bounce, motion, slip, rolling", 80,
                         make<Friction>()});
}

}  // namespace exactness
