#!/usr/bin/env python3
"""What Weft's code is made of [kB]: sizes.py BUILD, the folder of a build whose libraries are static. By the names of its symbols: a
part has its kernels for all kinds of machines."""
import collections
import re
import subprocess
import sys

PARTS = (  # the first that a name matches
    ("all for C", r"^weft_|weft::c::|to_c<|to_weft<"),
    ("recordings and replay", r"Recorder|Recording|Replay|replay|record_"),
    ("saves and cooked files", r"\bsave\b|restore|SaveWriter|SaveReader|CookedFile|cooked_file|save_|load_"),
    ("descriptions and drawing", r"describe|Description|debug_draw|DebugCanvas|draw_"),
    ("OBJ files", r"Obj|obj_"),
    ("fine meshes for drawing", r"DrawnMesh|DrawnSurface|bind_"),
    ("cuts and tears", r"cut_|Cut|tear|recut"),
    ("bodies", r"Bod(y|ies)|bodies"),
    ("impact zones", r"ImpactZone|impact_zone|CollisionCluster|linear_program|LinearProgram|solve_zone"),
    ("finite elements", r"Triangle(Element|Matri|System|State|Pass|Row)|[Hh]inge|[Ee]lement(s|Row|_row)|Membrane"),
    ("multigrid", r"[Mm]ulti(grid|level)|[Cc]oarse|Galerkin|galerkin|ComponentSolver|Effort|Interpolation|coarsen"),
    ("fibres", r"[Ff]ibre"),
    ("XPBD", r"[Xx]pbd|Displacement|colour"),
    ("Jacobi, Chebyshev, conjugate gradients", r"Jacobi|Chebyshev|ConjugateGradient|MeanMotion|mean_motion|LinearSolver"),
    ("triangles that meet", r"Feature|Pair|Crossing|[Cc]rossings|Tangle|Untangl|untangl|Settle|settle|FlatRest|Truncat|Incidence|Contour|SideVote"),
    ("avoidance", r"Self(Collision|Contact|Respon)|HashGrid|SweepGrid|PairFound|search_|RestNeighbour|Cloud"),
    ("shapes as triangles, hulls, fields", r"Held|TriangleTree|Hull|[Hh]eight|[Oo]utsideCell|MovingShape|whole_triangle|WholeTriangle|Core|Sides"),
    ("colliders: spheres to boxes", r"collide|Moving(Box|Sphere|Plane|Capsule|Tapered)|nearest_of|ColliderContact|Collider|Nearest"),
    ("air", r"[Ww]ind|[Gg]ust|Air|air"),
    ("cooking", r"cook|Cook|bending|Bending|Topology|[Gg]eodesic|repair|[Oo]rdering|check_mesh|weld"),
    ("springs", r"[Ss]pring|Stencil|Diagonal|StepEquation|Coupling|coupling"),
)


def symbols(library):
    """(size, name) of each piece of code or constant; of aliases one."""
    listed = subprocess.run(["nm", "-SC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    for file in listed.split("\n\n"):
        places = {}
        for place, size, kind, name in re.findall(r"^(\w+) (\w+) ([tTrRWVu]) (.*)$", file, re.M):
            places.setdefault((place, size, name.split("(")[0]), (int(size, 16), name))
        yield from places.values()


def main(build):
    parts, targets, seen = collections.Counter(), collections.Counter(), set()
    for room in ("cloth", "collision", "engine"):
        for size, name in symbols(f"{build}/{room}/libweft_{room}.a"):
            if name in seen and "anonymous" not in name:
                continue  # a template's instance that several files have is linked once
            seen.add(name)
            target = re.search(r"weft::N_(\w+)::", name)
            targets["kernels: " + target[1] if target else "no kernels"] += size
            parts[next((part for part, pattern in PARTS if re.search(pattern, name)), "the rest")] += size
            if len(sys.argv) > 2 and not any(re.search(pattern, name) for _, pattern in PARTS):
                print(size, name[:140])
    for counted in (targets, parts):
        for part, size in counted.most_common():
            print(f"{size / 1000:8.0f}  {part}")
        print(f"{sum(counted.values()) / 1000:8.0f}  in all\n")


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1])
