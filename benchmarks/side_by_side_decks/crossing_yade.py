"""Run by Yade: clamped fibers of a file of centerlines, the ends of the set
'upper' come down by 2; beams of GridConnections, contact with friction.

  yade -n -x crossing_yade.py CASE.json RESULT.json

The case has: centerlines (a file of heddle, whose fibers are straight), elements
per fiber, time in which the ends come down, hold, damping, and time step over
that of a wave through one element. Motion is slowed down by a long time and held
at the end; forces are those on the clamped nodes.
"""
import csv
import json
import math
import sys
import time

from yade.gridpfacet import gridConnection, gridNode

E, NU, MU, RADIUS, DENSITY, DROP = 1000., 0.3, 0.1, 0.5, 1., 2.

with open(sys.argv[1]) as file:
    case = json.load(file)
fibers = {}
with open(case["centerlines"]) as file:
    for row in csv.DictReader(line for line in file if line[0] != "#"):
        fibers.setdefault(row["fiber"], []).append(
            ([float(row[c]) for c in "xyz"], row["set"]))

O.engines = [
    ForceResetter(),
    # Boxes a little larger than the fibers are good for many steps.
    InsertionSortCollider([Bo1_GridConnection_Aabb()],
                          verletDist=0.05 * RADIUS),
    InteractionLoop(
        [Ig2_GridNode_GridNode_GridNodeGeom6D(),
         Ig2_GridConnection_GridConnection_GridCoGridCoGeom()],
        [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(
            setCohesionNow=True, setCohesionOnNewContacts=False),
         Ip2_FrictMat_FrictMat_FrictPhys()],
        [Law2_ScGeom6D_CohFrictPhys_CohesionMoment(),
         Law2_GridCoGridCoGeom_FrictPhys_CundallStrack()]),
    NewtonIntegrator(gravity=(0, 0, 0), damping=case["damping"])]
angle = math.atan(MU)
O.materials.append(CohFrictMat(
    young=E, poisson=NU, density=DENSITY, frictionAngle=angle,
    normalCohesion=1e30, shearCohesion=1e30, momentRotationLaw=True,
    label="beam"))
O.materials.append(FrictMat(young=E, poisson=NU, density=DENSITY,
                            frictionAngle=angle, label="surface"))

n = case["elements"]
clamped = {"lower": [], "upper": []}
for points in fibers.values():
    (begin, kind), (end, _) = points[0], points[-1]
    nodes = [O.bodies.append(gridNode(
        [a + (b - a) * i / n for a, b in zip(begin, end)], RADIUS,
        material="beam")) for i in range(n + 1)]
    for pair in zip(nodes, nodes[1:]):
        O.bodies.append(gridConnection(*pair, RADIUS, material="surface"))
    for node in (nodes[0], nodes[-1]):
        O.bodies[node].state.blockedDOFs = "xyzXYZ"
        clamped[kind].append(node)

# The time of a wave through an element: sqrt(mass / axial stiffness).
O.dt = case["step"] * math.dist(begin, end) / n * math.sqrt(DENSITY / E)
began = time.process_time()
n_steps = round(case["time"] / O.dt)
for velocity, steps in ((-DROP / (n_steps * O.dt), n_steps),
                        (0., round(case["hold"] / O.dt))):
    for node in clamped["upper"]:
        O.bodies[node].state.vel = (0, 0, velocity)
    O.run(steps, True)
seconds = time.process_time() - began

force = {kind: abs(sum(O.forces.f(node)[2] for node in nodes))
         for kind, nodes in clamped.items()}
with open(sys.argv[2], "w") as file:
    json.dump({"lower": force["lower"], "upper": force["upper"],
               "steps": O.iter, "seconds": seconds,
               "contacts": O.interactions.countReal() - n * len(fibers)}, file)
