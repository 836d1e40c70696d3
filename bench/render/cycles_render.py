"""Renders a scene of render_bench with Cycles: blender -b --factory-startup -P cycles_render.py --
SCENE FOLDER SIDE SAMPLES SEED THREADS OUTPUT

The numbers are those of scenes/*.txt. Blender's third axis points upwards, so a point (x, y, z) of
those becomes (x, -z, y).
"""

import math
import os
import sys

import bpy
import mathutils

SCENE, FOLDER, SIDE, SAMPLES, SEED, THREADS, OUTPUT = sys.argv[sys.argv.index("--") + 1 :]


def up(p):
    return (p[0], -p[2], p[1])


def node_material(name):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    nodes = material.node_tree.nodes
    nodes.clear()
    return material, nodes, material.node_tree.links, nodes.new("ShaderNodeOutputMaterial")


def shader_material(name, kind, **inputs):
    material, nodes, links, output = node_material(name)
    shader = nodes.new(kind)
    for key, value in inputs.items():
        shader.inputs[key].default_value = value
    links.new(shader.outputs[0], output.inputs["Surface"])
    return material


def diffuse(name, r, g, b):
    return shader_material(name, "ShaderNodeBsdfDiffuse", Color=(r, g, b, 1), Roughness=0)


def lamp(name, r, g, b):
    """Shines on the side of the normal; the other is black."""
    material, nodes, links, output = node_material(name)
    emission = nodes.new("ShaderNodeEmission")
    strength = max(r, g, b)
    emission.inputs["Color"].default_value = (r / strength, g / strength, b / strength, 1)
    emission.inputs["Strength"].default_value = strength
    black = nodes.new("ShaderNodeBsdfDiffuse")
    black.inputs["Color"].default_value = (0, 0, 0, 1)
    side = nodes.new("ShaderNodeNewGeometry")
    mix = nodes.new("ShaderNodeMixShader")
    links.new(side.outputs["Backfacing"], mix.inputs[0])
    links.new(emission.outputs[0], mix.inputs[1])
    links.new(black.outputs[0], mix.inputs[2])
    links.new(mix.outputs[0], output.inputs["Surface"])
    return material


def add_mesh(points, faces, material, smooth=False):
    mesh = bpy.data.meshes.new("mesh")
    mesh.from_pydata([up(p) for p in points], [], faces)
    mesh.materials.append(material)
    for polygon in mesh.polygons:
        polygon.use_smooth = smooth
    bpy.context.collection.objects.link(bpy.data.objects.new("object", mesh))


def quad(corners, material):
    """Counter-clockwise, seen from the side of the normal."""
    add_mesh(corners, [(0, 1, 2, 3)], material)


def box(center, half, degrees, material):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    points = []
    for x in (-1, 1):
        for y in (-1, 1):
            for z in (-1, 1):
                px, py, pz = x * half[0], y * half[1], z * half[2]
                points.append((center[0] + c * px + s * pz, center[1] + py, center[2] - s * px + c * pz))
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    add_mesh(points, faces, material)


def sphere(center, material):
    bpy.ops.mesh.primitive_uv_sphere_add(segments=512, ring_count=256, radius=1, location=up(center))
    mesh = bpy.context.object.data
    mesh.materials.append(material)
    for polygon in mesh.polygons:
        polygon.use_smooth = True


def floor(half, material):
    quad([(-half, 0, half), (half, 0, half), (half, 0, -half), (-half, 0, -half)], material)


def ceiling_lamp(y, z, half, material):
    quad([(-half, y, z - half), (half, y, z - half), (half, y, z + half), (-half, y, z + half)], material)


def camera(center, direction, degrees):
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(degrees)
    data.clip_end = 1000
    thing = bpy.data.objects.new("camera", data)
    thing.location = up(center)
    thing.rotation_euler = mathutils.Vector(up(direction)).to_track_quat("-Z", "Y").to_euler()
    bpy.context.collection.objects.link(thing)
    bpy.context.scene.camera = thing


def background(r, g, b):
    node = bpy.context.scene.world.node_tree.nodes["Background"]
    node.inputs["Color"].default_value = (r, g, b, 1)
    node.inputs["Strength"].default_value = 1


def environment(path):
    tree = bpy.context.scene.world.node_tree
    picture = tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(path)
    picture.image.colorspace_settings.name = "Linear"
    turn = tree.nodes.new("ShaderNodeMapping")
    turn.inputs["Rotation"].default_value = (0, 0, -math.pi / 2)
    place = tree.nodes.new("ShaderNodeTexCoord")
    tree.links.new(place.outputs["Generated"], turn.inputs["Vector"])
    tree.links.new(turn.outputs["Vector"], picture.inputs["Vector"])
    tree.links.new(picture.outputs["Color"], tree.nodes["Background"].inputs["Color"])
    tree.nodes["Background"].inputs["Strength"].default_value = 1


def cornell():
    white = diffuse("white", 0.73, 0.73, 0.73)
    floor(1, white)
    quad([(-1, 2, -1), (1, 2, -1), (1, 2, 1), (-1, 2, 1)], white)
    quad([(-1, 0, -1), (1, 0, -1), (1, 2, -1), (-1, 2, -1)], white)
    quad([(-1, 0, 1), (-1, 0, -1), (-1, 2, -1), (-1, 2, 1)], diffuse("red", 0.63, 0.06, 0.05))
    quad([(1, 0, -1), (1, 0, 1), (1, 2, 1), (1, 2, -1)], diffuse("green", 0.14, 0.45, 0.09))
    box((-0.35, 0.6, -0.3), (0.3, 0.6, 0.3), 18, white)
    box((0.35, 0.3, 0.3), (0.3, 0.3, 0.3), -16, white)
    ceiling_lamp(1.99, 0, 0.25, lamp("lamp", 17, 12, 7))
    background(0, 0, 0)
    camera((0, 1, 4.2), (0, 0, -1), 36)


def glass():
    floor(20, diffuse("floor", 0.5, 0.48, 0.45))
    white = (1, 1, 1, 1)
    sphere((-1.1, 1, 0), shader_material("glass", "ShaderNodeBsdfGlass", Color=white, Roughness=0, IOR=1.5))
    grey = (0.95, 0.95, 0.95, 1)
    sphere((1.1, 1, 0), shader_material("mirror", "ShaderNodeBsdfGlossy", Color=grey, Roughness=0))
    ceiling_lamp(5, 1, 0.5, lamp("lamp", 30, 29, 27))
    background(0.1, 0.12, 0.15)
    camera((0, 2.2, 7), (0, -0.2, -1), 36)


def statue():
    floor(20, diffuse("floor", 0.4, 0.4, 0.4))
    bpy.ops.wm.obj_import(filepath=os.path.join(FOLDER, "statue.obj"), forward_axis="NEGATIVE_Z", up_axis="Y")
    mesh = bpy.context.selected_objects[0].data
    mesh.materials.clear()
    mesh.materials.append(diffuse("stone", 0.6, 0.55, 0.5))
    environment(os.path.join(FOLDER, "sky.exr"))
    camera((0, 1.6, 5), (0, -0.12, -1), 36)


def set_up_cycles():
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.render.resolution_x = scene.render.resolution_y = int(SIDE)
    scene.render.resolution_percentage = 100
    scene.render.threads_mode = "FIXED"
    scene.render.threads = int(THREADS)
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGB"
    scene.render.image_settings.exr_codec = "ZIP"
    scene.render.filepath = OUTPUT
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = int(SAMPLES)
    cycles.seed = int(SEED)
    cycles.use_denoising = False
    cycles.use_adaptive_sampling = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.diffuse_bounces = cycles.glossy_bounces = 16
    cycles.transmission_bounces = cycles.transparent_max_bounces = 16


def main():
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.context.scene.world = bpy.data.worlds.new("world")
    bpy.context.scene.world.use_nodes = True
    {"cornell": cornell, "glass": glass, "statue": statue}[SCENE]()
    set_up_cycles()
    bpy.ops.render.render(write_still=True)


main()
