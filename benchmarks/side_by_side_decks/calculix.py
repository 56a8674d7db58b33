"""Decks for CalculiX: a cantilever of B31 beams, and a block of hexahedra with
fibers that are tied to them."""

import math


def write(path, lines):
    with open(path, "w") as file:
        for line in lines:
            file.write(line if isinstance(line, str)
                       else ", ".join(f"{item}" for item in line))
            file.write("\n")


def cantilever(path, n, length, radius, modulus, nu, force):
    """A square section of the same bending stiffness: B31 becomes a brick, and
    has no circle."""
    edge = (3 * math.pi) ** 0.25 * radius
    write(path, [
        "*NODE, NSET=ALL",
        *((i + 1, length * i / n, 0, 0) for i in range(n + 1)),
        "*NSET, NSET=TIP", (n + 1,),
        "*ELEMENT, TYPE=B31, ELSET=BEAM",
        *((i + 1, i + 1, i + 2) for i in range(n)),
        "*MATERIAL, NAME=FIBER", "*ELASTIC", (modulus, nu),
        "*BEAM SECTION, ELSET=BEAM, MATERIAL=FIBER, SECTION=RECT",
        (edge, edge), (0, 0, 1),
        "*BOUNDARY", (1, 1, 6),
        "*STEP, NLGEOM, INC=1000", "*STATIC", (0.1, 1),
        "*CLOAD", (n + 1, 2, force),
        "*NODE PRINT, NSET=TIP, FREQUENCY=1000", "U",
        "*END STEP"])


def block(path, n, n_fiber_elements, kind):
    """Block of 40 x 8 x 8 in 5 n x n x n hexahedra, 4 x 4 fibers, pulled by 0.1 %.

    The kind of fiber elements is T3D2 (CalculiX makes bricks of them) or SPRINGA,
    springs along their axes, which cost less."""
    size, cells = (40., 8., 8.), (5 * n, n, n)
    h = [s / c for s, c in zip(size, cells)]

    def node(i, j, k):
        return 1 + i + (cells[0] + 1) * (j + (n + 1) * k)

    def box(*numbers):
        """Indices of a box of nodes or cells, the first one fastest."""
        nx, ny, nz = numbers
        return [(i, j, k) for k in range(nz) for j in range(ny)
                for i in range(nx)]

    corners = box(2, 2, 2)
    last = node(5 * n, n, n)
    length = 30. / n_fiber_elements
    # The ends of the fibers are at x = 5 and 35; on an edge between hexahedra,
    # where they would lie in finer meshes, no equation is unique.
    points = [(5 + m * length, 1.015 + 2 * (f // 4), 1.015 + 2 * (f % 4))
              for f in range(16) for m in range(n_fiber_elements + 1)]

    def hexahedron(i, j, k):
        below, above = ([node(i, j, k + m), node(i + 1, j, k + m),
                         node(i + 1, j + 1, k + m), node(i, j + 1, k + m)]
                        for m in (0, 1))
        return below + above

    def ties():
        for number, point in enumerate(points, last + 1):
            cell = [min(int(p / s), c - 1) for p, s, c in zip(point, h, cells)]
            xi = [p / s - c for p, s, c in zip(point, h, cell)]
            terms = []
            for corner in corners:
                weight = math.prod(x if c else 1 - x for x, c in zip(xi, corner))
                if weight > 1e-12:
                    terms.append((node(*(a + b for a, b in zip(cell, corner))),
                                  -weight))
            for component in (1, 2, 3):
                equation = [(number, component, 1)] + [
                    (at, component, weight) for at, weight in terms]
                yield (len(equation),)
                for begin in range(0, len(equation), 4):
                    yield sum(equation[begin:begin + 4], ())

    n_cells = math.prod(cells)
    area = math.pi * 0.2**2
    section = (["*SPRING, ELSET=FIBERS", "", (1e5 * area / length,)]
               if kind == "SPRINGA" else
               ["*MATERIAL, NAME=FIBER", "*ELASTIC", (1e5, 0),
                "*SOLID SECTION, ELSET=FIBERS, MATERIAL=FIBER", (area,)])
    write(path, [
        "*NODE",
        *((node(*at), *(a * s for a, s in zip(at, h)))
          for at in box(*(c + 1 for c in cells))),
        *((number, *point) for number, point in enumerate(points, last + 1)),
        "*ELEMENT, TYPE=C3D8, ELSET=MATRIX",
        *((number, *hexahedron(*cell))
          for number, cell in enumerate(box(*cells), 1)),
        f"*ELEMENT, TYPE={kind}, ELSET=FIBERS",
        *((n_cells + 1 + f * n_fiber_elements + m, first, first + 1)
          for f in range(16) for m in range(n_fiber_elements)
          for first in [last + 1 + f * (n_fiber_elements + 1) + m]),
        "*MATERIAL, NAME=MATRIX", "*ELASTIC", (100, 0.3),
        "*SOLID SECTION, ELSET=MATRIX, MATERIAL=MATRIX", *section,
        "*EQUATION", *ties(),
        "*NSET, NSET=LEFT", *((node(0, j, k),) for _, j, k in
                              box(1, n + 1, n + 1)),
        "*NSET, NSET=RIGHT", *((node(5 * n, j, k),) for _, j, k in
                               box(1, n + 1, n + 1)),
        # A corner and the end of an edge keep the block from floating.
        "*BOUNDARY", ("LEFT", 1, 1), (node(0, 0, 0), 2, 3),
        (node(0, n, 0), 3, 3),
        "*STEP", "*STATIC", "*BOUNDARY", ("RIGHT", 1, 1, 0.04),
        "*NODE PRINT, NSET=RIGHT, TOTALS=ONLY", "RF",
        "*END STEP"])
