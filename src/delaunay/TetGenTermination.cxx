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
#include "delaunay/TetGenTermination.h"

#include <cstdio>
#include <cstdlib>

class tetgenmesh;

// visible to the dynamic linker even where the module is a static library, whose other symbols are hidden
#if defined(__GNUC__)
#  define MMM_TETGEN_TERMINATION_EXPORT __attribute__((visibility("default")))
#else
#  define MMM_TETGEN_TERMINATION_EXPORT
#endif

/** What TetGen 1.5 calls when it gives up. Its own frees the mesh and throws, whereupon the mesh's destructor frees it
 * again, and the program crashes. This one, which the dynamic linker finds first, leaves the memory to the destructor.
 */
MMM_TETGEN_TERMINATION_EXPORT void
terminatetetgen(tetgenmesh *, int code);

void
terminatetetgen(tetgenmesh *, int code)
{
  throw code;
}

namespace
{
thread_local bool inTetGen = false;
}

#ifdef __GLIBC__
/** Debian's TetGen is built with assertions, some of which fail on valid input. Within TetGen they become exceptions.
 */
extern "C" MMM_TETGEN_TERMINATION_EXPORT void
__assert_fail(const char * assertion, const char * file, unsigned int line, const char * function)
{
  if (inTetGen)
  {
    throw mmm::TetGenAssertion{ assertion };
  }
  std::fprintf(stderr, "%s:%u: %s: Assertion `%s' failed.\n", file, line, function ? function : "", assertion);
  std::abort();
}
#endif

mmm::TetGenGuard::TetGenGuard() { inTetGen = true; }

mmm::TetGenGuard::~TetGenGuard() { inTetGen = false; }
