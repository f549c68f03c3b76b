"""Builds URDF robots from solids in pure Python; computes mass, centre of mass and inertia from the shapes and a density.

A pose is (xyz, rpy) with fixed-axis roll, pitch, yaw as in URDF; metres, radians, kilograms.
"""
import math

from mesh_from_field import assert_closed, mesh_with, write_stl

NOWHERE = ((0, 0, 0), (0, 0, 0))


def rotation(rpy):
    (cr, cp, cy), (sr, sp, sy) = [math.cos(a) for a in rpy], [math.sin(a) for a in rpy]
    return [[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
            [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
            [-sp, cp * sr, cp * cr]]


def times(R, v):
    return [sum(R[i][k] * v[k] for k in range(3)) for i in range(3)]


class Solid:
    """Volume (m^3), centre of mass, and inertia about it for density 1, in the frame of the link; `element`: URDF text."""

    def __init__(self, element, volume, centre, inertia, pose):
        self.element, self.volume, self.pose = element, volume, pose
        R = rotation(pose[1])
        self.centre = [a + b for a, b in zip(pose[0], times(R, centre))]
        turned = [times(R, column) for column in zip(*inertia)]          # columns of R I
        RI = [list(row) for row in zip(*turned)]
        self.inertia = [[sum(RI[i][k] * R[j][k] for k in range(3)) for j in range(3)] for i in range(3)]


def diagonal(x, y, z):
    return [[x, 0, 0], [0, y, 0], [0, 0, z]]


def number(v):
    text = f"{v:.9g}"
    return "0" if float(text) == 0 else text


def numbers(values):
    return " ".join(number(v) for v in values)


def box(size, pose=NOWHERE):
    x, y, z = size
    v = x * y * z
    return Solid(f'<box size="{numbers(size)}"/>', v, (0, 0, 0),
                 diagonal(v * (y * y + z * z) / 12, v * (x * x + z * z) / 12, v * (x * x + y * y) / 12), pose)


def cylinder(radius, length, pose=NOWHERE):
    v = math.pi * radius ** 2 * length
    side = v * (3 * radius ** 2 + length ** 2) / 12
    return Solid(f'<cylinder radius="{number(radius)}" length="{number(length)}"/>', v, (0, 0, 0),
                 diagonal(side, side, v * radius ** 2 / 2), pose)


def sphere(radius, pose=NOWHERE):
    v = 4 / 3 * math.pi * radius ** 3
    return Solid(f'<sphere radius="{number(radius)}"/>', v, (0, 0, 0), diagonal(*[0.4 * v * radius ** 2] * 3), pose)


def mesh(file, vertices, triangles, pose=NOWHERE):
    """Solid of a mesh, by volume integrals over the tetrahedra of the triangles and the origin."""
    v, first, second = 0.0, [0.0] * 3, [[0.0] * 3 for _ in range(3)]
    for triangle in triangles:
        p, q, r = (vertices[i] for i in triangle)
        w = (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2])
             + p[2] * (q[0] * r[1] - q[1] * r[0])) / 6
        v += w
        s = [p[i] + q[i] + r[i] for i in range(3)]
        for i in range(3):
            first[i] += w * s[i] / 4
            for k in range(3):
                second[i][k] += w / 20 * (s[i] * s[k] + p[i] * p[k] + q[i] * q[k] + r[i] * r[k])
    centre = [c / v for c in first]
    about = [[second[i][k] - v * centre[i] * centre[k] for k in range(3)] for i in range(3)]
    trace = sum(about[i][i] for i in range(3))
    inertia = [[(trace if i == k else 0.0) - about[i][k] for k in range(3)] for i in range(3)]
    return Solid(f'<mesh filename="{file}"/>', v, centre, inertia, pose)


def mesh_from(folder, name, field, reach, triangles):
    """Meshes a field within the cube of half side `reach`, writes NAME.stl, and returns the solid."""
    coarse = mesh_with(field, (-reach,) * 3, (reach,) * 3, 800, 0.3)[0]
    lower = [min(v[m] for v in coarse) - 0.01 for m in range(3)]
    upper = [max(v[m] for v in coarse) + 0.01 for m in range(3)]
    vertices, faces = mesh_with(field, lower, upper, triangles)
    assert_closed(name, vertices, faces)
    write_stl(f"{folder}/{name}.stl", name, vertices, faces)
    return mesh(f"{name}.stl", vertices, faces)


class Robot:
    def __init__(self, name, comment):
        self.name, self.comment, self.text, self.dofs, self.mass = name, comment, [], 0, 0.0
        self.bodies = []  # names in a scene

    def link(self, name, solids=(), density=1000.0):
        """Adds a link. Each solid is collision and visual geometry; overlaps count twice in the mass."""
        self.bodies += [f"{self.name}/{name}" + (f"/{i + 1}" if i else "") for i in range(len(solids))]
        out = [f'  <link name="{name}">']
        if solids:
            out.append("    " + self.inertial(solids, density))
        for solid in solids:
            body = f'<origin xyz="{numbers(solid.pose[0])}" rpy="{numbers(solid.pose[1])}"/>' \
                   f"<geometry>{solid.element}</geometry>"
            out += [f"    <visual>{body}</visual>", f"    <collision>{body}</collision>"]
        self.text += out + ["  </link>"]

    def inertial(self, solids, density):
        mass = density * sum(s.volume for s in solids)
        self.mass += mass
        centre = [density * sum(s.volume * s.centre[i] for s in solids) / mass for i in range(3)]
        I = [[0.0] * 3 for _ in range(3)]
        for s in solids:
            d = [s.centre[i] - centre[i] for i in range(3)]
            square = sum(c * c for c in d)
            for i in range(3):
                for k in range(3):
                    I[i][k] += density * (s.inertia[i][k] + s.volume * ((square if i == k else 0.0) - d[i] * d[k]))
        names = (("ixx", 0, 0), ("ixy", 0, 1), ("ixz", 0, 2), ("iyy", 1, 1), ("iyz", 1, 2), ("izz", 2, 2))
        moments = " ".join(f'{key}="{number(I[i][k])}"' for key, i, k in names)
        return f'<inertial><origin xyz="{numbers(centre)}"/><mass value="{number(mass)}"/><inertia {moments}/></inertial>'

    def joint(self, name, kind, parent, child, pose=NOWHERE, axis=None, limit=None, mimic=None):
        """Adds a joint. limit: (lower, upper, velocity, effort); mimic: (joint, multiplier)."""
        out = [f'  <joint name="{name}" type="{kind}">', f'    <origin xyz="{numbers(pose[0])}" rpy="{numbers(pose[1])}"/>',
               f'    <parent link="{parent}"/><child link="{child}"/>']
        if axis:
            out.append(f'    <axis xyz="{numbers(axis)}"/>')
        if limit:
            lower, upper, velocity, effort = limit
            out.append(f'    <limit lower="{number(lower)}" upper="{number(upper)}" velocity="{number(velocity)}" '
                       f'effort="{number(effort)}"/>')
        if mimic:
            out.append(f'    <mimic joint="{mimic[0]}" multiplier="{number(mimic[1])}"/>')
        elif kind != "fixed":
            self.dofs += 3 if kind == "planar" else 1
        self.text += out + ["  </joint>"]

    def write(self, file):
        with open(file, "w", newline="\n") as out:
            out.write(f'<?xml version="1.0"?>\n<!-- {self.comment} -->\n<robot name="{self.name}">\n')
            out.write("\n".join(self.text) + "\n</robot>\n")
        print(f"{self.name}: {self.dofs} degrees of freedom, {self.mass:.1f} kg")


def write_motion(file, seconds, posture):
    """Writes a CSV with the columns t,q0,q1,...: posture(t) every 20 ms."""
    with open(file, "w", newline="\n") as out:
        rows = [(i * 0.02, posture(i * 0.02)) for i in range(round(seconds / 0.02) + 1)]
        out.write("t," + ",".join(f"q{i}" for i in range(len(rows[0][1]))) + "\n")
        for t, q in rows:
            out.write(f"{t:.6g}," + ",".join(f"{v:.6g}" for v in q) + "\n")
