#!/usr/bin/env python3
# assets/maker/fit.py: fits the ellipsoids that wrap the humanoid to its muscled skin; prints their rows for muscles.py.
"""Usage: assets/maker/fit.py SINEW [ROUNDS]     SINEW: the program; ROUNDS of least squares, 12 if not given

Starts at the rows of humanoid/muscles.py. The targets are the refined vertices of humanoid.rig.json in the bind pose,
where F = T is wanted; head, hands and feet stay outside. Damped Gauss-Newton on centres and logarithms of radii; being
far from the start costs as well, so that muscles that matter little stay. Standard library only.
"""
import math
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
sys.dont_write_bytecode = True

from maker import vec  # noqa: E402
from maker.humanoid import body, muscles  # noqa: E402
from maker.humanoid.skeleton import NAMES, ORIGIN, PARENT  # noqa: E402
from maker.names import mirror_name  # noqa: E402

ISO, REACH, DEPTH = 0.25, 1.4142135, 3
LOOSE = (0.03, 0.03, 0.03, 0.4, 0.4, 0.4)  # how far a parameter goes as easily as another: metres, logarithms
HOLD, SMALLEST, LARGEST = 0.02, 0.022, 0.22
KEPT = {"pectoralis", "axilla", "nape"}  # larger ones would fit better, and tear or step when arm and head move
ROWS = muscles.WRAP


def refined(program, mesh):
    """[(place on the muscled skin, {control vertex: share})] of the left half that is to be wrapped."""
    assets = pathlib.Path(__file__).resolve().parents[1]
    places = []
    with tempfile.TemporaryDirectory() as folder:
        out, rig = pathlib.Path(folder) / "skin.obj", pathlib.Path(folder) / "rig.json"
        rig.write_text(muscles.swell_rig(mesh).replace('"humanoid.glb"', '"%s"' % (assets / "humanoid.glb")))
        for options in ([assets / "humanoid.glb", "--patch", "flat"], [rig]):
            command = [program, "smooth", *options, "--depth", str(DEPTH), "-o", out]
            subprocess.run(command, check=True, capture_output=True)
            lines = (line.split() for line in out.read_text().splitlines() if line.startswith("v "))
            places.append([tuple(float(c) for c in line[1:4]) for line in lines])
    shares = {}
    for triangle in mesh.triangles:
        corners = [c[0] for c in triangle]
        for i in range(DEPTH + 1):
            for j in range(DEPTH + 1 - i):
                part = [i / DEPTH, j / DEPTH, (DEPTH - i - j) / DEPTH]
                p = [sum(s * mesh.positions[v][k] for s, v in zip(part, corners)) for k in range(3)]
                shares[tuple(round(c, 4) + 0.0 for c in p)] = {v: s for s, v in zip(part, corners) if s > 0.0}
    elbow, along = ORIGIN["forearm.L"], vec.sub(ORIGIN["hand.L"], ORIGIN["forearm.L"])
    wrapped = lambda p: (p[0] > -1e-6 and 0.24 < p[1] < 1.515 and not (  # noqa: E731
        p[0] > 0.30 and vec.dot(vec.sub(p, elbow), along) > 0.60 * vec.dot(along, along)))
    return [(p, shares[tuple(round(c, 4) + 0.0 for c in flat)]) for flat, p in zip(*places) if wrapped(p)]


def felt(mesh, points, row, mirrored):
    """How much of a muscle each point feels: docs/design.md, Territory."""
    bone = row[1]
    bones = muscles.wrap_territory(row) or [bone, PARENT[bone]] + [n for n in NAMES if PARENT[n] == bone]
    bones = {mirror_name(b) for b in bones} if mirrored else set(bones)
    at = []
    for weights in mesh.weights:
        t = min(1.0, sum(w for name, w in weights.items() if name in bones) / 0.5)
        at.append(t * t * (3.0 - 2.0 * t))
    return [sum(at[v] * s for v, s in share.items()) for _, share in points]


class Wrap:
    """The field of all rows at all points, as columns: one per row, both sides of the body in it."""

    def __init__(self, mesh, points):
        self.points = [p for p, _ in points]
        self.felt = [(felt(mesh, points, row, False), felt(mesh, points, row, True)) for row in ROWS]
        self.cliques = [set(link) for link in muscles.WRAP_LINKS]  # no three groups are all linked

    def column(self, i, x):
        turn, strength = ROWS[i][4], ISO / (1.0 - 1.0 / REACH ** 2) ** 2
        reach = [REACH * math.exp(r) for r in x[3:]]
        sides = [(x[0], turn, self.felt[i][0])]
        if x[0] != 0.0:
            sides.append((-x[0], (turn[0], -turn[1], -turn[2], turn[3]), self.felt[i][1]))
        values = [0.0] * len(self.points)
        for cx, q, share in sides:
            back = vec.inverse(q)
            for k, p in enumerate(self.points):
                if share[k] > 0.0:
                    d = vec.rotate(back, (p[0] - cx, p[1] - x[1], p[2] - x[2]))
                    r2 = (d[0] / reach[0]) ** 2 + (d[1] / reach[1]) ** 2 + (d[2] / reach[2]) ** 2
                    if r2 < 1.0:
                        values[k] += share[k] * strength * (1.0 - r2) ** 2
        return values

    def residuals(self, columns):
        """F - T, not more than 0.6, at every point, and the clique that gives it."""
        values, winners = [], []
        for k in range(len(self.points)):
            sums = [sum(c[k] for c, row in zip(columns, ROWS) if row[2] in clique) for clique in self.cliques]
            best = max(range(len(sums)), key=sums.__getitem__)
            values.append(min(sums[best] - ISO, 0.6))
            winners.append(self.cliques[best])
        return values, winners


def solve(a, b):
    """Gauss, without a search for pivots: the matrix is symmetric and positive."""
    m = [line + [v] for line, v in zip(a, b)]
    for i, line in enumerate(m):
        for r in range(len(m)):
            f = m[r][i] / line[i] if r != i else 0.0
            if f != 0.0:
                m[r] = [x - f * y for x, y in zip(m[r], line)]
    return [line[-1] / line[i] for i, line in enumerate(m)]


def fit(wrap, rounds):
    start = [list(row[3]) + [math.log(r) for r in row[5]] for row in ROWS]
    free = [(i, j) for i in range(len(ROWS)) for j in range(6)
            if ROWS[i][0] not in KEPT and (j or start[i][0] != 0.0)]
    held = lambda x: sum(HOLD * ((x[i][j] - start[i][j]) / LOOSE[j]) ** 2 for i, j in free)  # noqa: E731
    x, damping = start, 1.0
    columns = [wrap.column(i, x[i]) for i in range(len(ROWS))]
    residuals, winners = wrap.residuals(columns)
    cost = sum(r * r for r in residuals) + held(x)
    for _ in range(rounds):
        slopes = []
        for i, j in free:
            moved = wrap.column(i, [v + (1e-4 if k == j else 0.0) for k, v in enumerate(x[i])])
            slopes.append({k: (m - c) / 1e-4 for k, (m, c) in enumerate(zip(moved, columns[i]))
                           if m != c and ROWS[i][2] in winners[k]})
        a = [[sum(v * t[k] for k, v in s.items() if k in t) for t in slopes] for s in slopes]
        pull = [HOLD * (x[i][j] - start[i][j]) / LOOSE[j] ** 2 for i, j in free]
        b = [-sum(v * residuals[k] for k, v in s.items()) - p for s, p in zip(slopes, pull)]
        for _ in range(6):
            damped = [[v + ((HOLD + damping) / LOOSE[free[r][1]] ** 2 if c == r else 0.0) for c, v in enumerate(line)]
                      for r, line in enumerate(a)]
            tried = [list(row) for row in x]
            for (i, j), d in zip(free, solve(damped, b)):
                tried[i][j] += max(-0.5 * LOOSE[j], min(0.5 * LOOSE[j], d))
                if j > 2:
                    tried[i][j] = max(math.log(SMALLEST), min(math.log(LARGEST), tried[i][j]))
            other = [wrap.column(i, tried[i]) for i in range(len(ROWS))]
            wanted, won = wrap.residuals(other)
            total = sum(r * r for r in wanted) + held(tried)
            if total < cost:
                x, columns, residuals, winners, cost, damping = tried, other, wanted, won, total, damping * 0.4
                break
            damping *= 3.0
        else:
            break
    rms = math.sqrt(sum(r * r for r in residuals) / len(residuals))
    print("F - T is %.4f in the root mean square" % rms, file=sys.stderr)
    return x


def main():
    mesh = body.build().mirrored()
    wrap = Wrap(mesh, refined(sys.argv[1], mesh))
    for row, x in zip(ROWS, fit(wrap, int(sys.argv[2]) if len(sys.argv) > 2 else 12)):
        numbers = ["(%s)" % ", ".join("%.*f" % (digits, v + 0.0) for v in values) for digits, values in
                   ((3, [round(c, 3) for c in x[:3]]), (4, row[4]), (3, [math.exp(r) for r in x[3:]]))]
        print('    ("%s", "%s", "%s", %s, %s, %s),' % (*row[:3], *numbers))


if __name__ == "__main__":
    if len(sys.argv) < 2:
        raise SystemExit(__doc__)
    main()
