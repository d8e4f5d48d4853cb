# SPDX-License-Identifier: BSD-3-Clause
# The gas of gas.yaml in Yade: yade -n -x gas.py STATE TABLE; STATE has rows x y z radius vx vy vz
import sys, time
state, table = sys.argv[-2:]
O.periodic = True
O.cell.hSize = Matrix3(0.04, 0, 0, 0, 0.04, 0, 0, 0, 0.04)
glass = O.materials.append(FrictMat(young=50e6, poisson=0.2, density=2500, frictionAngle=0))
for line in open(state):
    x, y, z, r, vx, vy, vz = map(float, line.split())
    body = O.bodies[O.bodies.append(sphere((x, y, z), r, material=glass))]
    body.state.vel = (vx, vy, vz)
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.1 * 1e-3),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_MindlinPhys(en=0.8, es=0.8)], [Law2_ScGeom_MindlinPhys_Mindlin()]),
    NewtonIntegrator(damping=0, gravity=(0, 0, 0)),
]
O.dt = 1e-6
rows = []
begin = time.time()
for k in range(21):
    rows.append((O.time, sum(0.5 * b.state.mass * b.state.vel.squaredNorm() for b in O.bodies)))
    if k < 20:
        O.run(2000, True)
with open(table, 'w') as out:
    out.write('time,energy\n')
    for row in rows:
        out.write('%g,%.12g\n' % row)
    out.write('# seconds %.3f\n' % (time.time() - begin))
