# Steps a sheet of Weft's in the physics tick and draws it. Arguments: the steps after which to end, and a picture to leave.
extends Spatial

const WeftSheet = preload("res://weft_sheet.gdns")

var sheet = WeftSheet.new()
var triangles = sheet.triangles()
var mesh = ArrayMesh.new()
var steps = 0
var last = 0

func _ready():
	var arguments = OS.get_cmdline_args()
	if arguments.size() > 0:
		last = int(arguments[0])
	var fabric = SpatialMaterial.new()
	fabric.albedo_color = Color(0.55, 0.08, 0.1)
	fabric.params_cull_mode = SpatialMaterial.CULL_DISABLED
	$Cloth.material_override = fabric
	$Cloth.mesh = mesh
	draw()

func draw():
	var arrays = []
	arrays.resize(Mesh.ARRAY_MAX)
	arrays[Mesh.ARRAY_VERTEX] = sheet.positions()
	arrays[Mesh.ARRAY_NORMAL] = sheet.normals()
	arrays[Mesh.ARRAY_INDEX] = triangles
	while mesh.get_surface_count() > 0:
		mesh.surface_remove(0)
	mesh.add_surface_from_arrays(Mesh.PRIMITIVE_TRIANGLES, arrays)

func _physics_process(delta):
	sheet.step(delta)
	draw()
	steps += 1
	if steps != last:
		return
	var box = mesh.get_aabb()
	print("%d steps: from y = %.2f m to %.2f m, %.2f m deep" % [steps, box.position.y, box.end.y, box.size.z])
	if OS.get_cmdline_args().size() > 1:
		yield(VisualServer, "frame_post_draw")
		var picture = get_viewport().get_texture().get_data()
		picture.flip_y()
		picture.save_png(OS.get_cmdline_args()[1])
	get_tree().quit(0 if abs(box.end.y) < 0.01 and box.position.y < -0.9 and box.size.z > 0.05 else 1)
