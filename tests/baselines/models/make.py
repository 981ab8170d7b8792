#!/usr/bin/env python3
"""Writes the models and textures of the suite into this folder, always the same bytes. Needs nothing but Python."""

import json
import math
import pathlib
import struct
import zlib

here = pathlib.Path(__file__).parent

# ---- Geometry: all shapes in shapes.bin, which every model reads ---------------------------------------------------

binary = bytearray()
views, accessors = [], []


def add(rows, component, kind, bounds=False):
    """A tightly packed accessor of rows of numbers; returns its index."""
    code, fmt = {"u8": (5121, "B"), "u16": (5123, "H"), "f32": (5126, "f")}[component]
    data = b"".join(struct.pack("<" + str(len(row)) + fmt, *row) for row in rows)
    while len(binary) % 4:
        binary.append(0)
    views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
    binary.extend(data)
    accessor = {"bufferView": len(views) - 1, "componentType": code, "type": kind, "count": len(rows)}
    if bounds:
        single = [struct.unpack("<f", struct.pack("<f", x))[0] for row in rows for x in row]
        width = len(rows[0])
        accessor["min"] = [min(single[i::width]) for i in range(width)]
        accessor["max"] = [max(single[i::width]) for i in range(width)]
    accessors.append(accessor)
    return len(accessors) - 1


def primitive(positions, normals, uvs, triangles, **more):
    attributes = {"POSITION": add(positions, "f32", "VEC3", True)}
    if normals:
        attributes["NORMAL"] = add(normals, "f32", "VEC3")
    if uvs:
        attributes["TEXCOORD_0"] = add(uvs, "f32", "VEC2")
    for name, index in more.items():
        attributes[name] = index
    return {"attributes": attributes, "indices": add([[i] for t in triangles for i in t], "u16", "SCALAR")}


def grid(columns, rows):
    out = []
    for y in range(rows):
        for x in range(columns):
            a, b = y * (columns + 1) + x, (y + 1) * (columns + 1) + x
            out += [(a, b, b + 1), (a, b + 1, a + 1)]
    return out


def sphere(stacks, slices):
    p, uv = [], []
    for i in range(stacks + 1):
        for j in range(slices + 1):
            polar, round_ = math.pi * i / stacks, 2 * math.pi * j / slices
            p.append((-math.sin(polar) * math.cos(round_), math.cos(polar), math.sin(polar) * math.sin(round_)))
            uv.append((2 * j / slices, i / stacks))
    return primitive(p, p, uv, grid(slices, stacks))


def quad(colors=None):
    corners = [(-1, 1, 0), (1, 1, 0), (-1, -1, 0), (1, -1, 0)]
    more = {"COLOR_0": add(colors, "f32", "VEC4")} if colors else {}
    return primitive(corners, [(0, 0, 1)] * 4, [(0, 0), (1, 0), (0, 1), (1, 1)], [(0, 2, 1), (1, 2, 3)], **more)


def bar():
    """Along y from 0 to 2, its upper half of the second joint."""
    p, n, joints, weights = [], [], [], []
    for ring in range(9):
        for side in range(13):
            angle, y = 2 * math.pi * side / 12, ring / 4
            n.append((math.sin(angle), 0, math.cos(angle)))
            p.append((0.3 * math.sin(angle), y, 0.3 * math.cos(angle)))
            upper = min(max((y - 0.5) / 1.0, 0), 1)
            joints.append((0, 1, 0, 0))
            weights.append((1 - upper, upper, 0, 0))
    triangles = [(a, c, b) for a, b, c in grid(12, 8)]
    return primitive(p, n, None, triangles, JOINTS_0=add(joints, "u8", "VEC4"), WEIGHTS_0=add(weights, "f32", "VEC4"))


ball = sphere(16, 32)
square = quad()
painted = quad([(1, 0.1, 0.1, 1), (0.1, 1, 0.1, 1), (0.1, 0.1, 1, 1), (1, 1, 0.2, 1)])
limb = bar()
inverse_bind = add([[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1], [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1]],
                   "f32", "MAT4")
line = {"attributes": {"POSITION": add([(-1, -1, 0), (1, 1, 0), (1, -1, 0), (-1, 1, 0)], "f32", "VEC3", True)}, "mode": 1}
dots = {"attributes": {"POSITION": add([(x / 4, y / 4, 0) for x in range(-4, 5) for y in range(-4, 5)], "f32", "VEC3",
                                      True)}, "mode": 0}
swell = add([tuple(0.6 * max(c, 0) * (k == 1) for k in range(3)) for c in
             [math.cos(math.pi * i / 16) for i in range(17) for _ in range(33)]], "f32", "VEC3", True)
times = add([[0], [1], [2]], "f32", "SCALAR", True)
turns = add([[0, 0, 0, 1], [0, 0, math.sin(0.6), math.cos(0.6)], [0, 0, 0, 1]], "f32", "VEC4")
hops = add([[0, 0, 0], [0, -0.5, 0], [0, 0, 0], [0, 0, 0], [0, 1, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0], [0, 0, 0]], "f32",
           "VEC3")
places = add([(x, y, 0) for x in (-1, 0, 1) for y in (-1, 0, 1)], "f32", "VEC3")
sizes = add([(0.2 + 0.03 * i,) * 3 for i in range(9)], "f32", "VEC3")

# ---- Textures -------------------------------------------------------------------------------------------------------


def png(name, size, pixel):
    rows = b"".join(b"\0" + bytes(min(255, max(0, round(c))) for x in range(size) for c in pixel(x, y))
                    for y in range(size))
    channels = len(pixel(0, 0))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", size, size, 8, {1: 0, 3: 2, 4: 6}[channels], 0, 0, 0)
    (here / name).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) +
                              chunk(b"IEND", b""))


def checks(x, y):
    return (200, 90, 40) if (x // 8 + y // 8) % 2 else (60, 120, 110)


def bumps(x, y):
    """Ridges that run along x: what tells up from down, and another slope along x."""
    nx, ny = 0.35 * math.sin(2 * math.pi * x / 32), 0.6 * math.cos(2 * math.pi * y / 16)
    nz = math.sqrt(1 - min(nx * nx + ny * ny, 0.99))
    return [127.5 + 127.5 * c for c in (nx, ny, nz)]


def surface(x, y):
    """Occlusion, roughness, metallic."""
    return (255 if x // 16 % 2 else 70, 30 + 6 * (y % 32), 255 if (x // 8) % 4 == 0 else 0)


def leaf(x, y):
    inside = math.hypot(x - 31.5, y - 31.5)
    return (60, 170, 50, 255 if 12 < inside < 26 else 20)


def waves(x, y):
    return [127.5 + 127.5 * math.sin(2 * math.pi * (x + y) / 16) * math.cos(2 * math.pi * y / 32)]


png("waves.png", 64, waves)
png("checks.png", 64, checks)
png("bumps.png", 64, bumps)
png("surface.png", 64, surface)
png("leaf.png", 64, leaf)
files = ["checks.png", "bumps.png", "surface.png", "leaf.png"]
CHECKS, BUMPS, SURFACE, LEAF = ({"index": i} for i in range(4))

# ---- Models ---------------------------------------------------------------------------------------------------------


def material(color=(0.8, 0.8, 0.8), metallic=0.0, roughness=0.5, extensions=None, **more):
    pbr = {"baseColorFactor": list(color) + [1.0] * (4 - len(color)), "metallicFactor": metallic,
           "roughnessFactor": roughness}
    pbr.update(more.pop("pbr", {}))
    out = {"pbrMetallicRoughness": pbr, **more}
    if extensions:
        out["extensions"] = {"KHR_materials_" + name: value for name, value in extensions.items()}
    return out


class Model:
    def __init__(self):
        self.json = {"asset": {"version": "2.0", "generator": "facet tests/baselines/models/make.py"}, "scene": 0,
                     "scenes": [{"nodes": []}], "nodes": [], "meshes": [], "materials": [],
                     "samplers": [{}], "textures": [{"source": i, "sampler": 0} for i in range(len(files))],
                     "images": [{"uri": f} for f in files],
                     "accessors": accessors, "bufferViews": views,
                     "buffers": [{"uri": "shapes.bin", "byteLength": 0}]}

    def put(self, shape, made, at=(0, 0, 0), scale=1.0, root=True, **node):
        self.json["materials"].append(made)
        self.json["meshes"].append({"primitives": [{**shape, "material": len(self.json["materials"]) - 1}]})
        self.json["nodes"].append({"mesh": len(self.json["meshes"]) - 1, "translation": list(at),
                                   "scale": [scale] * 3, **node})
        return self.node_added(root)

    def node_added(self, root=True):
        index = len(self.json["nodes"]) - 1
        if root:
            self.json["scenes"][0]["nodes"].append(index)
        return index

    def row(self, materials, shape=ball):
        for i, made in enumerate(materials):
            self.put(shape, made, (2.2 * (i - (len(materials) - 1) / 2), 0, 0))
        return self

    def light(self, at, kind="point", intensity=100.0, color=(1, 1, 1), **more):
        self.json.setdefault("extensions", {}).setdefault("KHR_lights_punctual", {"lights": []})["lights"].append(
            {"type": kind, "intensity": intensity, "color": list(color), **more.pop("lamp", {})})
        count = len(self.json["extensions"]["KHR_lights_punctual"]["lights"])
        self.json["nodes"].append({"translation": list(at), **more,
                                   "extensions": {"KHR_lights_punctual": {"light": count - 1}}})
        self.node_added()
        return self

    def backdrop(self, z=-2.5, size=4.0):
        self.put(square, material(pbr={"baseColorTexture": CHECKS}, roughness=0.9), (0, 0, z), size)
        return self

    def write(self, name):
        out = self.json
        out["buffers"] = [{"uri": "shapes.bin", "byteLength": len(binary)}]
        used = set()

        def walk(value):
            if isinstance(value, dict):
                used.update(value.get("extensions", {}))
                for v in value.values():
                    walk(v)
            elif isinstance(value, list):
                for v in value:
                    walk(v)

        walk(out)
        if used:
            out["extensionsUsed"] = sorted(used)
        (here / (name + ".gltf")).write_text(json.dumps(out, separators=(",", ":")) + "\n")


textured = material(pbr={"baseColorTexture": CHECKS, "metallicRoughnessTexture": SURFACE}, color=(1, 1, 1), metallic=1,
                    roughness=1, normalTexture=BUMPS, occlusionTexture=SURFACE)
glow = material((0.02, 0.02, 0.02), emissiveTexture=CHECKS, emissiveFactor=[1, 0.6, 0.3],
                extensions={"emissive_strength": {"emissiveStrength": 3}})
m = Model().row([textured, glow]).light((2, 3, 4))
m.json["cameras"] = [{"type": "orthographic", "orthographic": {"xmag": 2.4, "ymag": 2.4, "znear": 0.1, "zfar": 20}},
                     {"type": "perspective", "perspective": {"yfov": 0.5, "znear": 0.1}}]
for camera in (0, 1):
    m.json["nodes"].append({"camera": camera, "translation": [0, 0, 8]})
    m.node_added()
m.write("textured")

# Roughness in place of its square shows best on the middle ones; a point light shows the lobe itself.
Model().row([material((0.9, 0.6, 0.3), 1, r) for r in (0.15, 0.35, 0.6)]).light((-3, 4, 6), intensity=200).write("lobes")

coat = [material((0.5, 0.02, 0.02), 0, 0.7, {"clearcoat": {"clearcoatFactor": 1, "clearcoatRoughnessFactor": r}})
        for r in (0.05, 0.4)]
coat.append(material((0.02, 0.05, 0.4), 0, 0.6, {"clearcoat": {
    "clearcoatFactor": 1, "clearcoatRoughnessFactor": 0.1, "clearcoatNormalTexture": BUMPS}}))
Model().row(coat).light((-3, 4, 6), intensity=200).write("clearcoat")

Model().row([material((0.1, 0.02, 0.1), 0, 0.8, {"sheen": {"sheenColorFactor": c, "sheenRoughnessFactor": r}})
             for c, r in (([0.9, 0.8, 1], 0.2), ([1, 0.3, 0.2], 0.5), ([0.5, 0.9, 0.5], 0.9))]).light((0, 5, 3)).write("sheen")
Model().row([material((0.8, 0.5, 0.3), 0, 0.5, {"diffuse_roughness": {
    "diffuseRoughnessFactor": f, **({"diffuseRoughnessTexture": CHECKS} if textured else {})}})
             for f, textured in ((0, False), (1, False), (1, True))]).light((0, 1, 6), intensity=60).write("rough")
Model().row([material(c, metal, 0.15, {"iridescence": {
    "iridescenceFactor": 1, "iridescenceIor": ior, "iridescenceThicknessMaximum": t}})
             for c, metal, ior, t in (((0.9, 0.9, 0.9), 1, 1.3, 380), ((0.05, 0.05, 0.05), 0, 1.8, 600))]
            ).light((-2, 4, 5)).write("iridescence")
Model().row([material((0.8, 0.8, 0.85), 1, 0.35, {"anisotropy": {"anisotropyStrength": 0.9, "anisotropyRotation": a}})
             for a in (0, 0.785, 1.571)]).light((-2, 4, 5), intensity=200).write("anisotropy")
Model().row([material((0.3, 0.3, 0.3), 0, 0.2, {"ior": {"ior": 1.8}, "specular": {"specularColorFactor": [1, 0.5, 0.2]}}),
             material((0.3, 0.3, 0.3), 0, 0.2, {"specular": {"specularFactor": 0}}),
             material((0.3, 0.3, 0.3), 0, 0.2, {"ior": {"ior": 2.4}})]).light((-2, 4, 5)).write("specular")
Model().backdrop().row([
    material((1, 1, 1), 0, 0.05, {"transmission": {"transmissionFactor": 1}}),
    material((0.9, 0.6, 0.6), 0, 0.4, {"transmission": {"transmissionFactor": 0.9}})]).light((0, 3, 5)).write("transmission")
Model().backdrop().row([
    material((1, 1, 1), 0, 0, {"transmission": {"transmissionFactor": 1}, "ior": {"ior": 1.5}, "dispersion": {
        "dispersion": 5}, "volume": {"thicknessFactor": 2, "attenuationDistance": 2, "attenuationColor": [0.3, 0.8, 0.6]}}),
    material((0.8, 0.2, 0.1), 0, 0.6, {"diffuse_transmission": {
        "diffuseTransmissionFactor": 0.8, "diffuseTransmissionColorFactor": [1, 0.5, 0.2]}})]).light(
            (0, 2, -2), intensity=60).write("volume")
specular_glossiness = {"extensions": {"KHR_materials_pbrSpecularGlossiness": {
    "diffuseTexture": CHECKS, "specularFactor": [0.3, 0.25, 0.1], "glossinessFactor": 0.7}}}
unlit = {"pbrMetallicRoughness": {"baseColorTexture": {**CHECKS, "extensions": {"KHR_texture_transform": {
    "scale": [2, 1], "offset": [0.1, 0.2], "rotation": 0.4}}}}, "extensions": {"KHR_materials_unlit": {}}}
m = Model().row([specular_glossiness, unlit])
m.put(painted, material((1, 1, 1), 0, 1), (0, -1.9, 0), 0.7)
m.write("older")

m = Model().backdrop(-1.5, 2.2)
m.put(square, material((1, 1, 1, 1), 0, 0.8, pbr={"baseColorTexture": LEAF}, alphaMode="MASK", alphaCutoff=0.5,
                       doubleSided=True), (-0.9, 0, 0), 0.9, rotation=[0, 1, 0, 0])
m.put(square, material((0.2, 0.4, 0.9, 0.5), 0, 0.3, alphaMode="BLEND"), (0.6, 0.2, 0.5), 0.8)
m.put(square, material((0.9, 0.3, 0.2, 0.4), 0, 0.3, alphaMode="BLEND"), (1.0, -0.3, 0.9), 0.6)
m.light((0, 2, 4), intensity=30).write("alpha")

m = Model()
m.put(square, material((0.8, 0.8, 0.8), 0, 0.8), (0, 0, 0), 2)
m.light((-1.2, 0.8, 1), intensity=4, color=(1, 0.3, 0.2), lamp={"range": 3.0})
m.light((1, 0.5, 1.5), "spot", 25, (0.3, 0.5, 1), lamp={"spot": {"innerConeAngle": 0.3, "outerConeAngle": 0.5}})
m.light((0, 0, 1), "directional", 0.8, (0.6, 1, 0.6), rotation=[-0.4, 0, 0, 0.9165151])
m.write("lights")

m = Model()
m.put({**ball, "extensions": {"KHR_materials_variants": {"mappings": [{"material": 1, "variants": [0]}]}}},
      material((0.8, 0.1, 0.1), 0, 0.4))
m.json["materials"].append(material((0.1, 0.3, 0.8), 1, 0.2))
m.json["extensions"] = {"KHR_materials_variants": {"variants": [{"name": "blue"}]}}
m.write("variants")

m = Model()
arm = m.put(limb, material((0.7, 0.5, 0.4), 0, 0.6))
m.json["nodes"][arm] = {"mesh": 0, "skin": 0}
m.json["nodes"] += [{"children": [2]}, {"translation": [0, 1, 0]}]
m.json["scenes"][0]["nodes"].append(1)
m.json["skins"] = [{"joints": [1, 2], "inverseBindMatrices": inverse_bind}]
swelling = m.put({**ball, "targets": [{"POSITION": swell}]}, material((0.3, 0.6, 0.3), 0, 0.5), (1.4, 1, 0), 0.6)
m.json["meshes"][-1]["weights"] = [0.8]
hopping = m.put(ball, material((0.3, 0.3, 0.8), 0, 0.5), (-1.4, 0.5, 0), 0.4)
m.json["nodes"][hopping] = {"children": [len(m.json["nodes"])], "translation": [-1.4, 0.5, 0]}
m.json["nodes"].append({"mesh": len(m.json["meshes"]) - 1, "scale": [0.4, 0.4, 0.4]})
m.json["animations"] = [{"name": "wave", "samplers": [{"input": times, "output": turns},
                                                      {"input": times, "output": hops, "interpolation": "CUBICSPLINE"}],
                         "channels": [{"sampler": 0, "target": {"node": 2, "path": "rotation"}},
                                      {"sampler": 1, "target": {"node": len(m.json["nodes"]) - 1,
                                                                "path": "translation"}}]}]
m.light((1, 4, 5), intensity=60).write("motion")

m = Model()
m.put(ball, material((0.6, 0.6, 0.2), 0.5, 0.4), extensions={"EXT_mesh_gpu_instancing": {
    "attributes": {"TRANSLATION": places, "SCALE": sizes}}})
m.put(line, {**material((1, 0, 0)), "extensions": {"KHR_materials_unlit": {}}}, (0, 0, 0.5))
m.put(dots, {**material((0, 1, 0)), "extensions": {"KHR_materials_unlit": {}}}, (0, 0, 0.6))
hidden = m.put(ball, material((1, 0, 1)), (0, 0, 1), extensions={"KHR_node_visibility": {"visible": False}})
m.light((2, 3, 5), intensity=60).write("instances")

(here / "shapes.bin").write_bytes(binary)
