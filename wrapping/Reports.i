// The plain structures that filters and calculators report, as far as Python knows their types; see their headers.
namespace mmm
{
struct StageRecord
{
  std::string name;
  double      seconds;
  double      peakMemory;
};

struct IslandRecord
{
  size_t                components;
  size_t                voxels;
  std::map<int, size_t> destinations;
  size_t                voxelsBefore;
  size_t                voxelsAfter;
};

struct Distribution
{
  double average;
  double minimum;
  double firstPercentile;
};

struct TetrahedronStatistics
{
  size_t       count;
  double       volume;
  size_t       nonPositive;
  Distribution radiusRatio;
  Distribution smallestAngle;
  double       largestAngle;
};

struct LabelQuality
{
  int                   label;
  TetrahedronStatistics tetrahedra;
  size_t                components;
  size_t                boundaryFaces;
  size_t                openEdges;
  size_t                nonManifoldEdges;
};

struct MeshQualityReport
{
  TetrahedronStatistics     tetrahedra;
  std::vector<LabelQuality> labels;
  size_t                    interfaceTriangles;
  Distribution              interfaceRadiusRatio;
  size_t                    points;
  size_t                    unusedPoints;
  size_t                    duplicatePoints;
  size_t                    overusedFaces;
  size_t                    openEdges;
  size_t                    nonManifoldEdges;
  size_t                    poorTetrahedra;
};
} // namespace mmm

%template(vectormmmStageRecord) std::vector<mmm::StageRecord>;
%template(vectormmmLabelQuality) std::vector<mmm::LabelQuality>;
%template(mapSImmmIslandRecord) std::map<int, mmm::IslandRecord>;
%extend mmm::MeshQualityReport {
  std::string __str__()
  {
    std::ostringstream text;
    text << *self;
    return text.str();
  }
}
