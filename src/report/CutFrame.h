/*=========================================================================
 *
 *  Copyright NumFOCUS
 *
 *  Licensed under the Apache License, Version 2.0 (the "License");
 *  you may not use this file except in compliance with the License.
 *  You may obtain a copy of the License at
 *
 *         https://www.apache.org/licenses/LICENSE-2.0.txt
 *
 *  Unless required by applicable law or agreed to in writing, software
 *  distributed under the License is distributed on an "AS IS" BASIS,
 *  WITHOUT WARRANTIES OR CONDITIONS OF ANY KIND, either express or implied.
 *  See the License for the specific language governing permissions and
 *  limitations under the License.
 *
 *=========================================================================*/
#ifndef mmmCutFrame_h
#define mmmCutFrame_h

#include "report/MeshCut.h"
#include "report/SvgPath.h"

#include "itkImageBase.h"

#include <string>

namespace mmm
{
/** \brief A cut along two axes of the image's grid, and how it is drawn: as radiologists look at it, the patient's left
 * on the right, the front on the left or top, the head on top. Of an oblique image, axes are named by the closest ones
 * of the patient. */
struct CutFrame
{
  /** In continuous indices. */
  CutPlane plane;
  /** "Axial", "Coronal" or "Sagittal". */
  std::string name;
  /** Of the axis across the plane: "x", "y" or "z", and where its middle is on it, in mm in the patient's frame. */
  std::string axis;
  double      place{ 0.0 };
  /** The layer of voxels. */
  long layer{ 0 };
  /** What is beyond the left, right, upper and lower side, as letters: R, L, A, P, S, I. */
  std::array<char, 4> sides{ { ' ', ' ', ' ', ' ' } };

  /** What is drawn: the continuous indices of the upper left corner; units per voxel to the right and downwards, each
   * positive or negative; width and height in units; and a unit in mm, a hundredth of the smallest spacing. */
  PlanarPoint origin{ { 0.0, 0.0 } };
  PlanarPoint scale{ { 1.0, 1.0 } };
  SvgPoint    size{ { 0, 0 } };
  double      unit{ 0.01 };
  /** Of a voxel in the plane, in mm^2. */
  double voxelArea{ 1.0 };

  /** A point of the cut in the drawing. */
  SvgPoint
  ToDrawing(const PlanarPoint & point) const;
};

/** Axial, coronal and sagittal cuts through the middle of the box that these points fill, each through the centers of
 * a layer of voxels.
 *
 * \param points in continuous indices of the image; at least one */
std::array<CutFrame, 3>
MakeCutFrames(const itk::ImageBase<3> & image, const std::vector<Vector> & points);

/** The points of a mesh in continuous indices of an image. */
template <typename TMesh>
std::vector<Vector>
ToContinuousIndices(const TMesh & mesh, const itk::ImageBase<3> & image);

extern template std::vector<Vector>
ToContinuousIndices(const itk::LabelTetrahedralMesh & mesh, const itk::ImageBase<3> & image);
extern template std::vector<Vector>
ToContinuousIndices(const itk::LabelInterfaceMesh & mesh, const itk::ImageBase<3> & image);
} // namespace mmm

#endif
