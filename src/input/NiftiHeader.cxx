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
#include "input/NiftiHeader.h"

#include "itkMacro.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <sstream>

namespace mmm
{
namespace
{
/** Reads numbers of either byte order. */
class HeaderBytes
{
public:
  HeaderBytes(const std::vector<char> & bytes, bool isSwapped)
    : m_Bytes(bytes)
    , m_IsSwapped(isSwapped)
  {}

  template <typename T>
  T
  Get(std::size_t offset) const
  {
    char bytes[sizeof(T)];
    std::copy_n(m_Bytes.begin() + static_cast<std::ptrdiff_t>(offset), sizeof(T), bytes);
    if (m_IsSwapped)
    {
      std::reverse(bytes, bytes + sizeof(T));
    }
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

  template <typename T>
  void
  GetAll(std::size_t offset, double * first, int count) const
  {
    for (int n = 0; n < count; ++n)
    {
      first[n] = static_cast<double>(this->Get<T>(offset + static_cast<std::size_t>(n) * sizeof(T)));
    }
  }

private:
  const std::vector<char> & m_Bytes;
  bool                      m_IsSwapped;
};

template <typename T>
bool
GetSize(const HeaderBytes & bytes, std::size_t offset, std::vector<std::int64_t> & size)
{
  const auto dimensions = static_cast<std::int64_t>(bytes.Get<T>(offset));
  if (dimensions < 1 || dimensions > 7)
  {
    return false;
  }
  for (std::int64_t d = 1; d <= dimensions; ++d)
  {
    size.push_back(static_cast<std::int64_t>(bytes.Get<T>(offset + static_cast<std::size_t>(d) * sizeof(T))));
  }
  return true;
}

bool
ParseVersion1(const HeaderBytes & bytes, NiftiHeader & header)
{
  if (!GetSize<std::int16_t>(bytes, 40, header.size))
  {
    return false;
  }
  header.intent = bytes.Get<std::int16_t>(68);
  header.dataType = bytes.Get<std::int16_t>(70);
  bytes.GetAll<float>(76, header.pixdim, 4);
  bytes.GetAll<float>(108, &header.dataOffset, 1);
  bytes.GetAll<float>(112, &header.slope, 1);
  bytes.GetAll<float>(116, &header.intercept, 1);
  header.unit = bytes.Get<std::uint8_t>(123);
  header.qformCode = bytes.Get<std::int16_t>(252);
  header.sformCode = bytes.Get<std::int16_t>(254);
  bytes.GetAll<float>(256, header.quaternion, 3);
  bytes.GetAll<float>(268, header.qoffset, 3);
  bytes.GetAll<float>(280, header.sform[0], 12);
  return true;
}

bool
ParseVersion2(const HeaderBytes & bytes, NiftiHeader & header)
{
  if (!GetSize<std::int64_t>(bytes, 16, header.size))
  {
    return false;
  }
  header.intent = bytes.Get<std::int32_t>(504);
  header.dataType = bytes.Get<std::int16_t>(12);
  bytes.GetAll<double>(104, header.pixdim, 4);
  bytes.GetAll<std::int64_t>(168, &header.dataOffset, 1);
  bytes.GetAll<double>(176, &header.slope, 1);
  bytes.GetAll<double>(184, &header.intercept, 1);
  header.qformCode = bytes.Get<std::int32_t>(344);
  header.sformCode = bytes.Get<std::int32_t>(348);
  bytes.GetAll<double>(352, header.quaternion, 3);
  bytes.GetAll<double>(376, header.qoffset, 3);
  bytes.GetAll<double>(400, header.sform[0], 12);
  header.unit = bytes.Get<std::int32_t>(500);
  return true;
}

Affine
SformOf(const NiftiHeader & header)
{
  Affine affine;
  for (unsigned int row = 0; row < 3; ++row)
  {
    affine.origin[row] = header.sform[row][3];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      affine.steps[axis][row] = header.sform[row][axis];
    }
  }
  return affine;
}

/** The voxels' sizes along the axes, without rotation and offset. */
Affine
SizesOf(const NiftiHeader & header)
{
  Affine affine;
  affine.origin.Fill(0.0);
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    affine.steps[axis].Fill(0.0);
    affine.steps[axis][axis] = std::abs(header.pixdim[axis + 1]);
  }
  return affine;
}

Affine
QformOf(const NiftiHeader & header)
{
  double       b = header.quaternion[0];
  double       c = header.quaternion[1];
  double       d = header.quaternion[2];
  double       a = 0.0;
  const double rest = 1.0 - (b * b + c * c + d * d);
  // half a turn, up to the rounding of single precision
  if (rest < 1e-7)
  {
    const double length = std::sqrt(b * b + c * c + d * d);
    b /= length;
    c /= length;
    d /= length;
  }
  else
  {
    a = std::sqrt(rest);
  }
  const double rotation[3][3] = {
    { a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c) },
    { 2.0 * (b * c + a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d - a * b) },
    { 2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a + d * d - c * c - b * b },
  };
  const double sizes[3] = { std::abs(header.pixdim[1]),
                            std::abs(header.pixdim[2]),
                            std::abs(header.pixdim[3]) * (header.pixdim[0] < 0.0 ? -1.0 : 1.0) };
  Affine       affine;
  for (unsigned int row = 0; row < 3; ++row)
  {
    affine.origin[row] = header.qoffset[row];
    for (unsigned int axis = 0; axis < 3; ++axis)
    {
      affine.steps[axis][row] = rotation[row][axis] * sizes[axis];
    }
  }
  return affine;
}

/** The header's unit of length in mm. */
double
UnitOf(const NiftiHeader & header, std::vector<std::string> & notes)
{
  // the other bits are a unit of time
  switch (header.unit & 7)
  {
    case 0:
    case 2:
      return 1.0;
    case 1:
      notes.emplace_back("its unit is the meter (xyzt_units); the mesh is in mm");
      return 1000.0;
    case 3:
      notes.emplace_back("its unit is the micrometer (xyzt_units); the mesh is in mm");
      return 0.001;
    default:
      notes.emplace_back("its unit of length is unknown (xyzt_units); it is taken for mm");
      return 1.0;
  }
}

itk::Size<3>
SpatialSizeOf(const NiftiHeader & header)
{
  itk::Size<3> size{ { 1, 1, 1 } };
  for (std::size_t d = 0; d < std::min<std::size_t>(3, header.size.size()); ++d)
  {
    size[static_cast<unsigned int>(d)] = static_cast<itk::SizeValueType>(header.size[d]);
  }
  return size;
}
} // namespace

bool
NiftiHeader::IsScaled() const
{
  return std::isfinite(slope) && slope != 0.0 && std::isfinite(intercept) && (slope != 1.0 || intercept != 0.0);
}

bool
ParseNiftiHeader(const std::vector<char> & bytes, NiftiHeader & header)
{
  constexpr std::size_t size1 = 348;
  constexpr std::size_t size2 = 540;
  if (bytes.size() < size1)
  {
    return false;
  }
  const auto hasMagic = [&](std::size_t place, char version) {
    header.isPair = bytes[place + 1] == 'i';
    return bytes[place] == 'n' && (bytes[place + 1] == '+' || bytes[place + 1] == 'i') && bytes[place + 2] == version;
  };
  for (const bool isSwapped : { false, true })
  {
    const HeaderBytes reader(bytes, isSwapped);
    header.isSwapped = isSwapped;
    const auto size = reader.Get<std::int32_t>(0);
    if (size == static_cast<std::int32_t>(size1) && hasMagic(344, '1'))
    {
      return ParseVersion1(reader, header);
    }
    if (size == static_cast<std::int32_t>(size2) && bytes.size() >= size2 && hasMagic(4, '2'))
    {
      return ParseVersion2(reader, header);
    }
  }
  return false;
}

Affine
PlaceOf(const NiftiHeader & header, std::vector<std::string> & notes)
{
  const double      unit = UnitOf(header, notes);
  const Affine      sform = SformOf(header);
  const Affine      qform = QformOf(header);
  const std::string sformFault = header.sformCode > 0 ? FindFault(sform) : "it has no sform";
  const std::string qformFault = header.qformCode > 0 ? FindFault(qform) : "it has no qform";
  const bool        isNegative = header.pixdim[1] < 0.0 || header.pixdim[2] < 0.0 || header.pixdim[3] < 0.0;
  if (sformFault.empty())
  {
    const double distance = qformFault.empty() ? LargestDistance(sform, qform, SpatialSizeOf(header)) : 0.0;
    const double smallest = std::min({ sform.steps[0].GetNorm(), sform.steps[1].GetNorm(), sform.steps[2].GetNorm() });
    // less is rounding of the header's numbers
    constexpr double tolerance = 0.05;
    if (distance > tolerance * smallest)
    {
      std::ostringstream note;
      note << "its sform and qform differ, by up to " << distance * unit << " mm; the mesh is where the sform puts it";
      notes.push_back(note.str());
    }
    return FromRAS(sform, unit);
  }
  if (isNegative)
  {
    notes.emplace_back("a spacing is negative (pixdim); its size is taken");
  }
  if (qformFault.empty())
  {
    if (header.sformCode > 0)
    {
      notes.push_back("its sform is of no use, as " + sformFault + "; the mesh is where the qform puts it");
    }
    return FromRAS(qform, unit);
  }
  const Affine      sizes = SizesOf(header);
  const std::string sizesFault = FindFault(sizes);
  if (header.sformCode > 0 || header.qformCode > 0 || !sizesFault.empty())
  {
    const std::string fault = header.sformCode > 0   ? "in its sform, " + sformFault
                              : header.qformCode > 0 ? "in its qform and pixdim, " + qformFault
                                                     : "in its pixdim, " + sizesFault;
    itkGenericExceptionMacro(<< fault << "; correct the header first");
  }
  notes.emplace_back("it does not say where it lies (qform_code and sform_code are 0); the mesh has the spacing of its "
                     "voxels, and the first one is at the origin");
  return FromRAS(sizes, unit);
}
} // namespace mmm
