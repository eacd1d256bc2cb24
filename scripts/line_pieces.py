"""How whole the lines of scans are: what is drawn in loose crumbs, and where outlines gape.

python3 scripts/line_pieces.py MODEL... [--tool FILE] [--size WxH] [-- OPTIONS of lineatlas draw]

MODEL is a file, or one that is made here: noise (a body with noise on it), marched (a surface that marching tetrahedra
leave of a field), decimated (the same, its vertices clustered), nets (surface nets of a gyroid in a ball), machine (a scan of a
bracket with flat faces and a bore, with noise), terrain (an open sheet) and figure (a cage of cubes, subdivided by Catmull and
Clark's rule three times). Each is drawn from 6 sides, as paths and as a picture.
  loose  of the drawn length what lies in paths shorter than 12 pixels that come within 2 pixels of no other path, in %
  short  the same of all paths shorter than 12 pixels
  gaps   stretches of the filled silhouette's outline, longer than 2 pixels, with no stroke within 1.5 pixels
  longest  the longest of these, pixels
Needs numpy.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

VIEWS = ["front", "right", "back", "35,25", "215,25", "125,-20"]
SHORT, TOUCH, GAP, REACH = 12.0, 2.0, 2.0, 1.5


def write_obj(path, positions, triangles):
    with open(path, "w", encoding="ascii") as out:
        out.writelines(f"v {x:.6f} {y:.6f} {z:.6f}\n" for x, y, z in positions)
        out.writelines(f"f {a} {b} {c}\n" for a, b, c in np.asarray(triangles) + 1)


def noisy_body():
    """A pear: an octahedron divided six times, each vertex moved by up to a tenth of an edge."""
    positions = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    triangles = np.array([(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)])
    for _ in range(6):
        sides = np.stack([triangles, np.roll(triangles, -1, 1)], -1)
        names, index = np.unique(np.sort(sides.reshape(-1, 2), 1), axis=0, return_inverse=True)
        middle = index.reshape(-1, 3) + len(positions)
        positions = np.concatenate([positions, positions[names].mean(1)])
        corners = [np.stack([triangles[:, k], middle[:, k], middle[:, k - 1]], 1) for k in range(3)]
        triangles = np.concatenate([*corners, middle])
    positions /= np.linalg.norm(positions, axis=1)[:, None]
    edge = np.linalg.norm(positions[triangles[0, 0]] - positions[triangles[0, 1]])
    radius = 1 + 0.3 * positions[:, 1] + 0.08 * np.sin(3 * np.arctan2(positions[:, 0], positions[:, 2])) * (1 - positions[:, 1] ** 2)
    radius += 0.1 * edge * np.random.default_rng(7).uniform(-1, 1, len(radius))
    return positions * radius[:, None], triangles


def field(p):
    """Below 0 inside a figure of blended balls with ripples."""
    balls = [((0, 0, 0), 0.8), ((0, 0.95, 0.15), 0.5), ((0.7, -0.4, 0.3), 0.4), ((-0.7, -0.35, 0.35), 0.4),
             ((0.35, 1.4, 0.1), 0.22), ((-0.35, 1.4, 0.1), 0.22)]
    total = sum(np.exp(-6 * (np.linalg.norm(p - np.array(c), axis=-1) - r)) for c, r in balls)
    return -np.log(total) / 6 + 0.012 * np.sin(22 * p[..., 0]) * np.sin(19 * p[..., 1]) * np.sin(23 * p[..., 2])


def marched(cells=60, field=field, noise=0.0):
    """Marching tetrahedra: six to a cube, welded along edges of the grid; noise: on the field's values, as of a depth camera."""
    axis = np.linspace(-1.7, 2.0, cells + 1)
    grid = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1)
    value = (field(grid) + noise * np.random.default_rng(9).normal(size=grid.shape[:3])).reshape(-1)
    place = grid.reshape(-1, 3)
    n = cells + 1
    corner = np.array([(x * n + y) * n + z for x in (0, 1) for y in (0, 1) for z in (0, 1)])
    tetrahedra = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]
    base = np.arange(n ** 3).reshape(n, n, n)[:-1, :-1, :-1].reshape(-1)
    found = []  # corners of triangles, each between two places of the grid

    def add(*pairs):
        found.append(np.stack([np.sort(np.stack(pair, -1), -1) for pair in pairs], 1))

    for tetrahedron in tetrahedra:
        v = np.stack([base + corner[k] for k in tetrahedron], -1)
        order = np.argsort(value[v] > 0, axis=1, kind="stable")  # inner corners first
        inner = (value[v] <= 0).sum(1)
        v = np.take_along_axis(v, order, 1)
        a, b, c, d = (v[inner == 1].T)
        add((a, b), (a, c), (a, d))
        a, b, c, d = (v[inner == 3].T)
        add((d, a), (d, b), (d, c))
        a, b, c, d = (v[inner == 2].T)
        add((a, c), (a, d), (b, d))
        add((a, c), (b, d), (b, c))
    pairs = np.concatenate(found)
    names, index = np.unique(pairs.reshape(-1, 2), axis=0, return_inverse=True)
    low, high = value[names[:, 0]], value[names[:, 1]]
    share = (low / (low - high))[:, None]
    positions = place[names[:, 0]] * (1 - share) + place[names[:, 1]] * share
    triangles = index.reshape(-1, 3)
    # Orients the triangles towards larger values of the field.
    corners = positions[triangles]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    middle = corners.mean(1)
    step = 1e-4 * normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-12)[:, None]
    inwards = field(middle + step) < field(middle - step)
    triangles[inwards] = triangles[inwards][:, ::-1]
    return positions, triangles


def decimated():
    positions, triangles = marched(90)
    rng = np.random.default_rng(3)
    cell = np.floor(positions / 0.075 + 0.35 * rng.uniform(size=3)).astype(int)
    _, index = np.unique(cell, axis=0, return_inverse=True)
    count = np.bincount(index)
    means = np.stack([np.bincount(index, positions[:, k]) / count for k in range(3)], -1)
    triangles = index[triangles]
    whole = (triangles[:, 0] != triangles[:, 1]) & (triangles[:, 1] != triangles[:, 2]) & (triangles[:, 2] != triangles[:, 0])
    triangles = triangles[whole]
    _, first = np.unique(np.sort(triangles, 1), axis=0, return_index=True)
    return means, triangles[np.sort(first)]


def bracket(p):
    """Below 0 inside a plate with a post on it, both with a bore."""
    x, y, z = p[..., 0], p[..., 1], p[..., 2]

    def box(cx, cy, cz, hx, hy, hz):
        away = np.stack([abs(x - cx) - hx, abs(y - cy) - hy, abs(z - cz) - hz], -1)
        return np.linalg.norm(np.maximum(away, 0), axis=-1) + np.minimum(away.max(-1), 0)

    post = np.maximum(np.hypot(x + 0.5, z) - 0.55, abs(y - 0.2) - 0.9)
    body = np.minimum(np.minimum(box(0, -0.9, 0, 1.35, 0.25, 0.9), post), box(0.5, -0.3, 0, 0.6, 0.5, 0.13))
    return np.maximum(body, -np.minimum(np.hypot(x + 0.5, z) - 0.3, np.hypot(x - 0.95, z - 0.45) - 0.2))


def machine():
    return marched(100, bracket, 0.004)


def nets(cells=70):
    """Surface nets: a vertex per cell that the surface crosses, a quad per edge of the grid that it crosses."""
    axis = np.linspace(-1.25, 1.25, cells + 1)
    p = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), -1)
    s, c = np.sin(4.2 * p), np.cos(4.2 * p)
    value = np.maximum(abs((s * np.roll(c, 1, -1)).sum(-1)) - 0.45, np.linalg.norm(p, axis=-1) - 1.1) + 1e-6
    place, weight = np.zeros((cells,) * 3 + (3,)), np.zeros((cells,) * 3)
    crossings = []
    for k in range(3):
        low, high = np.moveaxis(value, k, 0)[:-1], np.moveaxis(value, k, 0)[1:]
        at = np.nonzero(np.moveaxis((low > 0) != (high > 0), 0, k))
        v0, v1 = value[at], value[tuple(i + (j == k) for j, i in enumerate(at))]
        point = p[at] + (v0 / (v0 - v1))[:, None] * (axis[1] - axis[0]) * np.eye(3)[k]
        inner, u, w = np.stack(at, -1), np.eye(3, dtype=int)[(k + 1) % 3], np.eye(3, dtype=int)[(k + 2) % 3]
        cell = [inner - u - w, inner - w, inner, inner - u]
        for one in cell:
            np.add.at(place, tuple(one.T), point)
            np.add.at(weight, tuple(one.T), 1)
        crossings.append((cell, v0 < 0))
    number = np.cumsum(weight > 0).reshape(weight.shape) - 1
    triangles = []
    for cell, outwards in crossings:
        a, b, c_, d = (number[tuple(one.T)] for one in cell)
        b, d = np.where(outwards, b, d), np.where(outwards, d, b)
        triangles += [np.stack([a, b, c_], -1), np.stack([a, c_, d], -1)]
    return (place[weight > 0] / weight[weight > 0][:, None]), np.concatenate(triangles)


def terrain(cells=150):
    axis = np.linspace(-1.5, 1.5, cells + 1)
    x, z = np.meshgrid(axis, axis, indexing="ij")
    rng, y = np.random.default_rng(5), 0.0
    for k in range(8):
        turn, step = rng.uniform(0, 2 * np.pi), 1.6 ** k
        y = y + 0.4 / 1.9 ** k * np.sin(2.3 * step * (x * np.cos(turn) + z * np.sin(turn)) + rng.uniform(0, 6))
    i = np.arange((cells + 1) ** 2).reshape(cells + 1, cells + 1)
    a, b, c, d = (part.reshape(-1) for part in (i[:-1, :-1], i[:-1, 1:], i[1:, 1:], i[1:, :-1]))
    return np.stack([x, y, z], -1).reshape(-1, 3), np.concatenate([np.stack([a, b, c], -1), np.stack([a, c, d], -1)])


def figure():
    """A dog of cubes, rounded."""
    cubes = {(x, y, z) for x in range(6) for y in (2, 3) for z in (0, 1, 2)}
    cubes |= {(x, y, z) for x in (0, 5) for y in (0, 1) for z in (0, 2)}
    cubes |= {(x, y, 1) for x in (6, 7) for y in (4, 5)} | {(5, 4, 1), (8, 4, 1), (6, 6, 1), (-1, 4, 1), (-1, 3, 1), (-2, 5, 1), (-2, 4, 1)}
    corners, quads = {}, []
    for cube in sorted(cubes):
        for k in range(3):
            for side in (0, 1):
                beside = tuple(c + (j == k) * (2 * side - 1) for j, c in enumerate(cube))
                if beside in cubes:
                    continue
                u, v = np.eye(3, dtype=int)[(k + 1) % 3], np.eye(3, dtype=int)[(k + 2) % 3]
                first = np.array(cube) + side * np.eye(3, dtype=int)[k]
                around = [first, first + u, first + u + v, first + v][::1 if side else -1]
                quads.append([corners.setdefault(tuple(one), len(corners)) for one in around])
    positions, quads = np.array(list(corners), float), np.array(quads)
    for _ in range(3):
        n, faces = len(positions), len(quads)
        middle = positions[quads].mean(1)
        sides = np.stack([quads, np.roll(quads, -1, 1)], -1)
        names, edge = np.unique(np.sort(sides.reshape(-1, 2), 1), axis=0, return_inverse=True)
        edge = edge.reshape(-1, 4)
        beside = np.zeros((len(names), 3))
        np.add.at(beside, edge, middle[:, None])
        of_edges = (positions[names].sum(1) + beside) / 4
        valence = np.bincount(names.reshape(-1), minlength=n)[:, None]
        f, r = np.zeros((n, 3)), np.zeros((n, 3))
        np.add.at(f, quads, middle[:, None])
        np.add.at(r, names, positions[names].mean(1)[:, None])
        moved = (f / valence + 2 * r / valence + (valence - 3) * positions) / valence
        positions = np.concatenate([moved, of_edges, middle])
        center = n + len(names) + np.arange(faces)
        quads = np.concatenate([np.stack([quads[:, k], n + edge[:, k], center, n + edge[:, k - 1]], -1) for k in range(4)])
    return positions, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])


SCANS = {"noise": noisy_body, "marched": marched, "decimated": decimated, "nets": nets, "machine": machine,
         "terrain": terrain, "figure": figure}


def read_bmp(path):
    data = pathlib.Path(path).read_bytes()
    start, width, height = (int.from_bytes(data[k:k + 4], "little", signed=True) for k in (10, 18, 22))
    bits = int.from_bytes(data[28:30], "little")
    stride = (width * bits // 8 + 3) // 4 * 4
    rows = np.frombuffer(data, np.uint8, stride * abs(height), start).reshape(abs(height), stride)
    picture = rows[:, :width * bits // 8].reshape(abs(height), width, bits // 8)[..., 0]
    return picture[::-1] if height > 0 else picture


def near(mask, radius):
    """Pixels of which one of the mask is within the radius."""
    reach = int(np.ceil(radius))
    padded = np.pad(mask, reach)
    result = np.zeros_like(mask)
    height, width = mask.shape
    for dy in range(-reach, reach + 1):
        for dx in range(-reach, reach + 1):
            if dy * dy + dx * dx <= radius * radius:
                result |= padded[reach + dy:reach + dy + height, reach + dx:reach + dx + width]
    return result


def stretches(mask):
    """Of connected pixels (by corners too) how far each heap reaches."""
    left = set(zip(*np.nonzero(mask)))
    while left:
        heap = [left.pop()]
        for y, x in heap:
            for other in [(y + dy, x + dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1)]:
                if other in left:
                    left.remove(other)
                    heap.append(other)
        places = np.array(heap)
        yield float(np.linalg.norm(np.ptp(places, axis=0) + 1)), tuple(places[0][::-1])


def gaps_of(filled, drawn):
    """Where the outline of the filled silhouette has no stroke beside it."""
    inside = read_bmp(filled) < 128
    edge = np.zeros_like(inside)
    edge[1:-1, 1:-1] = inside[1:-1, 1:-1] & ~(inside[:-2, 1:-1] & inside[2:, 1:-1] & inside[1:-1, :-2] & inside[1:-1, 2:])
    bare = edge & ~near(read_bmp(drawn) < 160, REACH)
    return [gap for gap in stretches(bare) if gap[0] > GAP * np.sqrt(2)]


def short_paths(drawing):
    """Drawn length, that of short paths, and of those of them that touch nothing."""
    points, owner, lengths = [], [], []
    for path in json.loads(pathlib.Path(drawing).read_text())["paths"]:
        p = np.array(path["points"])
        if path["closed"]:
            p = np.concatenate([p, p[:1]])
        step = np.linalg.norm(np.diff(p, axis=0), axis=1)
        at = np.concatenate([[0], np.cumsum(step)])
        t = np.linspace(0, at[-1], max(int(at[-1]) + 1, 2))
        points.append(np.stack([np.interp(t, at, p[:, 0]), np.interp(t, at, p[:, 1])], -1))
        owner.append(np.full(len(t), len(lengths)))
        lengths.append(at[-1])
    if not lengths:
        return 0.0, 0.0, 0.0
    all_points, owners, lengths = np.concatenate(points), np.concatenate(owner), np.array(lengths)
    short, loose = 0.0, 0.0
    for i in np.nonzero(lengths < SHORT)[0]:
        short += lengths[i]
        box = points[i].min(0) - TOUCH, points[i].max(0) + TOUCH
        others = all_points[((all_points >= box[0]) & (all_points <= box[1])).all(1) & (owners != i)]
        away = np.linalg.norm(points[i][:, None] - others[None], axis=-1) if len(others) else np.array([np.inf])
        if away.min() > TOUCH:
            loose += lengths[i]
    return float(lengths.sum()), short, loose


def main():
    words = sys.argv[1:]
    cut = words.index("--") if "--" in words else len(words)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("model", nargs="+")
    parser.add_argument("--tool", default=str(pathlib.Path(__file__).resolve().parent.parent / "build/release/lineatlas"))
    parser.add_argument("--size", default="1024x768")
    parser.add_argument("--keep", help="folder for the drawings")
    args = parser.parse_args(words[:cut])
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(args.keep or scratch)
        folder.mkdir(parents=True, exist_ok=True)
        print(f"{'model':<12} {'length':>9} {'short':>7} {'loose':>7} {'gaps':>5} {'longest':>8}")
        for model in args.model:
            file = model
            if model in SCANS:
                file = str(folder / (model + ".obj"))
                write_obj(file, *SCANS[model]())
            total, gaps = np.zeros(3), []
            for view, side in enumerate(VIEWS):
                stem = str(folder / f"{pathlib.Path(model).stem}{view}")

                def draw(output, *options):
                    command = [args.tool, "draw", file, "-o", output, f"--size={args.size}", f"--view={side}", *options]
                    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)

                draw(stem + ".json", *words[cut + 1:])
                draw(stem + ".bmp", *words[cut + 1:])
                draw(stem + "f.bmp", "--lines=file", "--fill=flat", "--fill-color=black")
                total += short_paths(stem + ".json")
                gaps += [(length, at, side) for length, at in gaps_of(stem + "f.bmp", stem + ".bmp")]
            longest = max(gaps, default=(0,))
            where = f"  at {longest[1]} of {longest[2]}" if gaps else ""
            print(f"{pathlib.Path(model).stem:<12} {total[0]:9.0f} {100 * total[1] / total[0]:6.2f}% {100 * total[2] / total[0]:6.2f}%"
                  f" {len(gaps):5d} {longest[0]:8.1f}{where}", flush=True)


if __name__ == "__main__":
    main()
