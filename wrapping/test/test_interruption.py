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
"""Ctrl-C ends a run soon, as KeyboardInterrupt, and nothing else is lost."""

import os
import signal
import subprocess
import threading
import time

import itk
import numpy as np
import pytest
from conftest import make_head, points_of


class SignalAfter:
    """Sends SIGINT to this process from another one, as a terminal does; here, threads wait for the filter."""

    def __init__(self, seconds):
        self.seconds = seconds

    def __enter__(self):
        self.process = subprocess.Popen(["sh", "-c", f"sleep {self.seconds}; kill -INT {os.getpid()}"])

    def __exit__(self, *_):
        self.process.wait()


@pytest.fixture(autouse=True)
def handler():
    """Programs that a shell starts in the background ignore the signal."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.fixture(scope="module")
def large():
    """Labels that take long enough to be interrupted."""
    return make_head(size=(91, 109, 91), spacing=2.0)


def test_update_ends_soon(large):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(large)
    with SignalAfter(1.0), pytest.raises(KeyboardInterrupt):
        mesher.Update()
    assert mesher.GetProgress() < 0.9
    assert mesher.GetOutput().GetNumberOfCells() == 0
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_function_ends_soon(large):
    start = time.monotonic()
    with SignalAfter(1.0), pytest.raises(KeyboardInterrupt):
        itk.label_image_to_tetrahedral_mesh_filter(large)
    # alone on a machine it takes 0.1 s more
    assert time.monotonic() - start < 10.0


def test_observers_do_not_swallow_it(large, capfd):
    """Python may act on the signal in an observer's code, where ITK would turn it into an error of the observer."""
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(large)
    seen = []
    mesher.AddObserver(itk.ProgressEvent(), lambda: seen.append(mesher.GetProgress()))
    with SignalAfter(1.0), pytest.raises(KeyboardInterrupt):
        mesher.Update()
    assert seen
    assert "Traceback" not in capfd.readouterr().err


def test_handler_that_does_not_raise_lets_the_run_go_on(spheres, meshed):
    received = []
    before = signal.signal(signal.SIGINT, lambda number, frame: received.append(number))
    try:
        mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres)
        mesher.AddObserver(itk.StartEvent(), lambda: os.kill(os.getpid(), signal.SIGINT))
        mesher.Update()
    finally:
        signal.signal(signal.SIGINT, before)
    assert received == [signal.SIGINT]
    np.testing.assert_array_equal(points_of(mesher.GetOutput()), points_of(meshed.GetOutput()))


def test_filter_can_be_updated_again(spheres, meshed):
    mesher = itk.LabelImageToTetrahedralMeshFilter.New(spheres)
    interrupt = mesher.AddObserver(itk.StartEvent(), lambda: signal.raise_signal(signal.SIGINT))
    with pytest.raises((KeyboardInterrupt, RuntimeError)):
        mesher.Update()
    mesher.RemoveObserver(interrupt)
    mesher.Update()
    np.testing.assert_array_equal(points_of(mesher.GetOutput()), points_of(meshed.GetOutput()))


def test_runs_in_other_threads(spheres, meshed):
    results = []
    thread = threading.Thread(target=lambda: results.append(itk.label_image_to_tetrahedral_mesh_filter(spheres)))
    thread.start()
    thread.join()
    np.testing.assert_array_equal(points_of(results[0][0]), points_of(meshed.GetOutput()))


def test_stages_can_be_interrupted(large):
    indicators = itk.LabelImageToIndicatorImagesFilter.New(large, radius=3.0)
    with SignalAfter(0.5), pytest.raises(KeyboardInterrupt):
        indicators.Update()
    assert indicators.GetProgress() < 0.9
