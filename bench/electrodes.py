#!/usr/bin/env python3
# =========================================================================
#
#  Copyright NumFOCUS
#
#  Licensed under the Apache License, Version 2.0 (the "License");
#  you may not use this file except in compliance with the License.
#  You may obtain a copy of the License at
#
#         https://www.apache.org/licenses/LICENSE-2.0.txt
#
#  Unless required by applicable law or agreed to in writing, software
#  distributed under the License is distributed on an "AS IS" BASIS,
#  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
#  See the License for the specific language governing permissions and
#  limitations under the License.
#
# =========================================================================
"""usage: electrodes.py [--leads] [--spacing MM] [--number N] [--radius MM] [--folder out] [--bin build/bin]

Meshes the head phantom with and without N discs all over the scalp and two leads in its brain, and prints how far contact
areas are from those of the shapes, the dihedral angles, and the times. With --leads, meshes single leads in a small cube
instead, of voxels from 0.4 to 1 mm.
"""

import argparse
import gzip
import json
import math
import pathlib
import subprocess


def read_nrrd(path):
    """Size, spacing, origin and voxels of what make-head-phantom writes: one byte a voxel, along the axes, compressed."""
    header, _, data = path.read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in header.decode().splitlines() if ": " in line and line[0] != "#")
    size = [int(n) for n in fields["sizes"].split()]
    steps = [vector.strip("()").split(",") for vector in fields["space directions"].split()]
    origin = [float(x) for x in fields["space origin"].strip("()").split(",")]
    return size, [float(steps[a][a]) for a in range(3)], origin, gzip.decompress(data)


def scalp_points(image, number):
    """Places on the scalp, evenly spread over all directions from the middle of the head that go up enough."""
    size, spacing, origin, voxels = image
    middle = [n / 2 for n in size]

    def is_head(at):
        i, j, k = (round(x) for x in at)
        inside = 0 <= i < size[0] and 0 <= j < size[1] and 0 <= k < size[2]
        return inside and voxels[i + size[0] * (j + size[1] * k)] != 0

    lowest = 0.0
    points = []
    for n in range(number):
        z = 1 - (1 - lowest) * (n + 0.5) / number
        angle = n * math.pi * (3 - math.sqrt(5))
        around = math.sqrt(1 - z * z)
        way = [around * math.cos(angle) / spacing[0], around * math.sin(angle) / spacing[1], z / spacing[2]]
        distance = 200.0
        while not is_head([m + distance * w for m, w in zip(middle, way)]):
            distance -= 0.25
        points.append([o + s * (m + distance * w) for o, s, m, w in zip(origin, spacing, middle, way)])
    return points


def describe(points, radius, middle):
    electrodes = [
        {"name": f"E{n + 1}", "label": 1001 + n, "shape": "disc", "radius": radius, "thickness": 4, "position": place}
        for n, place in enumerate(points)
    ]
    for side, name in ((-1, "right"), (1, "left")):
        tip = [middle[0] + side * 12, middle[1], middle[2] - 4]
        entry = [middle[0] + side * 30, middle[1] - 20, middle[2] + 38]
        label = 2000 + 100 * (side > 0)
        lead = {"name": name, "shape": "lead", "model": "Medtronic 3389", "label": label + 1, "shaft_label": label}
        electrodes.append({**lead, "tip": tip, "entry": entry})
    return {"space": "LPS", "electrodes": electrodes}


def write_cube(path, voxel, side):
    """A ball in a cube around the origin."""
    count = round(side / voxel)
    middle = (count - 1) / 2
    square = [((n - middle) * voxel) ** 2 for n in range(count)]
    voxels = bytes(1 + (x + y + z < 64) for z in square for y in square for x in square)
    header = f"""NRRD0004
type: unsigned char
dimension: 3
space: left-posterior-superior
sizes: {count} {count} {count}
space directions: ({voxel},0,0) (0,{voxel},0) (0,0,{voxel})
space origin: ({-middle * voxel},{-middle * voxel},{-middle * voxel})
encoding: raw

"""
    path.write_bytes(header.encode() + voxels)


def measure_leads(program, folder):
    image = folder / "cube.nrrd"
    file = folder / "lead.json"
    tip = [0.1, -0.2, -4.0]
    print("voxel, model: contact area at worst, smallest dihedral angle")
    for voxel in (0.4, 0.6, 0.8, 1.0):
        write_cube(image, voxel, 28)
        for model in ("Medtronic 3389", "Medtronic 3387"):
            worst, angle = 0.0, 180.0
            for way in ((0.3, 0.2, 1.0), (1.0, 0.8, 0.3), (0.0, 0.0, 1.0)):
                scale = 15 / math.sqrt(sum(w * w for w in way))
                lead = {"shape": "lead", "model": model, "label": 51, "shaft_label": 50, "tip": tip}
                lead["entry"] = [t + scale * w for t, w in zip(tip, way)]
                file.write_text(json.dumps({"space": "LPS", "electrodes": [lead]}))
                report = mesh(program, image, folder / "cube.vtu", "--exterior", "none", "--electrodes", file)
                angle = min(angle, report["quality"]["overall"]["smallest_dihedral_angle_deg"]["minimum"])
                worst = max([worst] + [error_of(e) for e in report["electrodes"][1:]])
            print(f"{voxel} mm, {model}: {100 * worst:.1f} %, {angle:.1f} degrees", flush=True)


def error_of(electrode):
    return abs(electrode["contact_area_mm2"] / electrode["expected_area_mm2"] - 1)


def mesh(program, image, output, *options):
    report = output.with_suffix(".json")
    subprocess.run([program, image, output, "--report", report, "--quiet", *options], check=True)
    return json.loads(report.read_text())


def line(what, report):
    quality = report["quality"]["overall"]
    angles = quality["smallest_dihedral_angle_deg"]["minimum"], quality["largest_dihedral_angle_deg"]
    return f"{what}: {quality['tetrahedra']} tetrahedra, {angles[0]:.1f} to {angles[1]:.1f} degrees, {report['seconds']:.0f} s"


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[0][7:])
    parser.add_argument("--leads", action="store_true")
    parser.add_argument("--spacing", default="1")
    parser.add_argument("--number", type=int, default=256)
    parser.add_argument("--radius", type=float, default=5)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("out"))
    parser.add_argument("--bin", type=pathlib.Path, default=pathlib.Path("build/bin"))
    arguments = parser.parse_args()

    arguments.folder.mkdir(parents=True, exist_ok=True)
    program = arguments.bin / "multimaterial-mesh"
    if arguments.leads:
        measure_leads(program, arguments.folder)
        return
    labels = arguments.folder / "phantom.nrrd"
    subprocess.run([arguments.bin / "make-head-phantom", labels, arguments.spacing], check=True)
    image = read_nrrd(labels)
    middle = [o + s * n / 2 for o, s, n in zip(image[2], image[1], image[0])]
    cap = arguments.folder / "cap.json"
    cap.write_text(json.dumps(describe(scalp_points(image, arguments.number), arguments.radius, middle), indent=1))

    without = mesh(program, labels, arguments.folder / "without.vtu")
    report = mesh(program, labels, arguments.folder / "with.vtu", "--electrodes", cap)
    print(line("without electrodes", without))
    print(line(f"with {arguments.number} discs and 2 leads", report))
    print(f"time: {report['seconds'] / without['seconds']:.2f} times as long")
    for what, chosen in (
        ("discs", [e for e in report["electrodes"] if 1000 < e["label"] < 2000]),
        ("contacts of leads", [e for e in report["electrodes"] if e["label"] > 2000 and e["label"] % 100 > 0]),
    ):
        errors = sorted(error_of(e) for e in chosen)
        print(
            f"areas of {what}: within {100 * errors[len(errors) // 2]:.2f} % for half, {100 * errors[-1]:.2f} % for all"
        )


if __name__ == "__main__":
    main()
