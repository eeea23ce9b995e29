# SPDX-License-Identifier: GPL-2.0-only
"""YADE; constants, platens and step are those of stock.lmp. Arguments: STEPS SKIN [m]; reads yade.txt.

Where it differs: the shear spring follows the spin about the normal too, and slip is taken at lever arms that do not
ratchet (`avoidGranularRatcheting`). YADE has no round wall that holds grains inside: the cylinder is of flat facets
about the true one. A grain at an edge touches two of them, one between edges and the true cylinder none.
"""
import math
import sys
import time

from yade import geom, utils

steps, skin = int(sys.argv[1]), float(sys.argv[2])
sides = 48  # fewer leave wider gaps, more have more grains at edges; the speed is the same

rough = O.materials.append(FrictMat(density=1738, frictionAngle=math.atan(0.8)))
smooth = O.materials.append(FrictMat(density=1738, frictionAngle=0))
with open("yade.txt") as grains:
    for line in grains:
        x, y, z, radius = map(float, line.split())
        O.bodies.append(utils.sphere((x, y, z), radius, material=rough))
O.bodies.append([utils.wall(z, axis=2, material=rough) for z in (0, 0.2)])
O.bodies.append(geom.facetCylinder((0, 0, 0.1), radius=0.05 / math.cos(math.pi / sides), height=0.2,
                                   segmentsNumber=sides, wallMask=4, material=smooth))
O.engines = [
    ForceResetter(),
    # Both boxes of a pair grow by verletDist, so that pairs are kept up to one skin apart; slow grains less (default).
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb(), Bo1_Facet_Aabb()], verletDist=skin / 2),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(), Ig2_Facet_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_FrictPhys(kn=MatchMaker(algo="val", val=27489),
                                         ks=MatchMaker(algo="val", val=7854))],
        [Law2_ScGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(damping=0, gravity=(0, 0, -9.8)),
]
O.dt = 1e-8

O.run(200, True)
start = time.perf_counter()
O.run(steps, True)
loop = time.perf_counter() - start

is_grain = [isinstance(body.shape, Sphere) for body in O.bodies]
contacts = sum(is_grain[i.id1] and is_grain[i.id2] for i in O.interactions)
print(f"Loop time of {loop}")
print(f"end: {contacts} contacts of grains, {utils.kineticEnergy()} J")
