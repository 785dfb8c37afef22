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
#ifndef mmmPythonReports_h
#define mmmPythonReports_h

// SWIG has included Python.h.

#include "MultiMaterialMeshingLabels.h"
#include "MultiMaterialMeshingOptions.h"
#include "MultiMaterialMeshingQuality.h"
#include "MultiMaterialMeshingReports.h"
#include "itkElectrodes.h"

#include <array>
#include <cstddef>
#include <initializer_list>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/** What filters and calculators report, as plain Python objects: numbers, strings, lists, dictionaries, and namespaces
 * for structures. They are copies. SWIG's own conversion would hand out pointers into objects that may be gone.
 *
 * Each function returns a new reference, or a null pointer with a Python error set. */
namespace mmm
{
inline PyObject *
ToPython(double value)
{
  return PyFloat_FromDouble(value);
}

inline PyObject *
ToPython(int value)
{
  return PyLong_FromLong(value);
}

inline PyObject *
ToPython(std::size_t value)
{
  return PyLong_FromSize_t(value);
}

inline PyObject *
ToPython(const std::string & value)
{
  return PyUnicode_FromStringAndSize(value.data(), static_cast<Py_ssize_t>(value.size()));
}

/** Adds a new reference to a dictionary. */
inline bool
AddToDictionary(PyObject * dictionary, PyObject * key, PyObject * value)
{
  const bool isAdded = key != nullptr && value != nullptr && PyDict_SetItem(dictionary, key, value) == 0;
  Py_XDECREF(key);
  Py_XDECREF(value);
  return isAdded;
}

template <typename TContainer>
PyObject *
ToPythonList(const TContainer & values)
{
  PyObject * list = PyList_New(static_cast<Py_ssize_t>(values.size()));
  Py_ssize_t place = 0;
  for (const auto & value : values)
  {
    PyObject * item = list ? ToPython(value) : nullptr;
    if (item == nullptr)
    {
      Py_XDECREF(list);
      return nullptr;
    }
    PyList_SetItem(list, place++, item);
  }
  return list;
}

template <typename T>
PyObject *
ToPython(const std::vector<T> & values)
{
  return ToPythonList(values);
}

template <typename T, std::size_t VSize>
PyObject *
ToPython(const std::array<T, VSize> & values)
{
  return ToPythonList(values);
}

template <typename T>
PyObject *
ToPython(const std::map<int, T> & values)
{
  PyObject * dictionary = PyDict_New();
  for (const auto & value : values)
  {
    if (dictionary == nullptr || !AddToDictionary(dictionary, ToPython(value.first), ToPython(value.second)))
    {
      Py_XDECREF(dictionary);
      return nullptr;
    }
  }
  return dictionary;
}

/** A types.SimpleNamespace; takes the references over. */
inline PyObject *
MakeNamespace(std::initializer_list<std::pair<const char *, PyObject *>> members)
{
  PyObject * dictionary = PyDict_New();
  bool       isComplete = dictionary != nullptr;
  for (const auto & member : members)
  {
    isComplete = isComplete && AddToDictionary(dictionary, ToPython(std::string(member.first)), member.second);
  }
  PyObject * module = isComplete ? PyImport_ImportModule("types") : nullptr;
  PyObject * type = module ? PyObject_GetAttrString(module, "SimpleNamespace") : nullptr;
  PyObject * arguments = type ? PyTuple_New(0) : nullptr;
  PyObject * result = arguments ? PyObject_Call(type, arguments, dictionary) : nullptr;
  Py_XDECREF(arguments);
  Py_XDECREF(type);
  Py_XDECREF(module);
  Py_XDECREF(dictionary);
  return result;
}

inline PyObject *
ToPython(const LabelEntry & entry)
{
  PyObject * color = Py_None;
  if (entry.color)
  {
    color = ToPython(*entry.color);
  }
  else
  {
    Py_INCREF(color);
  }
  return MakeNamespace({ { "name", ToPython(entry.name) }, { "color", color } });
}

inline PyObject *
ToPython(const ElectrodeReport & report)
{
  const std::array<double, 3> position{ { report.position[0], report.position[1], report.position[2] } };
  return MakeNamespace({ { "name", ToPython(report.name) },
                         { "label", ToPython(report.label) },
                         { "position", ToPython(position) },
                         { "projection", ToPython(report.projection) },
                         { "contact_area", ToPython(report.contactArea) },
                         { "expected_area", ToPython(report.expectedArea) },
                         { "gel_contact_area", ToPython(report.gelContactArea) },
                         { "expected_gel_area", ToPython(report.expectedGelArea) },
                         { "covered", ToPython(report.covered) } });
}

inline PyObject *
ToPython(const StageRecord & record)
{
  return MakeNamespace({ { "name", ToPython(record.name) },
                         { "seconds", ToPython(record.seconds) },
                         { "peak_memory", ToPython(record.peakMemory) } });
}

inline PyObject *
ToPython(const IslandRecord & record)
{
  return MakeNamespace({ { "components", ToPython(record.components) },
                         { "voxels", ToPython(record.voxels) },
                         { "destinations", ToPython(record.destinations) },
                         { "voxels_before", ToPython(record.voxelsBefore) },
                         { "voxels_after", ToPython(record.voxelsAfter) } });
}

inline PyObject *
ToPython(const MeshEstimate & estimate)
{
  return MakeNamespace({ { "triangles", ToPython(estimate.triangles) },
                         { "points", ToPython(estimate.points) },
                         { "tetrahedra", ToPython(estimate.tetrahedra) },
                         { "memory", ToPython(estimate.memory) } });
}

inline PyObject *
ToPython(const SizeRule & rule)
{
  return MakeNamespace({ { "factor", ToPython(rule.factor) },
                         { "minimum_size", ToPython(rule.minimumSize) },
                         { "maximum_size", ToPython(rule.maximumSize) } });
}

inline PyObject *
ToPython(const CurvingReport & report)
{
  return MakeNamespace({ { "edges", ToPython(report.edges) },
                         { "without_place", ToPython(report.withoutPlace) },
                         { "inverting", ToPython(report.inverting) },
                         { "smallest_jacobian", ToPython(report.smallestJacobian) },
                         { "volumes", ToPython(report.volumes) } });
}

inline PyObject *
ToPython(const MeshingReport & report)
{
  return MakeNamespace({ { "estimate", ToPython(report.estimate) },
                         { "curving", ToPython(report.curving) },
                         { "particles", ToPython(report.particles) },
                         { "unused_particles", ToPython(report.unusedParticles) },
                         { "points_left_out", ToPython(report.pointsLeftOut) },
                         { "steiner_points", ToPython(report.steinerPoints) } });
}

inline PyObject *
ToPython(const Distribution & distribution)
{
  return MakeNamespace({ { "average", ToPython(distribution.average) },
                         { "minimum", ToPython(distribution.minimum) },
                         { "first_percentile", ToPython(distribution.firstPercentile) } });
}

inline PyObject *
ToPython(const TetrahedronStatistics & statistics)
{
  return MakeNamespace({ { "count", ToPython(statistics.count) },
                         { "volume", ToPython(statistics.volume) },
                         { "largest_volume", ToPython(statistics.largestVolume) },
                         { "non_positive", ToPython(statistics.nonPositive) },
                         { "radius_ratio", ToPython(statistics.radiusRatio) },
                         { "smallest_angle", ToPython(statistics.smallestAngle) },
                         { "largest_angle", ToPython(statistics.largestAngle) },
                         { "below", ToPython(statistics.below) },
                         { "above", ToPython(statistics.above) } });
}

inline PyObject *
ToPython(const LabelQuality & quality)
{
  return MakeNamespace({ { "label", ToPython(quality.label) },
                         { "tetrahedra", ToPython(quality.tetrahedra) },
                         { "components", ToPython(quality.components) },
                         { "boundary_faces", ToPython(quality.boundaryFaces) },
                         { "open_edges", ToPython(quality.openEdges) },
                         { "non_manifold_edges", ToPython(quality.nonManifoldEdges) } });
}

inline PyObject *
ToPython(const PoorTetrahedron & tetrahedron)
{
  const std::array<double, 3> center{ { tetrahedron.center[0], tetrahedron.center[1], tetrahedron.center[2] } };
  return MakeNamespace({ { "index", ToPython(tetrahedron.index) },
                         { "label", ToPython(tetrahedron.label) },
                         { "place", ToPython(std::string(ToString(tetrahedron.GetPlace()))) },
                         { "center", ToPython(center) },
                         { "smallest_angle", ToPython(tetrahedron.smallestAngle) },
                         { "largest_angle", ToPython(tetrahedron.largestAngle) } });
}

inline PyObject *
ToPython(const MeshQualityReport & report)
{
  std::ostringstream table;
  table << report;
  return MakeNamespace({ { "tetrahedra", ToPython(report.tetrahedra) },
                         { "labels", ToPython(report.labels) },
                         { "interface_triangles", ToPython(report.interfaceTriangles) },
                         { "interface_radius_ratio", ToPython(report.interfaceRadiusRatio) },
                         { "points", ToPython(report.points) },
                         { "unused_points", ToPython(report.unusedPoints) },
                         { "duplicate_points", ToPython(report.duplicatePoints) },
                         { "overused_faces", ToPython(report.overusedFaces) },
                         { "open_edges", ToPython(report.openEdges) },
                         { "non_manifold_edges", ToPython(report.nonManifoldEdges) },
                         { "poor_tetrahedra", ToPython(report.poorTetrahedra) },
                         { "poorest", ToPython(report.poorest) },
                         { "table", ToPython(table.str()) } });
}
} // namespace mmm

#endif
