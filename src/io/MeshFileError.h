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
#ifndef mmmMeshFileError_h
#define mmmMeshFileError_h

#include <new>
#include <stdexcept>

namespace mmm
{
/** What is wrong with a file, or with a mesh that is to become one; the mesh IOs make an itk::ExceptionObject of it. */
class MeshFileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** Why a file was not read or written, in words. */
inline const char *
ReasonOf(const std::exception & error)
{
  return dynamic_cast<const std::bad_alloc *>(&error) || dynamic_cast<const std::length_error *>(&error)
           ? "not enough memory"
           : error.what();
}
} // namespace mmm

#endif
