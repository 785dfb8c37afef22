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

#include "itkCommonEnums.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>

namespace mmm
{
/** What is wrong with a file, or with a mesh that is to become one; VTUMeshIO makes an itk::ExceptionObject of it. */
class VTUError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Returns visitor(T{}), T being the C++ type that `type` stands for. */
template <typename TVisitor>
auto
VisitComponentType(itk::IOComponentEnum type, TVisitor && visitor)
{
  using Type = itk::IOComponentEnum;
  switch (type)
  {
    case Type::UCHAR:
      return visitor(static_cast<unsigned char>(0));
    case Type::CHAR:
      return visitor(static_cast<char>(0));
    case Type::USHORT:
      return visitor(static_cast<unsigned short>(0));
    case Type::SHORT:
      return visitor(static_cast<short>(0));
    case Type::UINT:
      return visitor(0u);
    case Type::INT:
      return visitor(0);
    case Type::ULONG:
      return visitor(0ul);
    case Type::LONG:
      return visitor(0l);
    case Type::ULONGLONG:
      return visitor(0ull);
    case Type::LONGLONG:
      return visitor(0ll);
    case Type::FLOAT:
      return visitor(0.0f);
    case Type::DOUBLE:
      return visitor(0.0);
    case Type::LDOUBLE:
      return visitor(0.0l);
    default:
      throw VTUError("its values are of a type that .vtu files have no name for");
  }
}

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

/** The ITK type for a VTK type, with poly-vertices as vertices and polylines as lines; throws if there is none. */
const VTUCellType &
ITKCellType(std::int64_t vtkType);

/** For messages: "tetrahedron (VTK cell type 10)". */
std::string
VTKCellTypeName(std::int64_t vtkType);
} // namespace mmm

#endif
