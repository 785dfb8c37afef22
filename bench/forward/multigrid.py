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
"""Many right-hand sides at once by conjugate gradients, preconditioned by the multigrid hierarchy of PyAMG.

PyAMG's own solver takes one at a time, which reads the matrix as often as there are right-hand sides."""

import numpy as np
import pyamg
import scipy.linalg
from pyamg.util.linalg import approximate_spectral_radius

COLUMNS_AT_ONCE = 16  # bounds the memory
SWEEPS = 2  # of Jacobi's method, before and after each visit of the coarser level
ITERATIONS = 300


class Level:
    def __init__(self, level):
        self.matrix = level.A.tocsr()
        if hasattr(level, "P"):
            self.up, self.down = level.P.tocsr(), level.R.tocsr()
            diagonal = self.matrix.diagonal()
            scaled = self.matrix.multiply(1.0 / diagonal[:, None]).tocsr()
            self.step = (4 / 3 / approximate_spectral_radius(scaled) / diagonal)[:, None]
        else:
            self.inverse = scipy.linalg.pinvh(self.matrix.toarray())


class Multigrid:
    """For a matrix that is symmetric and positive definite."""

    def __init__(self, matrix):
        self.matrix = matrix
        self.levels = [Level(level) for level in pyamg.smoothed_aggregation_solver(matrix, symmetry="symmetric").levels]

    def precondition(self, loads, depth=0):
        level = self.levels[depth]
        if depth == len(self.levels) - 1:
            return level.inverse @ loads
        values = level.step * loads
        for _ in range(SWEEPS - 1):
            values += level.step * (loads - level.matrix @ values)
        values += level.up @ self.precondition(level.down @ (loads - level.matrix @ values), depth + 1)
        for _ in range(SWEEPS):
            values += level.step * (loads - level.matrix @ values)
        return values

    def solve(self, loads, tolerance):
        """loads: (nodes, columns); the norms of residuals are within the tolerance times those of the loads."""
        columns = np.arange(0, loads.shape[1], COLUMNS_AT_ONCE)
        return np.hstack([self.solve_some(loads[:, c : c + COLUMNS_AT_ONCE], tolerance) for c in columns])

    def solve_some(self, loads, tolerance):
        dot = lambda a, b: np.einsum("nc,nc->c", a, b)
        values = np.zeros_like(loads)
        residuals = loads.copy()
        limit = tolerance**2 * dot(loads, loads)
        way = np.zeros_like(loads)
        previous = np.ones(loads.shape[1])
        for _ in range(ITERATIONS):
            better = self.precondition(residuals)
            product = dot(residuals, better)
            way = better + product / previous * way
            image = self.matrix @ way
            length = product / dot(way, image)
            values += length * way
            residuals -= length * image
            previous = product
            if (dot(residuals, residuals) <= limit).all():
                return values
        raise RuntimeError("The conjugate gradients did not converge.")
