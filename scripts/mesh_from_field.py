"""Closed triangle meshes from signed distance functions, in pure Python (surface nets), and binary STL.

A field is a function (x, y, z) -> distance in metres, negative inside. It may be inexact away from the surface.
"""
import math
import random
import struct

# --- fields -------------------------------------------------------------------------------------------------


def smooth_union(k, *fields):
    """Union with inner edges filleted over about k metres (polynomial smooth minimum)."""

    def field(x, y, z):
        d = fields[0](x, y, z)
        for f in fields[1:]:
            e = f(x, y, z)
            h = max(k - abs(d - e), 0.0) / k
            d = min(d, e) - h * h * k / 4
        return d

    return field


def smooth_difference(k, body, *tools):
    """Body minus the tools, with edges rounded over about k metres."""

    def field(x, y, z):
        d = body(x, y, z)
        for f in tools:
            e = -f(x, y, z)
            h = max(k - abs(d - e), 0.0) / k
            d = max(d, e) + h * h * k / 4
        return d

    return field


def sphere(center, radius):
    cx, cy, cz = center
    return lambda x, y, z: math.sqrt((x - cx) ** 2 + (y - cy) ** 2 + (z - cz) ** 2) - radius


def capsule(p, q, radius, end_radius=None):
    """Capsule around the segment pq; with end_radius, the radius changes linearly from p to q."""
    end_radius = radius if end_radius is None else end_radius
    d = [q[i] - p[i] for i in range(3)]
    length2 = sum(c * c for c in d)

    def field(x, y, z):
        px, py, pz = x - p[0], y - p[1], z - p[2]
        s = min(max((px * d[0] + py * d[1] + pz * d[2]) / length2, 0.0), 1.0)
        return (math.sqrt((px - s * d[0]) ** 2 + (py - s * d[1]) ** 2 + (pz - s * d[2]) ** 2)
                - radius - s * (end_radius - radius))

    return field


def box(center, size, rounding):
    h = [0.5 * s - rounding for s in size]

    def field(x, y, z):
        qx, qy, qz = abs(x - center[0]) - h[0], abs(y - center[1]) - h[1], abs(z - center[2]) - h[2]
        outside = math.sqrt(max(qx, 0.0) ** 2 + max(qy, 0.0) ** 2 + max(qz, 0.0) ** 2)
        return outside + min(max(qx, qy, qz), 0.0) - rounding

    return field


def revolved(profile):
    """Body of revolution about z: `profile` is a polygon of (radius, z) that starts and ends on the axis."""
    edges = [(profile[i], profile[i + 1]) for i in range(len(profile) - 1)]

    def field(x, y, z):
        rho = math.hypot(x, y)
        best, inside = 1e9, False
        for (r0, z0), (r1, z1) in edges:
            er, ez, wr, wz = r1 - r0, z1 - z0, rho - r0, z - z0
            s = min(max((wr * er + wz * ez) / (er * er + ez * ez), 0.0), 1.0)
            best = min(best, (wr - s * er) ** 2 + (wz - s * ez) ** 2)
            if (z0 > z) != (z1 > z) and rho < r0 + (z - z0) * er / ez:
                inside = not inside
        d = math.sqrt(best)
        return -d if inside else d

    return field


def turned(field, to_local):
    """The field in other coordinates: to_local maps a point (x, y, z) to the coordinates of the field."""
    return lambda x, y, z: field(*to_local(x, y, z))


def rounded_profile(points, radius, steps=4):
    """Polygon with inner corners replaced by arcs of about the given radius."""
    out = [points[0]]
    for (ax, ay), (bx, by), (cx, cy) in zip(points, points[1:], points[2:]):
        u, v = math.hypot(ax - bx, ay - by), math.hypot(cx - bx, cy - by)
        r = min(radius, 0.45 * u, 0.45 * v)
        p = (bx + (ax - bx) * r / u, by + (ay - by) * r / u)
        q = (bx + (cx - bx) * r / v, by + (cy - by) * r / v)
        for i in range(steps + 1):
            s = i / steps
            out.append(tuple((1 - s) ** 2 * p[k] + 2 * s * (1 - s) * (bx, by)[k] + s * s * q[k] for k in (0, 1)))
    return out + [points[-1]]


# --- polygons -----------------------------------------------------------------------------------------------


def uniform_axes(lower, upper, step):
    axes = []
    for lo, hi in zip(lower, upper):
        n = max(2, math.ceil((hi - lo) / step))
        axes.append([lo + (i - 0.5) * step for i in range(n + 2)])
    return axes


CORNERS = [(a, b, c) for a in (0, 1) for b in (0, 1) for c in (0, 1)]
EDGES = [(p, q) for p in range(8) for q in range(p + 1, 8)
         if sum(abs(CORNERS[p][m] - CORNERS[q][m]) for m in range(3)) == 1]
FACES = []
for axis in range(3):
    for side in (0, 1):
        ring = []
        for b, c in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = [0, 0, 0]
            corner[axis], corner[(axis + 1) % 3], corner[(axis + 2) % 3] = side, b, c
            ring.append(CORNERS.index(tuple(corner)))
        FACES.append(ring)


def sheets(inside):
    """The crossed edges of a cell, grouped by the surface sheets that cut it.

    If the inside corners of a face are diagonally opposite, they are kept separate, consistently in both adjacent cells.
    """
    group = {e: e for e in EDGES if inside[e[0]] != inside[e[1]]}

    def top(e):
        while group[e] != e:
            e = group[e]
        return e

    for ring in FACES:
        crossed = [(min(ring[i - 1], ring[i]), max(ring[i - 1], ring[i])) for i in range(4)]
        links = [(crossed[i], crossed[(i + 1) % 4]) for i in range(4) if inside[ring[i]]]
        present = [e for e in crossed if e in group]
        if len(present) == 2:
            links = [tuple(present)]
        for e, f in links:
            if e in group and f in group:
                group[top(e)] = top(f)
    return {e: top(e) for e in group}


def surface_nets(field, axes):
    """Vertices near the surface and outward quads [vertex index]*4 of a field on a rectilinear grid.

    Each cell has a vertex for every surface sheet in it (dual marching cubes), so that thin parts stay closed.
    """
    nx, ny, nz = (len(a) for a in axes)
    value = [field(x, y, z) for x in axes[0] for y in axes[1] for z in axes[2]]
    at = lambda i, j, k: (i * ny + j) * nz + k
    vertices, cell, known = [], {}, {}
    for i in range(nx - 1):
        for j in range(ny - 1):
            for k in range(nz - 1):
                d = [value[at(i + a, j + b, k + c)] for a, b, c in CORNERS]
                if min(d) >= 0 or max(d) < 0:
                    continue
                inside = tuple(v < 0 for v in d)
                if inside not in known:
                    known[inside] = sheets(inside)
                of_edge = {}
                for root in sorted(set(known[inside].values())):
                    total, count = [0.0, 0.0, 0.0], 0
                    for (p, q), own in known[inside].items():
                        if own != root:
                            continue
                        s = d[p] / (d[p] - d[q])
                        for m, start in enumerate((i, j, k)):
                            a, b = axes[m][start + CORNERS[p][m]], axes[m][start + CORNERS[q][m]]
                            total[m] += a + s * (b - a)
                        count += 1
                        of_edge[p, q] = len(vertices)
                    vertices.append([t / count for t in total])
                cell[i, j, k] = of_edge
    quads = []
    step = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    for i in range(nx - 1):
        for j in range(ny - 1):
            for k in range(nz - 1):
                inside = value[at(i, j, k)] < 0
                for m in range(3):
                    di, dj, dk = step[m]
                    if inside == (value[at(i + di, j + dj, k + dk)] < 0):
                        continue
                    u, v = step[(m + 1) % 3], step[(m + 2) % 3]
                    quad = []
                    for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        here = [a * u[n] + b * v[n] for n in range(3)]
                        there = [here[n] + step[m][n] for n in range(3)]
                        edge = (CORNERS.index(tuple(here)), CORNERS.index(tuple(there)))
                        quad.append(cell[i - here[0], j - here[1], k - here[2]][edge])
                    quads.append(quad if inside else quad[::-1])
    return vertices, quads


def project(field, vertices, steps=2, most=0.01):
    """Moves vertices onto the surface along the gradient."""
    e = 1e-5
    for v in vertices:
        for _ in range(steps):
            x, y, z = v
            d = field(x, y, z)
            g = [field(x + e, y, z) - field(x - e, y, z), field(x, y + e, z) - field(x, y - e, z),
                 field(x, y, z + e) - field(x, y, z - e)]
            g2 = sum(c * c for c in g) / (4 * e * e)
            if g2 < 0.04:
                break
            move = max(-most, min(most, d)) / g2 / (2 * e)
            for m in range(3):
                v[m] -= move * g[m]


def relax(vertices, quads, weight=0.5):
    """Laplacian smoothing: moves each vertex towards the mean of its neighbours."""
    neighbours = [set() for _ in vertices]
    for quad in quads:
        for a, b in zip(quad, quad[1:] + quad[:1]):
            neighbours[a].add(b)
            neighbours[b].add(a)
    old = [tuple(v) for v in vertices]
    for v, around in zip(vertices, neighbours):
        for m in range(3):
            v[m] += weight * (sum(old[n][m] for n in around) / len(around) - v[m])


def triangulated(vertices, quads):
    """Triangles of the quads, each cut along its shorter diagonal."""
    dist2 = lambda a, b: sum((vertices[a][m] - vertices[b][m]) ** 2 for m in range(3))
    triangles = []
    for a, b, c, d in quads:
        if dist2(a, c) <= dist2(b, d):
            triangles += [(a, b, c), (a, c, d)]
        else:
            triangles += [(a, b, d), (b, c, d)]
    return triangles


def mesh_of(field, axes, rounds=4):
    vertices, quads = surface_nets(field, axes)
    for _ in range(rounds):
        relax(vertices, quads)
        project(field, vertices)
    # Rounds to the floats that are stored, so that these are checked and measured.
    vertices = [tuple(struct.unpack("<3f", struct.pack("<3f", *v))) for v in vertices]
    return vertices, triangulated(vertices, quads)


def mesh_with(field, lower, upper, triangles, tolerance=0.03):
    """Mesh on a uniform grid; the step is chosen such that the number of triangles is about `triangles`."""
    step = max(u - l for l, u in zip(lower, upper)) / 25
    for _ in range(8):
        axes = uniform_axes(lower, upper, step)
        count = 2 * len(surface_nets(field, axes)[1])
        if abs(count / triangles - 1) < tolerance:
            break
        step *= math.sqrt(count / triangles)
    return mesh_of(field, axes)


# --- measures -----------------------------------------------------------------------------------------------


def volume(vertices, triangles):
    total = 0.0
    for a, b, c in triangles:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = vertices[a], vertices[b], vertices[c]
        total += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)
    return total / 6


def centroid(vertices, triangles):
    """Centroid of the enclosed volume."""
    total, whole = [0.0, 0.0, 0.0], 0.0
    for a, b, c in triangles:
        p, q, r = vertices[a], vertices[b], vertices[c]
        v = (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2])
             + p[2] * (q[0] * r[1] - q[1] * r[0]))
        whole += v
        for m in range(3):
            total[m] += v * (p[m] + q[m] + r[m]) / 4
    return [t / whole for t in total]


def hull_volume(points):
    """Lower bound of the volume of the convex hull, from the extreme points in many directions."""
    sub = lambda a, b: (a[0] - b[0], a[1] - b[1], a[2] - b[2])
    cross = lambda a, b: (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
    dot = lambda a, b: a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
    count, golden, far = 400, math.pi * (3 - math.sqrt(5)), set()
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = math.sqrt(1 - z * z)
        n = (r * math.cos(golden * i), r * math.sin(golden * i), z)
        far.add(max(points, key=lambda p: dot(n, p)))
    points = sorted(far)
    random.Random(1).shuffle(points)

    def face(a, b, c):
        n = cross(sub(points[b], points[a]), sub(points[c], points[a]))
        length = math.sqrt(dot(n, n)) or 1.0
        n = tuple(v / length for v in n)
        return (a, b, c), n, dot(n, points[a])

    # Starts with four points that are far from coplanar, then adds one point at a time.
    p0 = min(range(len(points)), key=lambda i: points[i])
    p1 = max(range(len(points)), key=lambda i: dot(sub(points[i], points[p0]), sub(points[i], points[p0])))
    line = sub(points[p1], points[p0])
    area = lambda i: cross(line, sub(points[i], points[p0]))
    p2 = max(range(len(points)), key=lambda i: dot(area(i), area(i)))
    n = area(p2)
    p3 = max(range(len(points)), key=lambda i: abs(dot(n, sub(points[i], points[p0]))))
    if dot(n, sub(points[p3], points[p0])) > 0:
        p1, p2 = p2, p1
    faces = [face(p0, p1, p2), face(p0, p3, p1), face(p1, p3, p2), face(p2, p3, p0)]
    for i, p in enumerate(points):
        seen = [f for f in faces if dot(f[1], p) > f[2] + 1e-7]
        if not seen:
            continue
        edges = {(f[0][k], f[0][(k + 1) % 3]) for f in seen for k in range(3)}
        faces = [f for f in faces if dot(f[1], p) <= f[2] + 1e-7]
        faces += [face(a, b, i) for a, b in edges if (b, a) not in edges]
    return volume(points, [f[0] for f in faces])


def assert_closed(name, vertices, triangles):
    """Asserts that every edge has exactly two triangles with opposite directions, and that the volume is positive."""
    edges = {}
    for t in triangles:
        assert len(set(t)) == 3, f"{name}: degenerate triangle"
        for k in range(3):
            edge = (t[k], t[(k + 1) % 3])
            assert edge not in edges, f"{name}: an edge has two triangles on the same side"
            edges[edge] = True
    assert all((b, a) in edges for a, b in edges), f"{name}: open edge"
    assert len(set(vertices)) == len(vertices), f"{name}: duplicate vertices"
    assert volume(vertices, triangles) > 0, f"{name}: negative volume"


def write_stl(path, name, vertices, triangles):
    with open(path, "wb") as out:
        out.write(("Abstand " + name + ", metres").encode().ljust(80, b" "))
        out.write(struct.pack("<I", len(triangles)))
        for t in triangles:
            p, q, r = (vertices[i] for i in t)
            u, v = [q[m] - p[m] for m in range(3)], [r[m] - p[m] for m in range(3)]
            n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            length = math.sqrt(sum(c * c for c in n)) or 1.0
            out.write(struct.pack("<12fH", *(c / length for c in n), *p, *q, *r, 0))
