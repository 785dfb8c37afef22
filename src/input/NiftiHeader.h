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
#ifndef mmmNiftiHeader_h
#define mmmNiftiHeader_h

#include "input/Affine.h"

#include <cstdint>
#include <string>
#include <vector>

namespace mmm
{
/** \brief What the header of a NIfTI file says, version 1 or 2, of either byte order. */
struct NiftiHeader
{
  bool isSwapped{ false };
  /** The voxels are in a file of their own, ".img". */
  bool                      isPair{ false };
  std::vector<std::int64_t> size;
  int                       dataType{ 0 };
  /** What the numbers are; 1005 is a symmetric matrix. */
  int    intent{ 0 };
  double dataOffset{ 0.0 };
  double slope{ 0.0 };
  double intercept{ 0.0 };
  int    unit{ 0 };
  double pixdim[4]{};
  int    qformCode{ 0 };
  double quaternion[3]{};
  double qoffset[3]{};
  int    sformCode{ 0 };
  double sform[3][4]{};

  /** Whether stored values stand for others. */
  bool
  IsScaled() const;
};

/** From the first bytes of a file, 540 if there are so many. False if it is not one of NIfTI. */
bool
ParseNiftiHeader(const std::vector<char> & bytes, NiftiHeader & header);

/** \brief Where the header puts the voxels: by its sform if that is set, else by its qform, as nibabel does, else by
 * the sizes of voxels alone.
 *
 * Throws itk::ExceptionObject if there is no usable form. `notes` gets what the user should know of a doubtful header.
 */
Affine
PlaceOf(const NiftiHeader & header, std::vector<std::string> & notes);
} // namespace mmm

#endif
