"""Boxes that collapse, by python3-pyode, for docs/start.md: pile.py BOXES STEPS prints a hash of all positions at the end."""
# [pile]
import hashlib
import struct
import sys

import ode

world = ode.World()
world.setGravity((0, 0, -9.81))
space = ode.HashSpace()
floor = ode.GeomPlane(space, (0, 0, 1), 0)
contacts = ode.JointGroup()
bodies, geoms = [], []
for i in range(int(sys.argv[1])):
    mass = ode.Mass()
    mass.setBox(1000, 0.2, 0.2, 0.2)
    bodies.append(ode.Body(world))
    bodies[i].setMass(mass)
    bodies[i].setPosition((0.15 * (i % 4) + 0.011 * (i % 7), 0.15 * (i // 4 % 4) + 0.013 * (i % 5), 0.2 + 0.25 * (i // 16)))
    geoms.append(ode.GeomBox(space, (0.2, 0.2, 0.2)))
    geoms[i].setBody(bodies[i])


def near(data, a, b):
    for contact in ode.collide(a, b):
        contact.setMu(0.8)
        ode.ContactJoint(world, contacts, contact).attach(a.getBody(), b.getBody())


for step in range(int(sys.argv[2])):
    space.collide(None, near)
    world.quickStep(0.01)
    contacts.empty()
print(hashlib.sha256(b"".join(struct.pack("<3d", *body.getPosition()) for body in bodies)).hexdigest())
# [pile]
