#include "additions.h"
#include "scenario_scene.h"
#include "shapes.h"

namespace exactness {

namespace {

class Shapes : public ManyParts {
protected:
    using ManyParts::ManyParts;

    dBodyID drop(Shape shape, Vector3 place) {
        const dBodyID body = addBody(place, world());
        const dGeomID geom = createShape(space(), shape);
        dGeomSetBody(geom, body);
        add(geom);
        return body;
    }

    // Calls meet(number, one, other) for every two shapes, and for each shape with itself.
    template <class Meet>
    static void forAllPairs(const Meet &meet) {
        int number = 0;
        for (Shape one : allShapes) {
            for (Shape other : allShapes) {
                if (other >= one) meet(number++, one, other);
            }
        }
    }
};

// Each shape falls on each, both above the ground.
class Pairs : public Shapes {
public:
    explicit Pairs(Stepper stepper) : Shapes(stepper) {
        addGround();
        forAllPairs([this](int number, Shape one, Shape other) {
            const dReal x = dReal(3) * (number % 5), y = dReal(3) * (number / 5);
            const dBodyID below = drop(one, {x, y, 0.3}),
                          above = drop(other, {x + dReal(0.05), y + dReal(0.03), 0.85});
            dBodySetAngularVel(above, 0.2, 0.4, 1);
            dBodySetLinearVel(below, 0, 0, 0.1);
        });
    }
};

// Every shape as the child of a geom transform: on the ground, on one another and on a box.
class Transforms : public Shapes {
public:
    explicit Transforms(Stepper stepper) : Shapes(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            constexpr int count = sizeof(allShapes) / sizeof(allShapes[0]);
            dropInTransform(allShapes[part % count], origin + Vector3{0, 0, 0.4}, part % 2);
            dropInTransform(allShapes[(part / 2) % count], origin + Vector3{0.1, 0, 1.0}, part % 2);
            addBox(origin + Vector3{0, 0.05, 1.6}, {0.4, 0.4, 0.4}, 1);
            addSphere(origin + Vector3{0, 0, 2.1}, 0.2, 1);
        });
    }

private:
    void dropInTransform(Shape shape, Vector3 place, int info) {
        const dBodyID body = addBody(place, world());
        const dGeomID transform = dCreateGeomTransform(space()), child = createShape(nullptr, shape);
        dGeomSetPosition(child, 0.05, 0.02, 0.03);
        dMatrix3 tilt;
        dRFromAxisAndAngle(tilt, 1, 0, 0, 0.3);
        dGeomSetRotation(child, tilt);
        dGeomTransformSetCleanup(transform, 1);
        dGeomTransformSetInfo(transform, info);
        dGeomTransformSetGeom(transform, child);
        dGeomSetBody(transform, body);
        add(transform);
    }
};

// Geoms set off from their bodies, several to a body.
class Offsets : public Shapes {
public:
    explicit Offsets(Stepper stepper) : Shapes(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            for (int i = 0; i < 3; ++i)
                addCompound(part + i, origin + Vector3{0, 0, dReal(0.6) + dReal(0.9) * i});
        });
    }

    void control() override {
        const dGeomID geom = m_inventory.geoms[1 + frameNumber() % 20];
        if (frameNumber() % 7 == 0) dGeomSetOffsetPosition(geom, 0.01 * (frameNumber() % 30), 0, 0);
    }

private:
    void addCompound(int kind, Vector3 place) {
        const dBodyID body = drop(allShapes[kind % 5], place);
        for (int side : {-1, 1}) {
            const dGeomID arm = createShape(space(), allShapes[(kind + side + 5) % 5]);
            dGeomSetBody(arm, body);
            dGeomSetOffsetPosition(arm, 0.3 * side, 0, 0.05);
            dQuaternion turn;
            dQFromAxisAndAngle(turn, 0, 1, 0.2, 0.5 * side);
            dGeomSetOffsetQuaternion(arm, turn);
            add(arm);
        }
    }
};

// Rays through every shape, attached to bodies and not.
class Rays : public Shapes {
public:
    explicit Rays(Stepper stepper) : Shapes(stepper) {
        addGround();
        addParts([this](int part, Vector3 origin) {
            int number = 0;
            for (Shape shape : allShapes) {
                const Vector3 place = origin + Vector3{dReal(1.2) * number++, 0, 0.5};
                addRay(drop(shape, place), part);
                const dGeomID still = add(dCreateRay(space(), 2));
                dGeomSetCategoryBits(still, kDynamicCategory);
                dGeomRaySet(still, place.x - 1, place.y + 0.02, 0.25, 1, 0.05, 0.01 * part);
            }
        });
    }

private:
    void addRay(dBodyID body, int part) {
        const dGeomID ray = dCreateRay(space(), 1.5);
        dGeomSetBody(ray, body);
        dGeomSetOffsetPosition(ray, 0, 0, 0.4);
        dGeomRaySetClosestHit(ray, part % 2);
        dGeomRaySetFirstContact(ray, part / 2 % 2);
        dGeomRaySetBackfaceCull(ray, part / 4 % 2);
        add(ray);
    }
};

}  // namespace

void addGeomPairs(Catalogue &catalogue) {
    catalogue.push_back(
        {"geom_pairs/pairs", "every two shapes on one another and on a plane", 80, make<Pairs>()});
    catalogue.push_back({"geom_pairs/transforms", "every shape in a geom transform", 60, make<Transforms>()});
    catalogue.push_back(
        {"geom_pairs/offsets", "bodies of several geoms set off from them", 60, make<Offsets>()});
    catalogue.push_back({"geom_pairs/rays", "rays through every shape", 40, make<Rays>()});
}

}  // namespace exactness
