# blender/sinew_blender/surface_mesh.py: a surface as a mesh of Blender: topology, uvs, colors, materials, places.
import bpy
import numpy

from . import axes, shape_keys

COLORS = "Color"
UVS = "UVMap"
SLOTS = "sinew_materials"  # Of a mesh: the material's number in the file, of each slot.


def fill(mesh, surface, unit):
    """The topology, and all that does not change with the pose."""
    corners = surface.triangles.astype(numpy.int32).ravel()
    count = len(surface.triangles)
    mesh.clear_geometry()
    mesh.vertices.add(len(surface.positions))
    mesh.loops.add(len(corners))
    mesh.polygons.add(count)
    mesh.vertices.foreach_set("co", axes.points_in_blender(surface.positions, unit).ravel())
    mesh.loops.foreach_set("vertex_index", corners)
    mesh.polygons.foreach_set("loop_start", numpy.arange(0, len(corners), 3, dtype=numpy.int32))
    mesh.polygons.foreach_set("loop_total", numpy.full(count, 3, numpy.int32))
    mesh.polygons.foreach_set("use_smooth", numpy.ones(count, bool))
    mesh.update(calc_edges=True)
    rows = surface.uv_triangles.ravel()
    uvs = surface.uv[rows].astype(numpy.float32)
    uvs[:, 1] = 1 - uvs[:, 1]
    mesh.uv_layers.new(name=UVS).data.foreach_set("uv", uvs.ravel())
    if len(surface.colors):
        layer = mesh.color_attributes.new(COLORS, "FLOAT_COLOR", "CORNER")
        layer.data.foreach_set("color", surface.colors[rows].astype(numpy.float32).ravel())


def add_slots(mesh, surface, materials):
    """materials: their names in Blender by number in the file."""
    used = [number for number in numpy.unique(surface.materials).tolist() if number in materials]
    for number in used:
        mesh.materials.append(bpy.data.materials[materials[number]])
    mesh[SLOTS] = used


def assign_slots(mesh, surface):
    """Slots may hold other materials by now; which triangles have which stays."""
    numbers = surface.materials
    slots = numpy.zeros(numbers.max(initial=0) + 2, numpy.int32)  # The last is that of -1: without a material.
    for slot, number in enumerate(mesh.get(SLOTS, ())):
        slots[number] = slot
    mesh.polygons.foreach_set("material_index", slots[numbers])


def move(mesh, surface, unit):
    """Only the places, of a mesh that was filled from a surface of the same rig."""
    places = axes.points_in_blender(surface.positions, unit)
    _place(mesh, mesh.vertices, places)
    if mesh.shape_keys:
        _place(mesh, mesh.shape_keys.key_blocks[0].data, places)
    mesh.update()


def _place(mesh, points, places):
    """Of a linked mesh Blender sets points one by one only."""
    if mesh.library is None:
        points.foreach_set("co", places.ravel())
        return
    for point, place in zip(points, places.tolist()):
        point.co = place


def refill(item, surface, unit):
    """Another topology; sliders and materials stay."""
    kept = shape_keys.take_off(item)
    fill(item.data, surface, unit)
    assign_slots(item.data, surface)
    shape_keys.put_on(item, kept)
