#!/usr/bin/env python3
"""Waves a flag and plots its energy: flag.py LIBRARY [PICTURE.svg].

LIBRARY is Weft's shared library (built with -DBUILD_SHARED_LIBS=ON). Nothing but Python's own ctypes is needed: the structs
below are those of weft/weft_c.h, field by field.
"""
import ctypes as c
import sys


def struct(name, *fields):
    return type(name, (c.Structure,), {"_fields_": list(fields)})


Vec3 = struct("Vec3", ("x", c.c_float), ("y", c.c_float), ("z", c.c_float))
Vec4 = struct("Vec4", ("x", c.c_float), ("y", c.c_float), ("z", c.c_float), ("w", c.c_float))
Id = struct("Id", ("index", c.c_uint32), ("generation", c.c_uint32))
Source = struct("Source", ("kind", c.c_int32), ("position", Vec3), ("velocity", Vec3), ("radius", c.c_float))
Shelter = struct("Shelter", ("kind", c.c_int32), ("position", Vec3), ("rotation", Vec4), ("half_extents", Vec3),
                 ("radius", c.c_float), ("border", c.c_float), ("exposure", c.c_float))
Wind = struct("Wind", ("velocity", Vec3), ("gust", c.c_float), ("gust_length", c.c_float), ("air_density", c.c_float),
              ("drag", c.c_float), ("lift", c.c_float), ("seed", c.c_uint32), ("sources", 8 * Source),
              ("shelters", 8 * Shelter))
Executor = struct("Executor", ("run", c.c_void_p), ("user", c.c_void_p), ("width", c.c_int32))
WorldSettings = struct("WorldSettings", ("struct_size", c.c_uint32), ("gravity", Vec3), ("wind", Wind),
                       ("max_speed", c.c_float), ("substeps", c.c_int32), ("contact_reports", c.c_int32),
                       ("threads", c.c_int32), ("budget", c.c_float), ("executor", Executor))
SheetSettings = struct("SheetSettings", ("struct_size", c.c_uint32), ("rows", c.c_uint32), ("columns", c.c_uint32),
                       ("origin", Vec3), ("u", Vec3), ("v", Vec3))
ClothView = struct("ClothView", ("struct_size", c.c_uint32), ("particles", c.c_uint32), ("vertices", c.c_uint32),
                   ("triangle_count", c.c_uint32), ("positions", c.POINTER(Vec4)),
                   ("previous_positions", c.POINTER(Vec4)), ("velocities", c.POINTER(Vec4)),
                   ("normals", c.POINTER(Vec4)), ("triangles", c.POINTER(c.c_uint32)),
                   ("vertex_to_particle", c.POINTER(c.c_uint32)), ("texcoords", c.POINTER(c.c_float)),
                   ("vertex_triangles", c.POINTER(c.c_uint32)), ("lower", Vec3), ("upper", Vec3))


class Weft:
    """The library; what fails raises its words."""

    def __init__(self, path):
        self.library = c.CDLL(path)
        self.library.weft_error_text.restype = c.c_char_p
        self.library.weft_version_string.restype = c.c_char_p

    def call(self, name, *arguments):
        if getattr(self.library, "weft_" + name)(*arguments) != 0:
            raise RuntimeError(self.library.weft_error_text().decode())

    def defaults(self, kind, init):
        settings = kind()
        getattr(self.library, init)(c.byref(settings), c.c_size_t(c.sizeof(settings)))
        return settings


def energies(view, gravity):
    """Of what moves, and of what has been lifted [J]; w is the inverse mass, 0 where a particle is pinned."""
    moving = lifted = 0.0
    for position, velocity in zip(view.positions[:view.particles], view.velocities[:view.particles]):
        if position.w > 0:
            moving += 0.5 / position.w * (velocity.x**2 + velocity.y**2 + velocity.z**2)
            lifted += gravity / position.w * position.y
    return moving, lifted


def wave(weft, seconds):
    rows, columns = 12, 18
    air = weft.defaults(WorldSettings, "weft_world_settings_init")
    air.wind.velocity.x, air.wind.gust = 6, 0.3
    world, mesh, flag = c.c_void_p(), c.c_void_p(), Id()
    weft.call("world_create", c.byref(air), c.byref(world))
    sheet = weft.defaults(SheetSettings, "weft_sheet_settings_init")
    sheet.rows, sheet.columns, sheet.u, sheet.v = rows, columns, Vec3(1.5, 0, 0), Vec3(0, -1, 0)
    weft.call("mesh_make_sheet", c.byref(sheet), c.byref(mesh))
    weft.call("world_add_cloth", world, mesh, None, c.byref(flag))
    weft.library.weft_mesh_destroy(mesh)
    pole = (c.c_uint32 * rows)(*range(0, rows * columns, columns))
    weft.call("world_pin", world, flag, pole, c.c_size_t(rows))
    view, plot = ClothView(struct_size=c.sizeof(ClothView)), []
    for _ in range(60 * seconds):
        weft.call("world_step", world, c.c_float(1 / 60))
        weft.call("world_cloth", world, flag, c.byref(view))
        plot.append(energies(view, -air.gravity.y))
    weft.library.weft_world_destroy(world)
    return plot


def picture(plot, width=640, height=240):
    """Both energies as curves, from their least to their greatest."""
    def curve(values, colour, name, line):
        low, high = min(values), max(values)
        points = " ".join(f"{i * width / len(values):.1f},{height - 10 - (v - low) / (high - low) * (height - 20):.1f}"
                          for i, v in enumerate(values))
        return (f'<polyline fill="none" stroke="{colour}" points="{points}"/>'
                f'<text x="8" y="{line}" fill="{colour}">{name}: {low:.3f} to {high:.3f} J</text>')
    moving, lifted = zip(*plot)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-size="13">'
            + curve(moving, "firebrick", "of motion", 20) + curve(lifted, "steelblue", "of height", 38) + "</svg>\n")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    library = Weft(sys.argv[1])
    energy = wave(library, 5)
    if len(sys.argv) == 3:
        with open(sys.argv[2], "w") as file:
            file.write(picture(energy))
    print(f"Weft {library.library.weft_version_string().decode()}: {len(energy)} steps; at the end the flag moves with "
          f"{energy[-1][0]:.3f} J and hangs {energy[0][1] - energy[-1][1]:.3f} J lower than at first")
