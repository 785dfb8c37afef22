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
// Meshes a label image with CGAL Mesh_3 and says how long it took. See README.md.

#include "CGALMesh3Image.h"
#include "CGALMesh3Options.h"
#include "CGALMesh3Output.h"

#include "itkImageFileReader.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Mesh_3/generate_label_weights.h>
#include <CGAL/Mesh_3/initialize_triangulation_from_labeled_image.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/make_mesh_3.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#ifndef _WIN32
#  include <sys/resource.h>
#endif

namespace
{
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Domain = CGAL::Labeled_mesh_domain_3<Kernel>;
using Triangulation = CGAL::Mesh_triangulation_3<Domain>::type;
using Complex = CGAL::Mesh_complex_3_in_triangulation_3<Triangulation>;
using Criteria = CGAL::Mesh_criteria_3<Triangulation>;

/** Runs a stage and prints its wall time. */
template <typename TStage>
void
Time(const char * name, const TStage & stage)
{
  const auto start = std::chrono::steady_clock::now();
  stage();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  std::cout << name << " [s]: " << elapsed.count() << std::endl;
}

void
PrintPeakMemory()
{
#ifndef _WIN32
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
#  ifdef __APPLE__
  constexpr double unit = 1.0;
#  else
  constexpr double unit = 1024.0;
#  endif
  std::cout << "peak memory [MiB]: " << usage.ru_maxrss * unit / (1024.0 * 1024.0) << std::endl;
#endif
}

/** CGAL's own initial points lie on a few rays from the middle of the image: what they miss is found by chance only. */
void
SeedComponents(Complex & mesh, const Domain & domain, const CGAL::Image_3 & image, const Criteria & criteria)
{
  CGAL_IMAGE_IO_CASE(image.image(), initialize_triangulation_from_labeled_image(mesh, domain, image, criteria, Word()));
}

void
Run(const CGALMesh3Options & options)
{
  namespace parameters = CGAL::parameters;

  const auto reader = itk::ImageFileReader<LabelImage>::New();
  reader->SetFileName(options.labelsFile);
  reader->Update();
  const LabelImage & labels = *reader->GetOutput();

  // The domain keeps references to both images.
  const CGAL::Image_3 image = ToCGALImage(labels);
  CGAL::Image_3       weights;
  if (options.weights)
  {
    const double sigma = std::max({ image.vx(), image.vy(), image.vz() });
    Time("weights", [&] { weights = CGAL::Mesh_3::generate_label_weights(image, sigma); });
  }
  const Domain domain = Domain::create_labeled_image_mesh_domain(
    image, parameters::weights = weights, parameters::relative_error_bound = 1e-6);
  const Criteria criteria(parameters::facet_angle = options.facetAngle,
                          parameters::facet_size = options.facetSize,
                          parameters::facet_distance = options.facetDistance,
                          parameters::cell_radius_edge_ratio = options.cellRadiusEdge,
                          parameters::cell_size = options.cellSize);
  Complex        mesh;
  Time("refine", [&] {
    if (options.seedComponents)
    {
      SeedComponents(mesh, domain, image, criteria);
      CGAL::refine_mesh_3(mesh, domain, criteria, parameters::no_perturb(), parameters::no_exude());
    }
    else
    {
      mesh = CGAL::make_mesh_3<Complex>(domain, criteria, parameters::no_perturb(), parameters::no_exude());
    }
  });
  if (options.perturbSeconds > 0.0)
  {
    Time("perturb", [&] { CGAL::perturb_mesh_3(mesh, domain, parameters::time_limit = options.perturbSeconds); });
  }
  if (options.exudeSeconds > 0.0)
  {
    Time("exude", [&] { CGAL::exude_mesh_3(mesh, parameters::time_limit = options.exudeSeconds); });
  }
  std::cout << "tetrahedra: " << mesh.number_of_cells_in_complex() << std::endl;
  std::cout << "interface triangles: " << mesh.number_of_facets_in_complex() << std::endl;
  // Before the conversion for output, which is not CGAL's.
  PrintPeakMemory();
  WriteTetrahedra(mesh, labels, options.meshFile);
}
} // namespace

int
main(int argc, char * argv[])
{
  try
  {
    Run(ParseCGALMesh3Options(argc, argv));
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
