"""GJK in the plane on one page, as the slides tell it (Catto 2010), in floats that it believes.

Line for line as textbook.hpp, and a test compares their answers. Points are complex: x + y i.
As a program it answers cases, a line of JSON each: `gjkscope judge --program` asks like that.
"""
import json, math, sys
from dataclasses import dataclass, replace

def dot(a, b): return a.real * b.real + a.imag * b.imag
def cross(a, b): return a.real * b.imag - a.imag * b.real
@dataclass
class Input:
    x: list; y: list
    start_x: int = 0; start_y: int = 0  # the vertices of X and Y that make the first simplex
@dataclass
class SimplexVertex:  # of Z = Y - X, the set of all differences y - x:
    index_x: int; index_y: int  # the vertices of X and Y that make it,
    w: complex  # their difference,
    weight: float = 1  # and its share in P, the simplex's point closest to the origin O.
@dataclass
class Output:
    simplex: list  # a triangle where X and Y overlap
    iterations: int
    p: complex = 0; x: complex = 0; y: complex = 0  # P, and the closest points of X and Y
    distance: float = 0
def support(shape, d):
    best = 0
    for i in range(1, len(shape)):
        if dot(d, shape[i]) > dot(d, shape[best]): best = i
    return best  # the first vertex that lies farthest along d

def closest(s):
    """The vertices that P needs. ab is A's coordinate in AB, a that in ABC, but for a divisor."""
    def edge(i, k): return dot(s[k].w, s[k].w - s[i].w)
    def keep(kept, u, v=0, w=0):
        parts = zip(kept, (u, v, w))
        return [replace(vertex, weight=part / (u + v + w)) for vertex, part in parts]
    if len(s) == 1: return s
    ab, ba = edge(0, 1), edge(1, 0)
    if len(s) == 2 and ab <= 0: return keep([s[1]], 1)
    if len(s) == 2 and ba <= 0: return keep([s[0]], 1)
    if len(s) == 2: return keep(s, ab, ba)
    bc, cb, ca, ac = edge(1, 2), edge(2, 1), edge(2, 0), edge(0, 2)
    abc = cross(s[1].w - s[0].w, s[2].w - s[0].w)  # twice the signed area
    def part(i, k): return abc * cross(s[i].w, s[k].w)
    a, b, c = part(1, 2), part(2, 0), part(0, 1)
    if ba <= 0 and ca <= 0: return keep([s[0]], 1)
    if ab <= 0 and cb <= 0: return keep([s[1]], 1)
    if bc <= 0 and ac <= 0: return keep([s[2]], 1)
    if ab > 0 and ba > 0 and c <= 0: return keep([s[0], s[1]], ab, ba)
    if bc > 0 and cb > 0 and a <= 0: return keep([s[1], s[2]], bc, cb)
    if ca > 0 and ac > 0 and b <= 0: return keep([s[0], s[2]], ac, ca)
    return keep(s, a, b, c)

def gjk(data, cap=64):
    s = [SimplexVertex(data.start_x, data.start_y, data.y[data.start_y] - data.x[data.start_x])]
    for iterations in range(1, cap + 1):
        s = closest(s)
        out = Output(s, iterations)
        for v in s: out.p += v.weight * v.w
        for v in s: out.x += v.weight * data.x[v.index_x]
        for v in s: out.y += v.weight * data.y[v.index_y]
        if len(s) == 3: return out  # O is inside: the shapes overlap
        out.distance = math.sqrt(dot(out.p, out.p))
        e = s[-1].w - s[0].w
        d = -s[0].w if len(s) == 1 else complex(e.imag, -e.real)  # normal to the edge
        if dot(d, s[0].w) > 0: d = -d  # and towards O
        far_x, far_y = support(data.x, -d), support(data.y, d)
        for v in s:
            if v.index_x == far_x and v.index_y == far_y: return out  # nothing is farther along d
        if d == 0 or iterations == cap: return out  # O lies in a vertex; or it does not end
        s.append(SimplexVertex(far_x, far_y, data.y[far_y] - data.x[far_x]))

if __name__ == "__main__":
    for line in sys.stdin:
        case = json.loads(line)
        out = gjk(Input(*([complex(*point) for point in case[key]] for key in "ab")))
        a, b = ([point.real, point.imag] for point in (out.x, out.y))
        print(json.dumps({"distance": out.distance, "overlap": len(out.simplex) == 3, "a": a, "b": b,
                          "iterations": out.iterations}), flush=True)
