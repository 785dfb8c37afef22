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
#ifndef NiftiCheck_h
#define NiftiCheck_h

#include <string>

namespace cli
{
/** \brief What is wrong with a file named .nii or .nii.gz; empty if it is whole, or another kind of file.
 *
 * ITK reads such files without a word when their end is missing or the compressed data is damaged; the rest of the
 * image then is zero. */
std::string
FindNiftiDamage(const std::string & fileName);
} // namespace cli

#endif
