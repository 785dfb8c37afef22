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
#ifndef TestNifti_h
#define TestNifti_h

#include "itk_zlib.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string>
#include <vector>

/** \brief A NIfTI-1 file byte by byte: 6 x 5 x 4 voxels of 1, 2 and 3 mm, label 7 in one voxel and 0 elsewhere. */
class TestNifti
{
public:
  static constexpr int Size[3] = { 6, 5, 4 };
  static constexpr int Labelled[3] = { 4, 2, 1 };

  TestNifti()
    : bytes(352)
  {
    this->Set<std::int32_t>(0, 348);
    const std::int16_t dim[8] = { 3, 6, 5, 4, 1, 1, 1, 1 };
    for (int d = 0; d < 8; ++d)
    {
      this->Set<std::int16_t>(40 + 2 * d, dim[d]);
    }
    this->SetFloats(76, { 1, 1, 2, 3 });
    this->Set<float>(108, 352);
    this->Set<char>(123, 2);
    this->SetSform({ -1, 0, 0, 10, 0, -2, 0, 20, 0, 0, 3, 30 });
    std::copy_n("n+1", 4, bytes.begin() + 344);
    this->SetVoxels<std::int16_t>(4, 7, 0);
  }

  template <typename T>
  void
  Set(std::size_t offset, T value)
  {
    std::memcpy(bytes.data() + offset, &value, sizeof value);
  }

  void
  SetFloats(std::size_t offset, const std::vector<float> & values)
  {
    for (std::size_t n = 0; n < values.size(); ++n)
    {
      this->Set<float>(offset + 4 * n, values[n]);
    }
  }

  /** Rows of four numbers. */
  void
  SetSform(const std::vector<float> & rows)
  {
    this->Set<std::int16_t>(254, 1);
    this->SetFloats(280, rows);
  }

  void
  SetQform(const std::vector<float> & quaternion, const std::vector<float> & offset)
  {
    this->Set<std::int16_t>(252, 1);
    this->SetFloats(256, quaternion);
    this->SetFloats(268, offset);
  }

  void
  RemoveSform()
  {
    this->Set<std::int16_t>(254, 0);
  }

  /** A type by its number, and the value of the labelled voxel and of all others. */
  template <typename T>
  void
  SetVoxels(int type, T labelled, T others)
  {
    this->Set<std::int16_t>(70, std::int16_t(type));
    this->Set<std::int16_t>(72, std::int16_t(8 * sizeof(T)));
    bytes.resize(352 + sizeof(T) * 6 * 5 * 4);
    for (std::size_t n = 0; n < 6 * 5 * 4; ++n)
    {
      this->Set<T>(352 + sizeof(T) * n, n == (1 * 5 + 2) * 6 + 4 ? labelled : others);
    }
  }

  /** Compressed if the name ends with ".gz". */
  void
  Write(const std::string & fileName) const
  {
    if (fileName.size() > 3 && fileName.compare(fileName.size() - 3, 3, ".gz") == 0)
    {
      const gzFile file = gzopen(fileName.c_str(), "wb");
      gzwrite(file, bytes.data(), unsigned(bytes.size()));
      gzclose(file);
      return;
    }
    std::ofstream(fileName, std::ios::binary).write(bytes.data(), std::streamsize(bytes.size()));
  }

  std::vector<char> bytes;
};

#endif
