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
#ifndef mmmVTUFormat_h
#define mmmVTUFormat_h

#include "io/ComponentType.h"

#include <cstddef>
#include <cstdint>
#include <string>

namespace mmm
{
/** The type attribute for a component type, for instance "Int32". Long doubles are stored as Float64. */
std::string
VTUTypeName(itk::IOComponentEnum type);

/** The component type for a type attribute; throws if there is none. */
itk::IOComponentEnum
ComponentTypeOfVTU(const std::string & typeName);

/** A cell type that both ITK and VTK have; their points are in the same order. */
struct VTUCellType
{
  std::uint8_t          vtkType;
  itk::CellGeometryEnum itkType;
  std::size_t           minimumPoints;
  std::size_t           maximumPoints;
};

/** The VTK type of an ITK cell with that many points; throws if there is none. */
std::uint8_t
VTKCellType(std::int64_t itkType, std::size_t numberOfPoints);

/** The ITK type for a VTK type, as itk::MeshFileReader takes it, with poly-vertices as vertices and polylines as lines;
 * throws if there is none. */
const VTUCellType &
ITKCellType(std::int64_t vtkType);

/** For messages: "tetrahedron (VTK cell type 10)". */
std::string
VTKCellTypeName(std::int64_t vtkType);
} // namespace mmm

#endif
