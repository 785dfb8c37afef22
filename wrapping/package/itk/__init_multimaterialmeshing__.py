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
"""What the package itk gets besides the wrapped classes. It runs this file when it is imported."""

import sys

from itk_multimaterialmeshing.mesh import MultiMaterialMesh, multimaterial_mesh

# "import itk" would be the module that is not the one that loads others when they are needed
sys.modules["itk"].MultiMaterialMesh = MultiMaterialMesh
sys.modules["itk"].multimaterial_mesh = multimaterial_mesh
