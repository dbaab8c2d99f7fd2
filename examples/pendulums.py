#!/usr/bin/env python3
"""Debian's Python binding, unchanged: python3-pyode is linked to libode.so.8, and gets ODE_MT's where that is installed or found first.

    ODE_MT_THREADS=auto python3 pendulums.py

Prints the mean height of the ends of 100 chains that swing, in metres, which does not depend on the number of threads."""
import ode

CHAINS, LINKS = 100, 5


def add_chain(world, y):
    links, joints = [], []
    for i in range(LINKS):
        body = ode.Body(world)
        mass = ode.Mass()
        mass.setBoxTotal(0.5, 0.4, 0.05, 0.05)
        body.setMass(mass)
        body.setPosition((0.4 * i + 0.2, y, 3))
        joint = ode.BallJoint(world)
        joint.attach(body, links[-1] if links else ode.environment)
        joint.setAnchor((0.4 * i, y, 3))
        links.append(body)
        joints.append(joint)
    return links, joints


world = ode.World()
world.setGravity((0, 0, -9.81))
chains = [add_chain(world, y) for y in range(CHAINS)]
for step in range(100):
    world.step(0.01)
heights = [links[-1].getPosition()[2] for links, joints in chains]
print(f"mean height of {CHAINS} ends: {sum(heights) / CHAINS:.9f} m")
