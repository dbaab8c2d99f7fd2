# Boxes that fall, by DART with ODE's collision detector (python3-dartpy): COUNT STEPS. Prints the number of contacts of all steps, and a hash of
# where the boxes are. The floor is a box that stands fast.
# [dart]
import hashlib
import struct
import sys

import dartpy as dart

world = dart.simulation.World()
world.setTimeStep(0.002)
world.setGravity([0, 0, -9.81])
world.getConstraintSolver().setCollisionDetector(dart.collision.OdeCollisionDetector())


def add_box(name, edges, position, is_free):
    box = dart.dynamics.Skeleton(name)
    joint, body = box.createFreeJointAndBodyNodePair() if is_free else box.createWeldJointAndBodyNodePair()
    shape = body.createShapeNode(dart.dynamics.BoxShape(edges))
    shape.createCollisionAspect()
    shape.createDynamicsAspect()
    if is_free:
        box.setPositions([0.1 * position[0], 0.05, 0, *position])
    else:
        place = dart.math.Isometry3()
        place.set_translation(position)
        joint.setTransformFromParentBodyNode(place)
    world.addSkeleton(box)
    return box


add_box("floor", [20, 20, 0.2], [0, 0, -0.1], False)
boxes = [add_box(f"box {i}", [0.3, 0.3, 0.3], [0.2 * (i % 3), 0.22 * (i // 3 % 2), 0.3 + 0.35 * i], True) for i in range(int(sys.argv[1]))]
contacts = 0
for step in range(int(sys.argv[2])):
    world.step()
    contacts += world.getLastCollisionResult().getNumContacts()
print(contacts, hashlib.sha256(b"".join(struct.pack("<6d", *box.getPositions()) for box in boxes)).hexdigest())
# [dart]
