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
#ifndef mmmGmshReader4_h
#define mmmGmshReader4_h

#include "io/gmsh/GmshReader.h"

#include <map>
#include <utility>

namespace mmm
{
/** \brief The sections of version 4.1. Cells belong to entities, and these to physical groups. */
class GmshReader4 : public GmshReader
{
public:
  GmshReader4(FileCursor & cursor, CellMesh & mesh)
    : GmshReader(cursor, mesh)
  {}

protected:
  void
  ReadEntities() override;
  void
  ReadNodes() override;
  void
  ReadElements() override;

private:
  void
  ReadEntity(int dimension);

  /** The first physical group of an entity, by its dimension and tag. */
  std::map<std::pair<int, int>, int> m_Groups;
};
} // namespace mmm

#endif
