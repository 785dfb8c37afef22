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
#ifndef mmmTetGenTermination_h
#define mmmTetGenTermination_h

namespace mmm
{
/** Thrown where an assertion of TetGen fails. */
struct TetGenAssertion
{
  const char * words;
};

/** While it lives, TetGen's ways to end the program are exceptions in this thread: a code (int), or TetGenAssertion.
 * Its use also links the replacements, from a static library too. */
class TetGenGuard
{
public:
  TetGenGuard();
  ~TetGenGuard();
  TetGenGuard(const TetGenGuard &) = delete;
  TetGenGuard &
  operator=(const TetGenGuard &) = delete;
};
} // namespace mmm

#endif
