#!/usr/bin/env python3
"""What Weft's code is made of [kB]: sizes.py BUILD, the folder of a build whose libraries are static. By the names of its symbols: a
part has its kernels for all kinds of machines."""
import collections
import re
import subprocess
import sys

PARTS = (  # the first that a name matches
    ("all for C", r"^weft_|weft::c::"),
    ("recordings and replay", r"Record|Replay|replay|record_"),
    ("saves and cooked files", r"\b(save|restore)(_|\b)|[Ss]aved|CookedFile|read_(head|levels)|load_"),
    ("descriptions and drawing", r"[Dd]escri(be|ption)|[Dd]ebug_?[Dd]raw|DebugCanvas|Drawing"),
    ("profile and trace", r"Profile|Trace|trace"),
    ("OBJ files", r"\bObj|obj(_|\b)"),
    ("fine meshes", r"Drawn|drawn"),
    ("cuts and tears", r"\bcut_|Cut|tear|[Rr]ecut|edges_along|go_on_from"),
    ("bodies", r"\bBod(y|ies)|_bod(y|ies)\b|StepBodies|FreeCloth"),
    ("impact zones", r"ImpactZone|impact_zone|CollisionCluster|[Ll]inear_?[Pp]rogram|general_matrix|gebp|ldlt"),
    ("finite elements", r"Triangle(Element|Matri|System|State|Pass|Row)|[Hh]inge|ElementRow|element_rows|Membrane"),
    ("multigrid", r"[Mm]ulti(grid|level)|[Cc]oarse|galerkin|ComponentSolver|Passes|FreePieces|Interpolation"),
    ("fibres", r"[Ff]ibre"),
    ("XPBD", r"[Xx]pbd|Displacement|[Cc]olour(ing|ed)"),
    ("Jacobi, Chebyshev, conjugate gradients", r"Jacobi|Chebyshev|ConjugateGradient|[Mm]ean_?[Mm]otion|LinearSolver"),
    ("triangles that meet", r"Feature|Pair|[Cc]rossing|[Tt]angle[ds]?\b|[Uu]ntangl|[Ss]ettle|FlatRest|[Tt]runcat|Incidence|Contour|SideVote|ContactMesh|CommonMotion"),
    ("avoidance", r"Self(Collision|Contact|Respon)|HashGrid|SweepGrid|RestNeighbour|Patches"),
    ("shapes of triangles, hulls, fields", r"Held|TriangleTree|[Hh]ull|OutsideCell|MovingShapes|[Ww]hole_?[Tt]riangle|Cores?\b|TurningBox"),
    ("spheres, capsules, planes, boxes", r"collide|Moving(Box|Sphere|Plane|Capsule|Tapered)|nearest_of|Collider|NearSurfaces|weft::moving"),
    ("air", r"[Ww]ind\b|[Gg]ust|Air|air_|Aerodynamic"),
    ("cooking", r"\bcook|Cook|[Bb]ending|[Tt]opology|[Gg]eodesic|repair|[Oo]rdering|check_mesh|weld|make_sheet|joins_with"),
    ("springs", r"[Ss]pring|Stencil|Diagonal|StepEquation|[Cc]oupling"),
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
    for counted in (targets, parts):
        for part, size in counted.most_common():
            print(f"{size / 1000:8.0f}  {part}")
        print(f"{sum(counted.values()) / 1000:8.0f}  in all\n")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
