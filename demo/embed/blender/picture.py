"""Renders a frame of what `weft_demo --headless --export pc2 --out OUT` has written:

    blender -b --python demo/embed/blender/picture.py -- OUT PICTURE.png [FRAME]

Weft's files are +Y up. The OBJ import turns the object about x, so that it stands in Blender's axes, and leaves
the mesh's own coordinates as they are in the file. Those of the cache are the same ones, so the modifier must
not turn them again: Forward +Y and Up +Z, which say that nothing is turned.
"""
import math
import os
import sys

import bpy
from mathutils import Vector

folder, picture, *rest = sys.argv[sys.argv.index("--") + 1:]
frame = int(rest[0]) if rest else 0
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.wm.obj_import(filepath=os.path.join(folder, "sequence.obj"), forward_axis="NEGATIVE_Z", up_axis="Y")
cloth = bpy.context.selected_objects[0]
first = [cloth.matrix_world @ v.co for v in cloth.data.vertices]

cache = cloth.modifiers.new("Weft", "MESH_CACHE")
cache.cache_format = "PC2"
cache.filepath = os.path.abspath(os.path.join(folder, "sequence.pc2"))
cache.forward_axis, cache.up_axis = "POS_Y", "POS_Z"
cache.frame_start = 0


def places(at):
    """World positions of the vertices at a frame."""
    bpy.context.scene.frame_set(at)
    shown = cloth.evaluated_get(bpy.context.evaluated_depsgraph_get())
    return [shown.matrix_world @ v.co for v in shown.data.vertices]


apart = max((a - b).length for a, b in zip(first, places(0)))
now = places(frame)
lower, upper = (Vector([f(p[k] for p in now) for k in range(3)]) for f in (min, max))
print(f"frame 0 of the cache is {apart:.1e} m from the OBJ file; frame {frame} reaches from z = {lower.z:.2f} m to {upper.z:.2f} m")
if apart > 1e-4:
    sys.exit("blender/picture.py: the cache's axes are not those of the OBJ file")

fabric = bpy.data.materials.new("fabric")
fabric.use_nodes = True
fabric.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (0.55, 0.08, 0.1, 1)
cloth.data.materials.clear()
cloth.data.materials.append(fabric)
for face in cloth.data.polygons:
    face.use_smooth = True
scene = bpy.context.scene
middle, size = (lower + upper) / 2, (upper - lower).length
camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
camera.location = middle + 1.3 * size * Vector((0.35, -1, 0.25))
camera.rotation_euler = (middle - camera.location).to_track_quat("-Z", "Y").to_euler()
sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
sun.rotation_euler, sun.data.energy = (math.radians(50), 0, math.radians(30)), 3
scene.collection.objects.link(camera)
scene.collection.objects.link(sun)
scene.camera = camera
scene.world = bpy.data.worlds.new("sky")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.5, 0.6, 0.75, 1)
scene.render.engine = "CYCLES"  # which needs no display
scene.cycles.samples, scene.cycles.use_denoising = 16, False
scene.render.resolution_x, scene.render.resolution_y = 640, 480
scene.render.filepath = os.path.abspath(picture)
bpy.ops.render.render(write_still=True)
