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
#include "io/CellLabels.h"
#include "io/ComponentType.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

namespace mmm
{
namespace
{
using Labels = std::vector<std::int64_t>;

/** Whether a double or integer is one of 64 bits. */
template <typename T>
bool
IsLabel(T value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    // The smallest integer is a floating point number, the largest is not.
    constexpr auto limit = static_cast<T>(std::numeric_limits<std::int64_t>::min());
    return std::floor(value) == value && value >= limit && value < -limit;
  }
  else if constexpr (std::is_unsigned_v<T>)
  {
    return value <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  }
  else
  {
    return true;
  }
}

/** The labels that a name stands for; none if it is not of SetTags()'s form. */
Labels
ParseName(const std::string & name)
{
  const auto open = name.rfind(" (label ");
  if (open != std::string::npos && name.back() == ')')
  {
    return ParseName(name.substr(open + 2, name.size() - open - 3));
  }
  Labels            labels;
  const std::string prefixes[] = { "label ", "labels " };
  for (const std::string & prefix : prefixes)
  {
    if (name.compare(0, prefix.size(), prefix) != 0)
    {
      continue;
    }
    const char *       position = name.data() + prefix.size();
    const char * const end = name.data() + name.size();
    while (true)
    {
      std::int64_t label = 0;
      const auto   parsed = std::from_chars(position, end, label);
      if (parsed.ec != std::errc() || (parsed.ptr != end && *parsed.ptr != ' '))
      {
        return {};
      }
      labels.push_back(label);
      if (labels.size() > maximumLabelsOfACell)
      {
        return {};
      }
      if (parsed.ptr == end)
      {
        return labels;
      }
      position = parsed.ptr + 1;
    }
  }
  return labels;
}

/** What SetTags() calls the group of a cell: with the name that was given to its label if the tag is another number. */
std::string
NameOfNewGroup(const CellMesh & mesh, std::size_t cell, const Labels & labels)
{
  const std::string name = GroupName(labels.data(), labels.size());
  const auto        given = std::find_if(mesh.names.begin(), mesh.names.end(), [&](const auto & entry) {
    return labels.size() == 1 && entry.first.first == mesh.ShapeOf(cell).dimension && entry.first.second == labels[0];
  });
  return given == mesh.names.end() ? name : given->second + " (" + name + ')';
}

/** Gives numbers that are not taken yet. */
class TagSource
{
public:
  TagSource(std::set<int> taken, int lowest)
    : m_Taken(std::move(taken))
    , m_Next(std::max(lowest, 1))
  {
    if (!m_Taken.empty() && *m_Taken.rbegin() >= m_Next && *m_Taken.rbegin() < std::numeric_limits<int>::max() / 2)
    {
      m_Next = *m_Taken.rbegin() + 1;
    }
  }

  int
  Take()
  {
    while (m_Taken.count(m_Next) > 0)
    {
      ++m_Next;
    }
    return m_Next++;
  }

private:
  std::set<int> m_Taken;
  int           m_Next;
};
} // namespace

CellLabels
TakeLabels(const void * buffer, itk::IOComponentEnum type, std::size_t numberOfValues, std::size_t components)
{
  if (components == 0 || components > maximumLabelsOfACell)
  {
    throw MeshFileError("its cells have " + std::to_string(components) + " values each; labels are 1 to " +
                        std::to_string(maximumLabelsOfACell));
  }
  CellLabels labels{ components, {} };
  labels.values.reserve(numberOfValues);
  VisitComponentType(type, [&](auto zero) {
    const auto * const values = static_cast<const decltype(zero) *>(buffer);
    for (std::size_t i = 0; i < numberOfValues; ++i)
    {
      if (!IsLabel(values[i]))
      {
        throw MeshFileError("the value of its cell " + std::to_string(i / components) + " is " +
                            std::to_string(values[i]) + "; cells are grouped by labels, which are whole numbers");
      }
      labels.values.push_back(static_cast<std::int64_t>(values[i]));
    }
  });
  return labels;
}

std::string
GroupName(const std::int64_t * labels, std::size_t components)
{
  std::string name = components == 1 ? "label" : "labels";
  for (std::size_t i = 0; i < components; ++i)
  {
    name += ' ' + std::to_string(labels[i]);
  }
  return name;
}

std::vector<std::pair<std::string, int>>
SetTags(CellMesh & mesh, const CellLabels & labels, int lowestTag)
{
  const std::size_t     components = labels.components;
  std::map<Labels, int> tags;
  Labels                key;
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    const auto first = labels.values.begin() + i * components;
    // Neighbours in the list are often alike.
    if (!std::equal(key.begin(), key.end(), first, first + components))
    {
      key.assign(first, first + components);
      tags.emplace(key, 0);
    }
  }
  const auto isTag = [&](const Labels & one) {
    return one.size() == 1 && one[0] >= lowestTag && one[0] <= std::numeric_limits<int>::max();
  };
  std::set<int> taken;
  for (auto & [one, tag] : tags)
  {
    if (isTag(one))
    {
      tag = static_cast<int>(one[0]);
      taken.insert(tag);
    }
  }
  TagSource                                source(taken, lowestTag);
  std::vector<std::pair<std::string, int>> numbered;
  for (auto & [one, tag] : tags)
  {
    if (!isTag(one))
    {
      tag = source.Take();
      numbered.emplace_back(GroupName(one.data(), components), tag);
    }
  }
  mesh.tags.resize(mesh.shapes.size());
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    const auto first = labels.values.begin() + i * components;
    key.assign(first, first + components);
    mesh.tags[i] = tags.at(key);
    if (mesh.names.find(mesh.GroupOf(i)) == mesh.names.end())
    {
      mesh.names.emplace(mesh.GroupOf(i), NameOfNewGroup(mesh, i, key));
    }
  }
  return numbered;
}

CellLabels
GetLabels(const CellMesh & mesh)
{
  std::map<Group, Labels> groups;
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    groups.emplace(mesh.GroupOf(i), Labels{});
  }
  std::set<std::size_t> sizes;
  for (auto & [group, labels] : groups)
  {
    const auto name = mesh.names.find(group);
    labels = name == mesh.names.end() ? Labels{} : ParseName(name->second);
    sizes.insert(labels.size());
  }
  CellLabels result;
  result.components = sizes.size() == 1 && *sizes.begin() > 0 ? *sizes.begin() : 1;
  result.values.reserve(mesh.shapes.size() * result.components);
  for (std::size_t i = 0; i < mesh.shapes.size(); ++i)
  {
    const Group    group = mesh.GroupOf(i);
    const Labels & labels = groups.at(group);
    if (labels.size() == result.components)
    {
      result.values.insert(result.values.end(), labels.begin(), labels.end());
    }
    else
    {
      result.values.push_back(group.second);
    }
  }
  return result;
}
} // namespace mmm
