"""Run by Yade: a cantilever of GridConnections under a dead force at its tip.

  yade -n -x cantilever_yade.py CASE.json RESULT.json

The case has: length, radius, E, Poisson's ratio, force, elements, damping, time
step over that of a wave through one element, and the tolerance: motion has ended
when the tip moves by less than this part of the length in a tenth of a period.
"""
import json
import math
import sys
import time

from yade.gridpfacet import gridConnection, gridNode

with open(sys.argv[1]) as file:
    case = json.load(file)
n, length, radius = case["elements"], case["length"], case["radius"]
density = 1.

O.engines = [
    ForceResetter(),
    InteractionLoop(
        [Ig2_GridNode_GridNode_GridNodeGeom6D()],
        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(
            setCohesionNow=True, setCohesionOnNewContacts=False)],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment()]),
    NewtonIntegrator(gravity=(0, 0, 0), damping=case["damping"])]
O.materials.append(CohFrictMat(
    young=case["E"], poisson=case["nu"], density=density, frictionAngle=0.,
    normalCohesion=1e30, shearCohesion=1e30, momentRotationLaw=True))
nodes = [O.bodies.append(gridNode((length * i / n, 0, 0), radius))
         for i in range(n + 1)]
for pair in zip(nodes, nodes[1:]):
    O.bodies.append(gridConnection(*pair, radius))
O.bodies[nodes[0]].state.blockedDOFs = "xyzXYZ"
O.forces.setPermF(nodes[-1], (0, case["force"], 0))

O.dt = case["step"] * length / n * math.sqrt(density / case["E"])
# First mode of a straight cantilever: 1.8751^2 sqrt(E I / (rho A)) / L^2.
period = (2 * math.pi * length**2
          / (1.8751**2 * math.sqrt(case["E"] / density) * radius / 2))
began = time.process_time()
tip, moved = O.bodies[nodes[-1]].state, length
while moved > case["tolerance"] * length:
    before = tip.pos
    O.run(round(0.1 * period / O.dt), True)
    moved = (tip.pos - before).norm()
seconds = time.process_time() - began
with open(sys.argv[2], "w") as file:
    json.dump({"tip": [tip.pos[0] - length, tip.pos[1]], "steps": O.iter,
               "seconds": seconds}, file)
