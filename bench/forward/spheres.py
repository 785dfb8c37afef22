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
"""Four concentric spheres: their label image, and what is known of potentials and fields in them."""

import numpy as np
from sphere import CONDUCTIVITIES, RADII, write_image
from sphere_model import surface_potential

# mm; on no symmetry of the voxels, so that errors do not cancel out
MIDDLE = np.array([0.23, 0.41, -0.17])
ECCENTRICITIES = (0.2, 0.5, 0.8, 0.9, 0.95, 0.98)
ELECTRODES = 32
DIPOLES = 30  # places at each eccentricity
FIELD_POINTS = 3000
PAIRS = 8


def label_image(spacing):
    """Labels 1 to 4 from the inside out, as an array of [z, y, x], and the first voxel's centre, equal in x, y and z."""
    size = 2 * int(np.ceil(RADII[-1] / spacing)) + 4
    place = (np.arange(size) - 0.5 * (size - 1)) * spacing
    x, y, z = ((place - middle) ** 2 for middle in MIDDLE)
    layers = np.searchsorted(RADII, np.sqrt(z[:, None, None] + y[:, None] + x))
    return np.where(layers < len(RADII), layers + 1, 0).astype(np.uint8), place[0]


def write_labels(name, spacing):
    write_image(name, label_image(spacing)[0], spacing)


def spread(count):
    """Directions that are spread evenly over the sphere, on a spiral by the golden angle."""
    n = np.arange(count) + 0.5
    height = 1 - 2 * n / count
    angle = np.pi * (3 - np.sqrt(5)) * n
    radius = np.sqrt(1 - height**2)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), height])


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)


class Reference:
    """Electrodes, dipoles and field points, and the exact values. Positions in mm around the middle of the spheres.

    potentials: at each electrode for each dipole, in V for A m; fields: the exact gradient of the potential in the
    brain, in V/m for 1 A, at each point for each pair of electrodes."""

    def __init__(self):
        random = np.random.default_rng(1)
        self.electrodes = RADII[-1] * spread(ELECTRODES)
        positions, moments, eccentricities = [], [], []
        for eccentricity in ECCENTRICITIES:
            axes = np.linalg.qr(random.standard_normal((3, 3)))[0]
            outwards = spread(DIPOLES) @ axes
            across = unit(np.cross(outwards, random.standard_normal((DIPOLES, 3))))
            positions += [eccentricity * RADII[0] * outwards] * 2
            moments += [outwards, across]
            eccentricities += [eccentricity] * 2 * DIPOLES
        self.positions, self.moments = np.concatenate(positions), np.concatenate(moments)
        self.eccentricities = np.array(eccentricities)
        self.potentials = self.potential(self.positions, self.moments).T

        self.points = RADII[0] * unit(random.standard_normal((FIELD_POINTS, 3)))
        self.points *= random.uniform(size=(FIELD_POINTS, 1)) ** (1 / 3)
        # from near neighbours to opposite ones
        self.pairs = []
        for first, rank in zip(range(0, ELECTRODES, ELECTRODES // PAIRS), np.linspace(2, ELECTRODES - 1, PAIRS)):
            distance = np.linalg.norm(self.electrodes - self.electrodes[first], axis=1)
            self.pairs.append((first, int(np.argsort(distance)[int(rank)])))
        lead = np.stack([self.potential(self.points, axis) for axis in np.eye(3)], axis=-1)
        self.fields = np.stack([lead[:, a] - lead[:, b] for a, b in self.pairs])

    def potential(self, positions, moments):
        moments = np.broadcast_to(moments, positions.shape)
        return surface_potential(self.electrodes * 1e-3, positions * 1e-3, moments, RADII * 1e-3, CONDUCTIVITIES)
