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
#ifndef mmmComponentType_h
#define mmmComponentType_h

#include "io/MeshFileError.h"

#include "itkCommonEnums.h"

namespace mmm
{
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
      throw MeshFileError("its values are of an unknown type");
  }
}
} // namespace mmm

#endif
